// SPDX-License-Identifier: MIT
#include "nodes/field_frames.h"

#include "core/base/cpu_clock.h"
#include "field/field_device.h"
#include "field/field_view.h"
#include "field/sun_map.h"
#include "shared/frames.h"
#include "shared/script_call.h"

#include <godot_cpp/classes/engine.hpp>

#include <utility>

using namespace godot;

namespace grass {

bool FieldFrames::needs_frame() const {
	static const bool are_drawn = draws_frames();
	return are_drawn || !_rests || _parts.life.is_waiting() || _parts.properties.is_other_quality() || _parts.sources.may_change();
}

bool FieldFrames::advance() {
	const uint64_t frame = Engine::get_singleton()->get_process_frames();
	if (std::exchange(_advanced_in, frame) == frame) {
		return _parts.host.stand();
	}
	if (_parts.properties.update_quality()) {
		_parts.standing.update_quality();
	}
	return _parts.life.advance();
}

void FieldFrames::frame(double p_delta) {
	_visited++;
	if (!_parts.node().is_inside_tree() || !advance()) {
		return;
	}
	bool has_finished = false;
	if (!_parts.sources.update_terrain() || !_parts.sources.update_fill(has_finished)) {
		return;
	}
	if (has_finished && !outlives(_parts.node(), [&] { _parts.node().emit_signal("fill_finished"); })) {
		return;
	}
	if (_parts.node().is_inside_tree() && _parts.standing.stands()) {
		_parts.forces.gather(_parts.properties.size);
		_parts.standing.get_picture().blow(
				_parts.forces.get(), p_delta); // before drawing begins: a change in before_draw() causes no further frame
	}
	_rests = _parts.life.rests() && _parts.sources.get_terrain().is_empty();
}

void FieldFrames::before_draw() {
	last_drawn_frame = Engine::get_singleton()->get_process_frames();
	if (advance() && _parts.standing.stands()) {
		draw();
	}
}

void FieldFrames::draw() {
	CpuClock clock;
	GeometryInstance3D &node = _parts.node();
	StandingField &standing = _parts.standing;
	_ticks.update_map();
	const Transform3D place = _parts.host.drawn_transform();
	const FieldView view = node.is_visible_in_tree() ? find_view(&node, place, _parts.properties, standing.get_field()) : FieldView();
	if (!view.cameras.empty()) {
		show_light();
	}
	standing.read_asked();
	if (view.has_motion) {
		expect_motion_vectors();
	}
	standing.show_between(node.is_physics_interpolated_and_enabled(), _ticks.find_share());
	standing.get_picture().show_motion(view.has_motion);
	standing.get_picture().follow(&node, place);
	if (standing.draw(view, node.is_visible_in_tree())) {
		warn_once(crowded_warning(standing.get_field().get_setup()));
	}
	if (standing.notice_blind_budget()) {
		warn_once(blind_warning());
	}
	_ms = clock.lap();
}

void FieldFrames::show_light() {
	_parts.standing.get_picture().show_suns(find_sun_map(&_parts.node()));
	if (is_compatibility()) {
		_parts.standing.get_picture().show_light(_other_light.find(&_parts.node()));
	}
}

// Prints a warning once. In the editor the node itself shows its warnings.
void FieldFrames::warn_once(const String &p_warning) {
	_parts.host.show_warnings();
	if (!Engine::get_singleton()->is_editor_hint()) {
		_parts.host.warn(p_warning);
	}
}

void FieldFrames::add_to(FieldStatistics &r_statistics) const {
	r_statistics.visited_frames = _visited;
	r_statistics.frame_ms = _ms;
}

} // namespace grass

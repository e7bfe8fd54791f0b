// SPDX-License-Identifier: MIT
#include "field/field_life.h"

#include "core/base/cpu_clock.h"
#include "draw/field_shaders.h"
#include "gpu/obstacles.h"

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

void FieldLife::ask() {
	_stage = is_preparing() ? Stage::OUTDATED : Stage::ASKED;
	_most_ms = 0.0;
}

void FieldLife::leave() {
	_stage = is_waiting() ? Stage::ASKED : Stage::NONE;
	_wanted = {};
	_standing.clear();
}

bool FieldLife::advance() {
	const bool is_refused = _standing.is_refused();
	report_refusals(); // before warnings about their consequences
	if (_is_reading || !_host.node().is_inside_tree() || !(is_waiting() || is_refused || _standing.get_picture().is_look_waiting())) {
		return true;
	}
	CpuClock clock;
	if (is_refused) {
		_standing.leave_device();
		_stage = _stage == Stage::SHOWN ? Stage::MADE : _stage;
		_is_new = true;
	}
	if (is_waiting() && !make()) {
		return false;
	}
	show(); // after that: a field that changes before it is shown keeps what was made
	if (std::exchange(_is_new, false)) {
		_host.report_warnings();
	}
	_most_ms = std::max(_most_ms, clock.lap());
	return true;
}

bool FieldLife::make() {
	FrameShare::Turn turn(this); // includes the making, once everything is prepared
	_is_reading = true;
	if (!_host.read_scene()) {
		return false;
	}
	_is_reading = false;
	if (is_waiting() && _host.node().is_inside_tree() && prepare(turn)) {
		const bool is_outdated = _stage == Stage::OUTDATED;
		_wanted.setup.pool_size = find_pool_size(_properties, _wanted.setup); // the level of quality may have changed meanwhile
		_standing.make(std::exchange(_wanted, {}), _properties.is_streamed && !_host.node().is_visible());
		_stage = is_outdated ? Stage::ASKED : Stage::MADE;
		_makings++;
		_is_new = true;
	}
	return true;
}

// Works only as far as this frame has time if another field runs meanwhile, or if this one is streamed. Returns true once it can be made.
bool FieldLife::prepare(FrameShare::Turn &r_turn) {
	Backend *backend = _standing.get_backend();
	const bool in_parts = backend != nullptr || _properties.is_streamed;
	if (_stage == Stage::OUTDATED && (backend == nullptr || _properties.is_streamed)) { // nobody sees it
		_wanted = {};
		_stage = Stage::ASKED;
	}
	const bool has_patches = !in_parts || _properties.species.prepare_patches();
	if (_stage == Stage::ASKED) {
		if (!has_patches || !has_time(r_turn)) {
			return false;
		}
		_wanted = find_wanted(_properties);
		_stage = Stage::PREPARING;
	}
	if (!_wanted.bounds) {
		if (!has_time(r_turn)) {
			return false;
		}
		_wanted.bounds = _standing.get_field().bounds_of(_wanted.setup);
	}
	const bool has_ledges = _wanted.painted.is_valid() && _wanted.painted->get_map().uses(MAP_LEDGE);
	const Look look{ shader_features(_wanted.setup) | (has_ledges ? SHADER_LEDGES : 0), _properties.hook.get_text() };
	const bool has_shaders = !in_parts || ((backend == nullptr || backend->prepare(_wanted.setup)) & prepare_shaders(look));
	const bool has_pictures = !in_parts || are_pictured(_wanted.plants);
	return has_shaders && has_pictures && prepare_map(r_turn) && has_time(r_turn);
}

bool FieldLife::has_time(FrameShare::Turn &r_turn) const {
	return _properties.is_streamed ? r_turn.has_part() : !_standing.stands() || r_turn.has_time();
}

bool FieldLife::prepare_map(FrameShare::Turn &r_turn) {
	if (!_wanted.setup.is_mapped || _wanted.setup.patch->is_empty()) {
		return true;
	}
	std::unique_ptr<ShownMap> &map = _wanted.map;
	if (!map && has_time(r_turn)) {
		map = ShownMap::make(_wanted.painted, _wanted.setup.map_place(), _stage == Stage::OUTDATED ? nullptr : std::move(_prepared));
	}
	while (map && map->has_work()) {
		if (map->is_waiting_for_thread() || !has_time(r_turn)) {
			return false;
		}
		map->work();
	}
	return map != nullptr;
}

void FieldLife::show() {
	if (_standing.get_picture().is_look_waiting() && !_standing.show(&_host.node(), _host.field_transform())) {
		_properties.hook.reject();
		_standing.show(&_host.node(), _host.field_transform());
		_is_new = true;
	}
	_stage = _stage == Stage::MADE && _standing.get_picture().is_shown() ? Stage::SHOWN : _stage;
}

void FieldLife::add_to(FieldStatistics &r_statistics) const {
	if (const ShownMap *map = get_map()) {
		r_statistics.map_waiting += map->get_waiting();
	}
	r_statistics.is_waiting = r_statistics.is_waiting || is_waiting();
	r_statistics.makings = _makings;
	r_statistics.build_ms = _most_ms;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "nodes/field_report.h"

#include "field/field_device.h"
#include "field/statistics_dictionary.h"
#include "nodes/grass_field.h"
#include "shared/build_info.h"
#include "shared/main_thread.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/world3d.hpp>

#include <cmath>
#include <set>
#include <string>

using namespace godot;

namespace grass {

namespace {

// Warnings of refused passes that some field has printed. No String: the engine's memory must not outlive the engine.
std::set<std::string> &printed_refusals() {
	static std::set<std::string> printed;
	return printed;
}

} // namespace

String FieldReport::label() const {
	return vformat("GrassField '%s'", _parts.node().get_name());
}

String FieldReport::message(const String &p_text) const {
	// On another thread the renderer replies only once the main thread is free, which may be waiting for this thread.
	if (_has_reported || !is_main_thread()) {
		return vformat("%s: %s", label(), p_text);
	}
	_has_reported = true;
	PackedStringArray build;
	build.push_back("GrassField " + get_version());
	build.push_back(_parts.standing.stands() ? vformat("%s backend", _parts.standing.get_backend()->get_name()) : String("no backend"));
	if (const String device = get_device(); !device.is_empty()) {
		build.push_back(device);
		build.push_back(get_driver());
	}
	return vformat("%s: %s (%s)", label(), p_text, String(", ").join(build));
}

void FieldReport::warn(const String &p_warning) const {
	if (_warning_teller) {
		_warning_teller(p_warning);
	} else {
		WARN_PRINT(vformat("%s: %s", label(), p_warning));
	}
}

void FieldReport::report_warnings() {
	if (Engine::get_singleton()->is_editor_hint()) {
		_parts.host.show_warnings();
		return;
	}
	const PackedStringArray warnings = find_warnings();
	const FieldSetup &setup = _parts.standing.get_field().get_setup();
	const String refusal = refusal_warning(_parts.properties, setup); // of the first field only: a world has many
	const bool is_printed = !refusal.is_empty() && !printed_refusals().insert(refusal.utf8().get_data()).second;
	for (const String &warning : warnings) {
		if (!_warned_of.has(warning) && !(is_printed && warning == refusal)) {
			warn(warning);
		}
	}
	_warned_of = warnings;
}

PackedStringArray FieldReport::find_warnings() const {
	const FieldSetup &setup = _parts.standing.get_field().get_setup();
	PackedStringArray warnings;
	_parts.properties.warn_of_blades(warnings);
	_parts.sources.warn_of_map(warnings);
	if (_parts.node().is_inside_tree()) {
		const Transform3D transform = _parts.node().get_global_transform();
		if (!transform.is_finite()) {
			warnings.push_back("The node's transform is not a number. Set its position and rotation again.");
		} else if (!transform.basis.get_scale().is_equal_approx(Vector3(1, 1, 1))) {
			warnings.push_back("The node's scale is ignored. Use `size` for the field, and the patch's lengths and widths for the blades.");
		}
	}
	_parts.properties.warn_of_tiles(warnings);
	_parts.properties.warn_of_ground(warnings);
	warn_of_device(_parts.properties, setup, warnings);
	if (_parts.standing.is_crowded()) {
		warnings.push_back(crowded_warning(setup));
	}
	if (_parts.standing.is_budget_blind()) {
		warnings.push_back(blind_warning());
	}
	_parts.properties.hook.warn(warnings);
	_parts.sources.warn(warnings);
	return warnings;
}

// Returns the nearest of the other fields with ground at a place, or null.
Node3D *FieldReport::find_other(const Vector3 &p_global) const {
	GrassField *nearest = nullptr;
	real_t least = real_t(INFINITY);
	for (GrassField *field : FieldMonitors::get_fields()) {
		const real_t height = std::abs(field->field_transform().affine_inverse().xform(p_global).y);
		const bool is_other = field != &_parts.node() && field->get_world_3d() == _parts.node().get_world_3d();
		if (is_other && height < least && field->get_parts().queries.has_level_at(p_global)) {
			nearest = field;
			least = height;
		}
	}
	return nearest;
}

Dictionary FieldReport::explain(const Vector3 &p_global, const Camera3D *p_camera) {
	return _parts.sources.explain(p_global, p_camera, _parts.node().is_inside_tree() ? find_other(p_global) : nullptr);
}

int64_t FieldReport::get_memory_usage() const {
	return _parts.standing.get_memory_usage() + _parts.life.get_memory_usage() + _parts.sources.get_memory_usage() +
			_parts.plants.get_memory_usage();
}

FieldMemory FieldReport::find_memory() const {
	FieldMemory memory;
	if (_parts.standing.stands()) {
		memory = { _parts.standing.get_backend()->get_memory(), _parts.standing.get_field().get_setup().patch.get() };
	}
	const Ref<GrassMap> &map = _parts.properties.map;
	memory.all = get_memory_usage() + (map.is_valid() ? map->get_memory_usage() : 0);
	return memory;
}

FieldStatistics FieldReport::find_statistics() const {
	FieldStatistics statistics;
	_parts.standing.add_to(statistics);
	_parts.life.add_to(statistics);
	_ticks.add_to(statistics);
	_frames.add_to(statistics);
	_parts.sources.add_to(statistics);
	statistics.blades = _parts.queries.get_blade_count();
	statistics.memory = get_memory_usage();
	return statistics;
}

Dictionary FieldReport::get_statistics() const {
	return statistics_dictionary(find_statistics());
}

Dictionary FieldReport::get_counters() const {
	return counters_dictionary(find_statistics());
}

// Returns the field's share of a monitor. The debugger queries each one separately, so each reads only what it shows.
double FieldReport::find_monitor(FieldMonitor p_monitor) {
	if (!_parts.standing.stands()) {
		return 0.0;
	}
	const Field &field = _parts.standing.get_field();
	switch (p_monitor) {
		case MONITOR_AWAKE_TILES:
			return double(field.get_tiles().get_statistics().awake);
		case MONITOR_SIMULATED_BLADES:
			return field.is_seen() ? double(field.get_tiles().get_statistics().simulated) * GRASS_BLADES_PER_TILE : 0.0;
		case MONITOR_DRAWN_BLADES:
			return double(_parts.standing.get_backend()->get_statistics().drawn_blades);
		case MONITOR_DRAWN_TRIANGLES:
			return double(_parts.standing.count_drawn().triangles[0]);
		case MONITOR_MANAGEMENT:
			return _ticks.is_resting() ? 0.0 : 1e-3 * (_ticks.get_gather_ms() + field.get_tiles_ms());
		case MONITOR_SIMULATE:
			_parts.standing.measure_time();
			return 1e-3 * _parts.standing.get_backend()->get_statistics().simulate_ms;
		case MONITOR_CULL:
			_parts.standing.measure_time();
			return 1e-3 * _parts.standing.get_backend()->get_statistics().cull_ms;
		case MONITOR_MEMORY:
			return double(get_memory_usage());
		default:
			return 0.0;
	}
}

} // namespace grass

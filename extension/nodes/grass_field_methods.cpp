// SPDX-License-Identifier: MIT
// The other methods that scripts call: memory and statistics, and what changes the grass. Each checks its arguments and passes them on.
#include "nodes/grass_field.h"

#include "field/statistics_dictionary.h"
#include "field/work_limits.h"
#include "shared/build_info.h"
#include "shared/main_thread.h"

using namespace godot;

namespace grass {

String GrassField::label() const {
	return vformat("GrassField '%s'", get_name());
}

String GrassField::message(const String &p_text) const {
	// On another thread the renderer replies only once the main thread is free, which may be waiting for this thread.
	if (_has_reported || !is_main_thread()) {
		return vformat("%s: %s", label(), p_text);
	}
	_has_reported = true;
	PackedStringArray build;
	build.push_back("GrassField " + get_version());
	build.push_back(_standing.stands() ? vformat("%s backend", _standing.get_backend()->get_name()) : String("no backend"));
	if (const String device = get_device(); !device.is_empty()) {
		build.push_back(device);
		build.push_back(get_driver());
	}
	return vformat("%s: %s (%s)", label(), p_text, String(", ").join(build));
}

int64_t GrassField::get_memory_usage() const {
	GRASS_MAIN_THREAD_ONLY_V(0);
	return _standing.get_memory_usage() + _life.get_memory_usage() + _terrain.get_memory_usage() + _plants.get_memory_usage();
}

FieldMemory GrassField::find_memory() const {
	FieldMemory memory;
	if (_standing.stands()) {
		memory = { _standing.get_backend()->get_memory(), _standing.get_field().get_setup().patch.get() };
	}
	memory.all = get_memory_usage() + (_properties.map.is_valid() ? _properties.map->get_memory_usage() : 0);
	return memory;
}

String GrassField::get_version() {
	return grass::get_version();
}

FieldStatistics GrassField::find_statistics() const {
	FieldStatistics statistics;
	_standing.add_to(statistics);
	_life.add_to(statistics);
	_bodies.add_to(statistics);
	_filler.add_to(statistics);
	_terrain.add_to(statistics);
	_plants.add_to(statistics);
	statistics.visited_ticks = _visited_ticks;
	statistics.visited_frames = _visited_frames;
	statistics.reads.add(_shared_reads);
	statistics.forces = int64_t(_forces.get().size());
	statistics.forces_left_out = _forces.get_left_out();
	statistics.blades = get_blade_count();
	statistics.memory = get_memory_usage();
	statistics.gather_ms = _gather_ms;
	statistics.plants_ms = _plants_ms;
	statistics.frame_ms = _frame_ms;
	return statistics;
}

Dictionary GrassField::get_statistics() const {
	GRASS_MAIN_THREAD_ONLY_V(Dictionary());
	return statistics_dictionary(find_statistics());
}

Dictionary GrassField::get_counters() const {
	GRASS_MAIN_THREAD_ONLY_V(Dictionary());
	return counters_dictionary(find_statistics());
}

// The debugger queries each monitor separately: each reads only what it shows.
double GrassField::get_monitor(FieldMonitor p_monitor) {
	if (!_standing.stands()) {
		return 0.0;
	}
	const Field &field = _standing.get_field();
	switch (p_monitor) {
		case MONITOR_AWAKE_TILES:
			return double(field.get_tiles().get_statistics().awake);
		case MONITOR_SIMULATED_BLADES:
			return field.is_seen() ? double(field.get_tiles().get_statistics().simulated) * GRASS_BLADES_PER_TILE : 0.0;
		case MONITOR_DRAWN_BLADES:
			return double(_standing.get_backend()->get_statistics().drawn_blades);
		case MONITOR_DRAWN_TRIANGLES:
			return double(_standing.count_drawn().triangles[0]);
		case MONITOR_MANAGEMENT:
			return _rests ? 0.0 : 1e-3 * (_gather_ms + field.get_tiles_ms());
		case MONITOR_SIMULATE:
			_standing.measure_time();
			return 1e-3 * _standing.get_backend()->get_statistics().simulate_ms;
		case MONITOR_CULL:
			_standing.measure_time();
			return 1e-3 * _standing.get_backend()->get_statistics().cull_ms;
		case MONITOR_MEMORY:
			return double(get_memory_usage());
		default:
			return 0.0;
	}
}

GrassMap *GrassField::need_map(const char *p_method) {
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), nullptr, message(vformat("add the node to the scene tree before calling %s().", p_method)));
	if (_properties.map.is_null()) {
		make_map();
	}
	return stand() ? _properties.map.ptr() : nullptr;
}

void GrassField::make_map() {
	Ref<GrassMap> map;
	map.instantiate();
	map->set_base_density(1.0);
	set_map(map);
}

Dictionary GrassField::cut(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	GRASS_MAIN_THREAD_ONLY_V(to_dictionary(CutResult()));
	return to_dictionary(_work.cut(p_shape, p_transform));
}

double GrassField::get_mown_share(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	return _work.get_mown_share(p_shape, p_transform);
}

void GrassField::regrow(double p_height, double p_wear, const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	GRASS_MAIN_THREAD_ONLY();
	_work.regrow(p_height, p_wear, p_shape, p_transform);
}

double GrassField::paint(const Ref<GrassBrush> &p_brush, const Vector3 &p_from, const Vector3 &p_to) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	return _work.paint(p_brush, p_from, p_to);
}

double GrassField::trample(const Vector3 &p_global_position, double p_radius, double p_amount) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	return _work.trample(p_global_position, p_radius, p_amount);
}

int64_t GrassField::bake_ground(const Rect2 &p_region, int64_t p_mask) {
	GRASS_MAIN_THREAD_ONLY_V(0);
	return _work.bake_ground(p_region, p_mask, true);
}

int64_t GrassField::bake_whole_ground() {
	return _work.bake_ground(Rect2(), FieldGround::ALL_LAYERS, false);
}

double GrassField::find_area(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) const {
	return _work.find_area(p_shape, p_transform);
}

int64_t GrassField::bake_ground_from(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	GRASS_MAIN_THREAD_ONLY_V(0);
	return _work.bake_ground_from(p_shape, p_transform);
}

double GrassField::fill(const Ref<GrassFillRule> &p_rule) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	ERR_FAIL_COND_V_MSG(p_rule.is_null(), 0.0, message("fill() needs a GrassFillRule."));
	const double area = double(_properties.size.x) * double(_properties.size.y);
	ERR_FAIL_COND_V_MSG(area > double(AREA_MAX), 0.0,
			message(vformat(
					"fill() would fill %.0f square metres at once, and fills %d at most (AREA_MAX). Set the rule as `fill_rule`, which "
					"fills some of it in each frame.",
					area, AREA_MAX)));
	return fill_whole(p_rule);
}

double GrassField::fill_whole(const Ref<GrassFillRule> &p_rule) {
	if (need_map("fill") == nullptr) {
		return 0.0;
	}
	if (_filler.has_live_rule()) {
		WARN_PRINT(message("fill() was called while `fill_rule` is live: that rule will overwrite the result at its next change. Turn "
						   "`fill_live` off."));
	}
	return _filler.fill(_properties.map, p_rule, fill_place());
}

void GrassField::blast(const Vector3 &p_global_position, double p_speed, double p_radius, double p_duration) {
	GRASS_MAIN_THREAD_ONLY();
	stir();
	_forces.blast(p_global_position, p_speed, p_radius, p_duration);
}

void GrassField::push(const Vector3 &p_global_position, const Vector3 &p_velocity, double p_radius, double p_duration) {
	GRASS_MAIN_THREAD_ONLY();
	stir();
	_forces.push(p_global_position, p_velocity, p_radius, p_duration);
}

void GrassField::register_collider(Node3D *p_node, const Ref<Shape3D> &p_shape) {
	GRASS_MAIN_THREAD_ONLY();
	stir();
	ERR_FAIL_COND_MSG(p_node == nullptr || p_shape.is_null(), message("register_collider() needs a node and its shape."));
	if (_bodies.get_registered().add(p_node, p_shape)) {
		return;
	}
	const String what = vformat("the %s registered for '%s'", p_shape->get_class(), p_node->get_name());
	const bool is_polygon = p_shape->is_class("ConvexPolygonShape3D") || p_shape->is_class("ConcavePolygonShape3D");
	ERR_FAIL_COND_MSG(is_polygon,
			message(vformat(
					"%s encloses no volume. Before you register it, give it at least four points that are not all in one plane.", what)));
	ERR_FAIL_MSG(message(vformat("%s bends no grass. Use a sphere, box, capsule, cylinder or convex polygon.", what)));
}

void GrassField::unregister_collider(Node3D *p_node) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_NULL_MSG(p_node, message("unregister_collider() needs a node."));
	_bodies.get_registered().remove(p_node->get_instance_id());
}

} // namespace grass

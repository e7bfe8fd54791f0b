// SPDX-License-Identifier: MIT
#include "ground/field_terrain.h"

#include "shared/convert.h"
#include "shared/property_value.h"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/core/object.hpp>

#include <cmath>

using namespace godot;

namespace grass {

namespace {

// Frames between checks of the terrain, which may appear, disappear, move or get other data without a signal.
constexpr int FRAMES_BETWEEN_QUERIES = 15;
// Heights are vertical: the most by which a field's up axis may differ from that, sine of the angle.
constexpr double LARGEST_TILT = 1e-3;

// Returns whether two places are the same. A shift of the origin moves both, and loses some of the last digits.
bool is_same_place(const Transform3D &p_a, const Transform3D &p_b) {
	const Eigen::Affine3d a = to_eigen(p_a), b = to_eigen(p_b);
	return (a.linear() - b.linear()).norm() < 1e-5 && (a.translation() - b.translation()).norm() < 1e-3;
}

bool is_upright(const Transform3D &p_field) {
	const Vector3 up = p_field.basis.get_column(1);
	return std::hypot(double(up.x), double(up.z)) < LARGEST_TILT && up.y > 0.0f;
}

} // namespace

void FieldTerrain::set_path(const NodePath &p_path) {
	(void)replace(_path, p_path);
	forget();
	_problem = String();
	_frames_to_look = 0;
}

void FieldTerrain::forget() {
	if (Object *emitter = _source ? _source->get_emitter() : nullptr) {
		for (const TerrainSource::Notice &notice : _notices) {
			emitter->disconnect(notice.signal, notice.handler);
		}
	}
	_notices.clear();
	_calls_before += _source ? _source->get_calls() : 0;
	_source.reset();
	_ids.reset();
	_colors.stop();
	_queue.clear();
	_piece.reset();
	_areas.clear();
	_is_all_changed = false;
	_is_grid_due = false;
	_beside.reset();
	_beside_when_read.reset();
}

void FieldTerrain::leave() {
	forget();
	_frames_to_look = 0;
}

void FieldTerrain::listen(const TerrainSource::Handlers &p_handlers) {
	Object *emitter = _source->get_emitter();
	for (const TerrainSource::Notice &notice : _source->get_notices(p_handlers)) {
		if (emitter->has_signal(notice.signal)) {
			emitter->connect(notice.signal, notice.handler);
			_notices.push_back(notice);
		}
	}
}

bool FieldTerrain::find(const TerrainSource::Handlers &p_handlers) {
	_problem = String();
	const NodePath path = _path;
	Node *node = _node.get_node_or_null(path);
	if (node == nullptr || !node->is_inside_tree()) {
		_problem = vformat(
				"`terrain` is '%s', which is not a node of the scene. Choose the terrain again, or clear the property.", String(path));
		forget();
		return true;
	}
	std::shared_ptr<TerrainSource> found;
	String problem;
	if (!ask([&] { found = TerrainSource::find(node, problem); })) {
		return false;
	}
	if (path != _path || (found && _source && found->is_same(*_source))) {
		return true;
	}
	_problem = problem;
	forget();
	_source = found && found->is_alive() ? found : nullptr;
	if (_source) {
		_ids = _source->has_textures() ? std::make_shared<TerrainIds>() : nullptr;
		if (_source->has_colors()) {
			_colors.start(_region);
		}
		listen(p_handlers);
		_is_all_changed = true;
	}
	return true;
}

// Reads everything again once a field or terrain that moved is at rest. If both moved together (a shifted origin), reads nothing.
bool FieldTerrain::watch_place(const Transform3D &p_transform, const MapRegion &p_region) {
	const std::shared_ptr<TerrainSource> source = _source;
	Transform3D terrain;
	if (!ask([&] { terrain = source->get_transform(); })) {
		return false;
	}
	if (source != _source) {
		return true;
	}
	const Transform3D beside = terrain.affine_inverse() * p_transform;
	const bool rests = _beside && is_same_place(*_beside, beside);
	if (!_beside_when_read || (rests && !is_same_place(*_beside_when_read, beside))) {
		_beside_when_read = beside;
		_is_all_changed = true;
	}
	_beside = beside;
	_field = p_transform;
	// Includes the texels that the outermost blades blend with.
	const MapRegion area = p_region.grown(info_of(MAP_GROUND).texel_size());
	if (!(_queue.get_area() == area)) {
		_queue.set_area(area);
		_is_all_changed = true;
		_colors.move(p_region);
	}
	return true;
}

void FieldTerrain::read_all(bool p_is_elsewhere) {
	_queue.add_all();
	_is_grid_due = true;
	if (p_is_elsewhere) {
		_colors.clear();
	}
}

bool FieldTerrain::look(const Transform3D &p_transform, const MapRegion &p_region, const TerrainSource::Handlers &p_handlers) {
	_can_read = false;
	if (_path.is_empty() || _is_asking) {
		return true;
	}
	_region = p_region;
	if (--_frames_to_look <= 0 || (_source && !_source->is_alive())) {
		_frames_to_look = FRAMES_BETWEEN_QUERIES;
		if (!find(p_handlers) || (_source && !watch_place(p_transform, p_region))) {
			return false;
		}
	}
	if (_source && !is_upright(p_transform)) {
		_problem = "`terrain` provides vertical heights, but the field is tilted, so its heights are not used. Rotate the field about its "
				   "Y axis only.";
		return true;
	}
	_can_read = true;
	return true;
}

void FieldTerrain::area_changed(const AABB &p_area) {
	if (p_area.size == Vector3()) {
		_is_all_changed = true;
	} else {
		_areas.push_back(p_area);
	}
}

bool FieldTerrain::cells_changed(const Vector2 &p_first, const Vector2 &p_count) {
	const std::shared_ptr<TerrainSource> source = _source;
	if (source && source->is_alive()) {
		AABB area;
		if (!ask([&] { area = source->to_area(p_first, p_count); })) {
			return false;
		}
		if (area.is_finite()) {
			_areas.push_back(area);
		}
	}
	return true;
}

void FieldTerrain::warn(PackedStringArray &r_warnings) const {
	if (!_problem.is_empty()) {
		r_warnings.push_back(_problem);
	}
	if (_source && !_source->get_problem().is_empty()) {
		r_warnings.push_back("`terrain`: " + _source->get_problem());
	}
}

bool FieldTerrain::has_new_warning() {
	const String now = _problem + (_source ? "found " + _source->get_problem() : String()); // other warnings end when it is found
	return std::exchange(_warned, now) != now;
}

void FieldTerrain::add_to(FieldStatistics &r_statistics) const {
	r_statistics.terrain_queries = _share.get_queries();
	r_statistics.terrain_calls = _calls_before + (_source ? _source->get_calls() : 0);
	r_statistics.terrain_waiting = _queue.get_waiting() + (_piece ? 1 : 0);
}

int64_t FieldTerrain::get_memory_usage() const {
	return (_ids ? int64_t(_ids->get_memory_usage()) : 0) + _colors.get_memory_usage();
}

} // namespace grass

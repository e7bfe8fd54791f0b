// SPDX-License-Identifier: MIT
// What a field reads of its terrain in a frame.
#include "field/field_view.h"
#include "ground/field_terrain.h"
#include "shared/convert.h"

using namespace godot;

namespace grass {

// Takes the changes of a frame. A terrain may report an area and, in the same frame, a change without one: then the areas count.
void FieldTerrain::take_changes() {
	const Transform3D to_field = _field.affine_inverse();
	for (const AABB &area : _areas) {
		const AABB here = moved(to_field, area);
		const MapRegion region{ { here.position.x, here.position.z }, { here.position.x + here.size.x, here.position.z + here.size.z } };
		_queue.add(region.grown(2.0 * info_of(MAP_GROUND).texel_size())); // slopes beside it change too
	}
	if (_is_all_changed && _areas.empty()) {
		_queue.add_all();
		_is_grid_due = true;
	}
	_areas.clear();
	_is_all_changed = false;
}

// Reads the piece's next places: as many as the terrain is queried for at once, so that a slow terrain can be interrupted within a row.
// Returns false if a script freed the field.
bool FieldTerrain::read_places() {
	const std::shared_ptr<TerrainSource> source = _source;
	std::vector<Vector3> places;
	for (const Eigen::Vector2d &place : _piece->get_next(source->get_places_at_once())) {
		places.push_back(_field.xform(Vector3(real_t(place.x()), 0, real_t(place.y()))));
	}
	std::vector<TerrainSample> samples(places.size());
	if (!ask([&] { source->read(places, samples); })) {
		return false;
	}
	if (source != _source || !source->is_alive() || !_piece) { // a method of the terrain removed it, or changed the field
		return true;
	}
	const Eigen::Matrix3d to_field = to_eigen(_field.basis).transpose();
	for (TerrainSample &sample : samples) {
		sample.height -= double(_field.origin.y);
		sample.normal = to_field * sample.normal;
	}
	_piece->put_next(samples);
	_share.count(int64_t(samples.size()));
	return true;
}

bool FieldTerrain::lay(const Ref<GrassMap> &p_map, double p_ledge_slope, const std::function<void(const MapRegion &)> &p_touched) {
	const TerrainPiece piece = std::move(*_piece);
	_piece.reset(); // a listener of the map may change the terrain
	const bool has_new_textures = _ids && piece.put_textures(*_ids);
	_colors.put(piece);
	if (!outlives(_node, [&] { p_map.ptr()->change([&](PaintMap &r_map) { return piece.lay(r_map, p_ledge_slope); }); })) {
		return false;
	}
	if (has_new_textures) {
		p_touched(piece.get_region().grown(0.5 * info_of(MAP_GROUND).texel_size())); // so far the outermost texels reach
	}
	return true;
}

// Lets the map's heights lie where the terrain has its vertices, if all of its ground is this terrain's. Returns false if a script freed
// the field.
bool FieldTerrain::take_grid(const Ref<GrassMap> &p_map) {
	_is_grid_due = false;
	const std::shared_ptr<TerrainSource> source = _source;
	std::optional<GroundGrid> grid;
	if (!ask([&] { grid = source->find_grid(_field); })) {
		return false;
	}
	const PaintMap &map = p_map->get_map();
	if (source != _source || !grid || *grid == map.get_ground_grid() || !is_all_ground_in(map, _queue.get_area())) {
		return true;
	}
	_piece.reset(); // of the grid before
	_queue.add_all();
	return outlives(_node, [&] {
		p_map.ptr()->change([&](PaintMap &r_map) {
			r_map.set_ground_grid(*grid);
			return BrushResult();
		});
	});
}

// Returns false if nothing waits to be read.
bool FieldTerrain::begin_piece(const GroundGrid &p_grid, std::vector<Eigen::Vector2d> &r_eyes) {
	if (_piece && !(_piece->get_grid() == p_grid)) { // the map was replaced or undone
		_queue.add(_piece->get_region());
		_piece.reset();
	}
	if (_piece) {
		return true;
	}
	if (r_eyes.empty()) {
		r_eyes = find_eyes_on_ground(&_node, _node.get_layer_mask(), to_eigen(_field));
	}
	const std::optional<MapRegion> region = _queue.take(r_eyes);
	if (region) {
		_piece.emplace(*region, p_grid);
	}
	return region.has_value();
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): a script that runs meanwhile may drop the field's own map
bool FieldTerrain::read(Ref<GrassMap> p_map, double p_ledge_slope, const std::function<void(const MapRegion &)> &p_touched) {
	take_changes();
	if (!p_map->is_readable()) {
		return true;
	}
	_colors.show(_queue.get_waiting() == 0 && !_piece);
	if (!_piece && _queue.get_waiting() == 0) {
		return true;
	}
	if (_is_grid_due && !take_grid(p_map)) {
		return false;
	}
	if (!_source || !_source->is_alive() || !_node.is_inside_tree()) { // a script removed the terrain or the field
		return true;
	}
	std::vector<Eigen::Vector2d> eyes;
	TerrainShare::Turn turn(_share);
	while (turn.may_go_on()) {
		if (!begin_piece(p_map->get_map().get_ground_grid(), eyes)) {
			return true;
		}
		if (!_piece->is_complete() && !read_places()) {
			return false;
		}
		if (_piece && _piece->is_complete() && !lay(p_map, p_ledge_slope, p_touched)) {
			return false;
		}
		if (!_source || !_source->is_alive() || !_node.is_inside_tree()) { // a script removed the terrain or the field
			return true;
		}
	}
	return true;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "nodes/field_places.h"

#include "core/field/grass_at.h"

using namespace godot;

namespace grass {

Vector2i FieldPlaces::get_tile_at(const Vector3 &p_global) const {
	const Eigen::Vector3d place = from_global(p_global);
	if (!place.allFinite()) {
		return Vector2i(-1, -1);
	}
	const TileGrid grid = _standing.get_grid();
	const TilePlace tile = grid.get_place(place);
	return grid.has_tile(tile.x, tile.z) ? Vector2i(tile.x, tile.z) : Vector2i(-1, -1);
}

Vector3 FieldPlaces::get_tile_centre(const Vector2i &p_tile) const {
	return to_godot(Eigen::Vector3d(_to_world * _standing.get_grid().get_centre(p_tile.x, p_tile.y)));
}

PackedVector3Array FieldPlaces::find_knots(const Vector2i &p_tile, int p_first, int p_count) const {
	const Field &field = _standing.get_field();
	const int slot = field.get_tiles().get_slot_of(field.get_grid().get_index(p_tile.x, p_tile.y));
	const std::vector<Eigen::Vector3f> simulated =
			slot != GRASS_NO_SLOT ? _standing.get_backend()->read_knots(slot, p_first, p_count) : std::vector<Eigen::Vector3f>();
	PackedVector3Array result;
	for (const Eigen::Vector3d &knot : field.find_knots(p_tile.x, p_tile.y, p_first, p_count, simulated)) {
		result.push_back(to_godot(Eigen::Vector3d(_to_world * knot)));
	}
	return result;
}

// 0 outside of the field, and where none stands.
template <typename F> double FieldPlaces::read_at(const Vector3 &p_global, F &&p_read) const {
	if (!_standing.stands() || !p_global.is_finite() || get_tile_at(p_global) == Vector2i(-1, -1)) {
		return 0.0;
	}
	const Eigen::Vector3d place = from_global(p_global);
	const Eigen::Vector2f ground(float(place.x()), float(place.z()));
	MapLayers own;
	return p_read(_standing.get_field(), ground, _standing.layers_at(ground, own));
}

double FieldPlaces::density_at(const Vector3 &p_global) const {
	return read_at(p_global, grass::density_at);
}

double FieldPlaces::height_at(const Vector3 &p_global) const {
	return read_at(p_global, grass::height_at);
}

Vector3 FieldPlaces::bend_at(const Vector3 &p_global) const {
	if (density_at(p_global) <= 0.0) {
		return Vector3();
	}
	const Field &field = _standing.get_field();
	const Vector2i tile = get_tile_at(p_global);
	const Eigen::Vector3d bend = field.get_tiles().get_bend(field.get_grid().get_index(tile.x, tile.y)).cast<double>();
	return to_godot(Eigen::Vector3d(_to_world.linear() * bend));
}

} // namespace grass

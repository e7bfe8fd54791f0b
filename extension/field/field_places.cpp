// SPDX-License-Identifier: MIT
#include "field/field_places.h"

#include "core/field/canopy.h"
#include "core/field/grass_at.h"

#include <numeric>

using namespace godot;

namespace grass {

std::optional<TilePlace> FieldPlaces::find_tile(const Vector3 &p_global) const {
	const Eigen::Vector3d place = from_global(p_global);
	if (!place.allFinite()) {
		return {};
	}
	const TileGrid grid = _standing.get_grid();
	const TilePlace tile = grid.get_place(place);
	return grid.has_tile(tile.x, tile.z) ? std::optional(tile) : std::nullopt;
}

Vector2i to_script(const std::optional<TilePlace> &p_tile) {
	return p_tile ? Vector2i(p_tile->x, p_tile->z) : Vector2i(-1, -1);
}

Vector3 FieldPlaces::get_tile_centre(const Vector2i &p_tile) const {
	return to_godot(Eigen::Vector3d(_to_world * _standing.get_grid().get_centre(p_tile.x, p_tile.y)));
}

PackedVector3Array FieldPlaces::find_knots(std::span<const BladeNumber> p_blades, Knots p_knots) const {
	const Field &field = _standing.get_field();
	Backend *backend = _standing.get_backend();
	std::vector<WantedBlade> wanted;
	wanted.reserve(p_blades.size());
	for (const BladeNumber blade : p_blades) {
		wanted.push_back({ blade, field.get_tiles().get_slot_of(tile_of(blade)) });
	}
	const std::vector<SimulatedKnots> simulated = p_knots == Knots::EXACT ? backend->wait_for_knots(wanted) : backend->find_knots(wanted);
	PackedVector3Array result;
	result.resize(int64_t(p_blades.size()) * GRASS_KNOTS);
	Vector3 *to = result.ptrw();
	for (size_t i = 0; i < p_blades.size(); i++) {
		for (const Eigen::Vector3d &knot : field.find_knots(p_blades[i], simulated[i])) {
			*to++ = to_godot(Eigen::Vector3d(_to_world * knot));
		}
	}
	return result;
}

std::vector<BladeNumber> FieldPlaces::blades_of(const Vector2i &p_tile) const {
	std::vector<BladeNumber> blades(GRASS_BLADES_PER_TILE);
	std::iota(blades.begin(), blades.end(), number_of(_standing.get_grid().get_index(p_tile.x, p_tile.y), 0));
	return blades;
}

int64_t FieldPlaces::count_blades(const Vector3 &p_global, double p_radius) const {
	const Eigen::Vector3d place = from_global(p_global);
	return _standing.get_field().tiles_around({ place.x(), place.z() }, p_radius).count() * GRASS_BLADES_PER_TILE;
}

std::vector<BladeNumber> FieldPlaces::find_blades(const Vector3 &p_global, double p_radius) const {
	const Eigen::Vector3d place = from_global(p_global);
	return _standing.get_field().find_blades({ place.x(), place.z() }, p_radius);
}

// Returns 0 outside of the field and of its band, and if no field runs.
template <typename F> double FieldPlaces::read_at(const Vector3 &p_global, F &&p_read) const {
	if (!_standing.stands() || !p_global.is_finite() || !find_tile(p_global)) {
		return 0.0;
	}
	const Eigen::Vector3d place = from_global(p_global);
	if (!_band.contains(place.y())) {
		return 0.0;
	}
	const Eigen::Vector2f ground(float(place.x()), float(place.z()));
	return p_read(ground, _standing.layers_at(ground));
}

double FieldPlaces::density_at(const Vector3 &p_global) const {
	return read_at(p_global, grass::density_at);
}

double FieldPlaces::height_at(const Vector3 &p_global) const {
	return read_at(p_global, [this](const Eigen::Vector2f &p_place, const MapLayers *p_layers) {
		return grass::height_at(_standing.get_field(), p_place, p_layers);
	});
}

double FieldPlaces::cover_between(const Vector3 &p_from, const Vector3 &p_to) const {
	const auto layers_at = [this](const Eigen::Vector2f &p_place) { return _standing.layers_at(p_place); };
	return _standing.stands() ? hidden_share(_standing.get_field(), layers_at, from_global(p_from), from_global(p_to)) : 0.0;
}

Vector3 FieldPlaces::bend_at(const Vector3 &p_global) const {
	if (density_at(p_global) <= 0.0) {
		return Vector3();
	}
	const Field &field = _standing.get_field();
	const TilePlace tile = *find_tile(p_global);
	const Eigen::Vector3d bend = field.get_tiles().get_bend(field.get_grid().get_index(tile.x, tile.z)).cast<double>();
	return to_godot(Eigen::Vector3d(_to_world.linear() * bend));
}

} // namespace grass

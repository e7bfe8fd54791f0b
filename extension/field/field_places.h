// SPDX-License-Identifier: MIT
// Finds what grows at places of a field: converts global places to tiles and grass, and back. Made for one call.
#pragma once

#include "core/paint/ground_band.h"
#include "field/standing_field.h"
#include "shared/convert.h"

#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <optional>
#include <span>
#include <vector>

namespace grass {

class FieldPlaces {
public:
	// Looks at a field. p_transform: of the field; global, without scale. p_band: places outside of it belong to another field.
	FieldPlaces(const StandingField &p_standing, const godot::Transform3D &p_transform, const GroundBand &p_band) :
			_standing(p_standing), _to_world(to_eigen(p_transform)), _band(p_band) {}

	std::optional<TilePlace> find_tile(const godot::Vector3 &p_global) const; // nothing outside of the field
	godot::Vector3 get_tile_centre(const godot::Vector2i &p_tile) const; // global
	// Reads the field as it is drawn. Knots are global, without wind, GRASS_KNOTS for each blade.
	enum class Knots {
		KNOWN, // of awake blades on the GPU, the knots that were read back last; at rest until any were
		EXACT, // as they are now; waits for the GPU if one of the blades is awake
	};
	godot::PackedVector3Array find_knots(std::span<const BladeNumber> p_blades, Knots p_knots) const;
	// Returns the blades of a tile that exists, or those that grow up to p_radius metres from a place.
	std::vector<BladeNumber> blades_of(const godot::Vector2i &p_tile) const;
	std::vector<BladeNumber> find_blades(const godot::Vector3 &p_global, double p_radius) const;
	int64_t count_blades(const godot::Vector3 &p_global, double p_radius) const; // at which find_blades() looks
	bool has_blade(BladeNumber p_blade) const { return p_blade >= 0 && p_blade < number_of(int(_standing.get_grid().get_tile_count()), 0); }
	double density_at(const godot::Vector3 &p_global) const; // share of the blades that grow, 0..1
	double height_at(const godot::Vector3 &p_global) const; // of the grass at rest, metres
	double cover_between(const godot::Vector3 &p_from, const godot::Vector3 &p_to) const; // see hidden_share()
	// Returns the mean offset of the tips around a place from rest, in global axes, as shares of the blades' lengths.
	godot::Vector3 bend_at(const godot::Vector3 &p_global) const;

private:
	Eigen::Vector3d from_global(const godot::Vector3 &p_global) const { return _to_world.inverse(Eigen::Isometry) * to_eigen(p_global); }
	template <typename F> double read_at(const godot::Vector3 &p_global, F &&p_read) const;

	const StandingField &_standing;
	Eigen::Affine3d _to_world;
	GroundBand _band;
};

// Returns its column and row; (-1, -1) if there is none.
godot::Vector2i to_script(const std::optional<TilePlace> &p_tile);

} // namespace grass

// SPDX-License-Identifier: MIT
// Answers the queries of scripts about tiles, blades and the grass at a place: checks arguments, makes the field if there is none yet, and
// reads it. Places are global. A tile is named by its column (along x) and row (along z).
#pragma once

#include "field/field_life.h"
#include "field/field_places.h"
#include "physics/field_bodies.h"

#include <godot_cpp/variant/packed_int64_array.hpp>

#include <optional>
#include <span>

namespace grass {

class FieldQueries {
public:
	FieldQueries(FieldHost &p_host, const FieldLife &p_life, StandingField &p_standing, const FieldProperties &p_properties,
			const FieldBodies &p_bodies) :
			_host(p_host), _life(p_life), _standing(p_standing), _properties(p_properties), _bodies(p_bodies) {}

	int64_t get_blade_count() const;
	godot::Vector2i get_grid_size() const; // number of tiles along x and z
	double get_tile_size() const { return _standing.get_grid().get_tile_size(); } // metres
	std::optional<TilePlace> get_tile_at(const godot::Vector3 &p_global) const; // nothing outside the field
	godot::Vector3 get_tile_center(const godot::Vector2i &p_tile) const;
	bool is_tile_awake(const godot::Vector2i &p_tile) const;
	int64_t get_awake_tile_count() const;
	int64_t get_body_count() const { return _bodies.get_count(); }

	// Return knots from root to tip, 16 for each blade, without wind and without waiting: for an awake tile on the GPU they are at most
	// two ticks old.
	godot::PackedVector3Array get_knots(const godot::Vector2i &p_tile, int64_t p_blade);
	godot::PackedVector3Array get_tile_knots(const godot::Vector2i &p_tile);
	godot::PackedVector3Array get_blade_knots(const godot::PackedInt64Array &p_blades);
	godot::PackedVector3Array wait_for_knots(const godot::PackedInt64Array &p_blades); // their current state
	godot::PackedInt64Array get_tile_blades(const godot::Vector2i &p_tile) const;
	godot::PackedInt64Array find_blades(const godot::Vector3 &p_global, double p_radius);
	int64_t get_blade_species(const godot::Vector2i &p_tile, int64_t p_blade) const; // index in `species`

	bool is_grass_at(const godot::Vector3 &p_global) { return get_density_at(p_global) > 0.0; }
	double get_density_at(const godot::Vector3 &p_global);
	double get_height_at(const godot::Vector3 &p_global);
	double get_cover(const godot::Vector3 &p_from, const godot::Vector3 &p_to); // share of the view between them that blades hide
	double get_rustle(const godot::Node3D *p_body) const; // blades per second that it moves over
	godot::Vector3 get_bend_at(const godot::Vector3 &p_global);
	bool has_level_at(const godot::Vector3 &p_global) const; // within the field's size and the band of its ground

private:
	FieldPlaces places() const { return FieldPlaces(_standing, _host.field_transform(), _properties.ground_band()); }
	bool has_blades() const;
	bool has_tile(const godot::Vector2i &p_tile) const;
	bool has_all(const godot::PackedInt64Array &p_blades) const;
	bool is_inside(const char *p_what) const;
	bool prepare();
	godot::PackedVector3Array find_knots(std::span<const BladeNumber> p_blades, FieldPlaces::Knots p_knots);

	FieldHost &_host;
	const FieldLife &_life;
	StandingField &_standing;
	const FieldProperties &_properties;
	const FieldBodies &_bodies;
};

} // namespace grass

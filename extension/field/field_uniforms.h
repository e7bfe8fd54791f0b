// SPDX-License-Identifier: MIT
// The uniforms that a field's shaders read, besides the textures of patch, pool and map.
#pragma once

#include "core/blades/force.h"
#include "core/blades/wind.h"
#include "core/field/field_setup.h"
#include "draw/shared_shader.h"
#include "draw/species_look.h"
#include "field/field_properties.h"
#include "field/sun_map.h"

#include <span>
#include <vector>

namespace grass {

class FieldUniforms {
public:
	// Sets all uniforms of blades and ground.
	void set_all(const FieldProperties &p_properties, const FieldSetup &p_setup, const SetUniform &p_set) const;
	static void set_soil(const FieldProperties &p_properties, const SetUniform &p_set);
	static void set_clump(const ClumpParams &p_clump, const SetUniform &p_set);
	void set_wind(const FieldProperties &p_properties, const SetUniform &p_set) const;
	// Sets the directions of the field's axes in the world, for the wind. Returns whether they have changed.
	bool turn(const Eigen::Matrix3d &p_turn);
	// Sets the uniforms of species. p_species: the running field's. p_reach: share of the plants' distances. p_set: for blades and ground;
	// p_set_blades: for blades only.
	void set_species(const FieldSetup &p_setup, const std::vector<GrownSpecies> &p_species, const std::vector<DrawnPlant> &p_plants,
			float p_reach, const SetUniform &p_set, const SetUniform &p_set_blades);
	void set_light(const godot::Vector4 &p_other, const SetUniform &p_set); // see OtherLight
	void set_suns(const SunMap &p_suns, const SetUniform &p_set); // see find_sun_map()
	void set_wind_clock(const SetUniform &p_set);
	// Sets the wind's clock of the last frame, for motion vectors. Call it once in each frame. Returns whether the clock has run since.
	bool keep_wind_clock(const SetUniform &p_set);
	void join_wind(const FieldUniforms &p_other) { _wind = p_other._wind; } // gusts go on from one field to the other

	// Sets the forces on blades.
	void set_forces(std::span<const Force> p_forces, const TileGrid &p_grid, const SetUniform &p_set);
	// Lets the wind, or forces (p_has_forces), blow for p_delta seconds. Returns false if nothing blows.
	bool blow(const FieldProperties &p_properties, double p_delta, bool p_has_forces);
	int64_t get_cards_memory() const { return _cards.get_memory_usage(); } // bytes

private:
	void show_suns(const SetUniform &p_set) const;
	static void set_plants(const std::vector<DrawnPlant> &p_plants, float p_reach, const SetUniform &p_set);
	static void set_colors(const std::vector<GrownSpecies> &p_species, const SetUniform &p_set);

	WindClock _wind;
	Eigen::Matrix3d _turn = Eigen::Matrix3d::Identity();
	godot::Vector2 _clock, _drawn_clock, _clock_before; // that the shaders have; that the last frame had; that they have as that one's
	godot::Vector4 _light;
	SunMap _suns;
	float _mesh_share = 0.0f; // of the blades: those of species with a mesh
	Cards _cards;
	size_t _forces = 0; // that the shaders have
};

} // namespace grass

// SPDX-License-Identifier: MIT
// The properties of a GrassField that a user set, and what follows from them without a field. The node has the setters.
#pragma once

#include "core/base/tile_grid.h"
#include "core/blades/patch.h"
#include "core/field/field_params.h"
#include "core/lod/lod.h"
#include "core/paint/recovery.h"
#include "field/field_hook.h"
#include "field/field_params.h"
#include "field/field_species.h"
#include "physics/field_ground.h"
#include "resources/grass_map.h"

#include <godot_cpp/classes/texture2d.hpp>

#include <array>

namespace grass {

bool is_compatibility(); // the renderer

struct FieldProperties {
	FieldProperties(); // defaults

	double param(FieldParamId p_param) const { return params[size_t(p_param)]; }
	bool is_other_quality() const; // whether update_quality() has something to do
	[[nodiscard]] bool update_quality(); // returns whether the game has another level now
	// Return the number that is used of a property: scaled by the level of quality. A world scales the pools of its plots itself.
	double scaled(FieldParamId p_param) const;
	int64_t scaled_pool() const { return is_streamed ? pool_tiles : quality.scale_pool(pool_tiles); }
	TileGrid grid() const { return TileGrid::make(size.x, size.y, param(PARAM_DENSITY)); }
	FieldGround ground_band() const { return { { param(PARAM_GROUND_LOW), param(PARAM_GROUND_HIGH) }, ground_mask, ground_group }; }
	ClumpParams clump() const;
	LodParams lod() const;
	SolverParams solver() const; // without what is a species' own
	// Returns the parameters of a running field with these species.
	FieldParams field_params(const std::vector<GrownSpecies> &p_species) const;
	RecoveryRates recovery_rates(const std::vector<GrownSpecies> &p_species) const;
	// Append warnings: about the species; about simulation and the number of tiles; about the band of the ground.
	void warn_of_blades(godot::PackedStringArray &r_warnings) const;
	void warn_of_tiles(godot::PackedStringArray &r_warnings) const;
	void warn_of_ground(godot::PackedStringArray &r_warnings) const;

	godot::Vector2 size{ 32, 32 };
	// The place of the field's centre in the noise of clumps, stands, rules and wind, metres: (0, 0) but for the plots of a world.
	godot::Vector2i noise_origin;
	FieldSpecies species;
	FieldHook hook;
	godot::Ref<GrassMap> map;
	godot::Ref<godot::Texture2D> terrain_texture, terrain_colors; // the user's; the terrain's own, if it provides any
	const godot::Ref<godot::Texture2D> &find_terrain_texture() const {
		return terrain_texture.is_valid() ? terrain_texture : terrain_colors;
	}
	std::array<godot::Ref<godot::Texture2D>, SOIL_TEXTURES.size()> soil_textures;
	int64_t seed = 0, pool_tiles = TileParams().pool_size, collision_mask = 1, ground_mask = FieldGround::ALL_LAYERS;
	godot::StringName ground_group;
	bool simulated = true, measure_time = false, has_soil = true;
	Method method = SolverParams().method;
	SimulationDetail simulation_detail = FieldParams().detail;
	SleepMode sleep_mode = TileParams().sleep_mode;
	bool is_on_cpu = false;
	bool is_streamed = false; // a plot of a world: made in parts, a few a frame, from the first time on
	int64_t debug_view = GRASS_DEBUG_OFF;
	Quality quality; // of the game, as of this frame
	std::array<double, FIELD_PARAMS.size()> params;
	std::array<godot::Color, FIELD_COLORS.size()> colors;
};

} // namespace grass

// SPDX-License-Identifier: MIT
#include "field/field_properties.h"

#include "resources/grass_quality.h"

#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

bool is_compatibility() {
	static const bool is = RenderingServer::get_singleton()->get_current_rendering_method() == String("gl_compatibility");
	return is;
}

namespace {

// Tiles along a side whose numbers survive the 16-bit floats that the Compatibility renderer packs an instance's numbers in.
constexpr int EXACT_TILES = 2048;

} // namespace

FieldProperties::FieldProperties() {
	for (size_t i = 0; i < params.size(); i++) {
		params[i] = FIELD_PARAMS[i].tunable.initial;
	}
	for (size_t i = 0; i < colors.size(); i++) {
		colors[i] = Color(FIELD_COLORS[i].red, FIELD_COLORS[i].green, FIELD_COLORS[i].blue);
	}
}

bool FieldProperties::is_other_quality() const {
	return quality != current_quality();
}

bool FieldProperties::update_quality() {
	return std::exchange(quality, current_quality()) != quality;
}

double FieldProperties::scaled(FieldParamId p_param) const {
	const FieldParam &info = FIELD_PARAMS[size_t(p_param)];
	const double value = param(p_param);
	return info.factor == QUALITY_FACTORS ? value : quality.scale(info.factor, info.tunable, value);
}

ClumpParams FieldProperties::clump() const {
	ClumpParams clump{ float(param(PARAM_CLUMP_SIZE)), float(param(PARAM_CLUMP_HEIGHT)), float(param(PARAM_CLUMP_LEAN)),
		float(param(PARAM_CLUMP_TINT)) };
	clump.set_origin(Eigen::Vector2d(noise_origin.x, noise_origin.y));
	return clump;
}

LodParams FieldProperties::lod() const {
	LodParams lod;
	lod.far = float(scaled(PARAM_LOD_FAR));
	lod.error = float(scaled(PARAM_LOD_ERROR));
	lod.pixels_min = float(scaled(PARAM_PIXELS_MIN));
	lod.shadow_coarseness = float(scaled(PARAM_SHADOW_COARSENESS));
	return lod.sanitised();
}

SolverParams FieldProperties::solver() const {
	SolverParams solver;
	solver.method = method;
	solver.friction = param(PARAM_FRICTION);
	solver.swing_speed_max = param(PARAM_SWING_SPEED_MAX);
	solver.iterations = int(param(PARAM_ITERATIONS));
	solver.contact_rate = scaled(PARAM_CONTACT_RATE);
	return solver;
}

FieldParams FieldProperties::field_params(const std::vector<GrownSpecies> &p_species) const {
	FieldParams field;
	field.species = solvers_of(p_species, solver());
	field.solver = field.species.front();
	if (species.is_plain()) {
		field.species.clear();
	}
	field.contact_distance = param(PARAM_CONTACT_DISTANCE);
	field.detail = simulation_detail;
	field.budget = param(PARAM_SIMULATION_BUDGET);
	field.sleep_mode = sleep_mode;
	field.sleep_delay = param(PARAM_SLEEP_DELAY);
	field.sleep_motion = param(PARAM_SLEEP_MOTION);
	field.settle_time = param(PARAM_SETTLE_TIME);
	return field;
}

RecoveryRates FieldProperties::recovery_rates(const std::vector<GrownSpecies> &p_species) const {
	RecoveryRates rates;
	rates.growth = 1e-3 * param(PARAM_REGROWTH) / 60.0;
	for (size_t s = 0; s < p_species.size(); s++) {
		rates.wear[s] = p_species[s].species->get_wear_recovery() / 60.0;
	}
	return rates;
}

void FieldProperties::warn_of_blades(PackedStringArray &r_warnings) const {
	if (species.prepare_patches() && species.join()->is_empty()) {
		r_warnings.push_back(vformat("No grass grows: %s", species.join()->empty_because));
	}
	species.warn(r_warnings, param(PARAM_DENSITY));
	if (species.has_plant_scenes() && param(PARAM_PLANT_NODES_MAX) == 0.0) {
		r_warnings.push_back("`plant_nodes_max` is 0, so no plant has a node of its `plant_scene`. Raise it.");
	}
}

void FieldProperties::warn_of_tiles(PackedStringArray &r_warnings) const {
	if (simulated && collision_mask == 0) {
		r_warnings.push_back("`collision_mask` is empty, so no body bends the grass. Set the layers of the bodies that should, or turn "
							 "`simulated` off.");
	}
	if (simulated && pool_tiles == 0) {
		r_warnings.push_back("`pool_tiles` is 0, so no tile can be simulated. Raise it, or turn `simulated` off.");
	}
	if (simulated && param(PARAM_SIMULATION_BUDGET) > 0.0 && simulation_detail == SimulationDetail::WHOLE) {
		r_warnings.push_back(
				"`simulation_budget` has no effect while `simulation_detail` is *Whole*. Set it to 0, or `simulation_detail` to "
				"*Seen*.");
	}
	const TileGrid tiles = grid();
	if (is_compatibility() && std::max(tiles.get_tiles_x(), tiles.get_tiles_z()) > EXACT_TILES) {
		r_warnings.push_back(vformat("The Compatibility renderer distinguishes at most %d tiles along a side. Beyond that, tiles share "
									 "their clumps, wind and map. Lower `density` or `size`, or use several fields.",
				EXACT_TILES));
	}
	if (tiles.was_limited()) {
		r_warnings.push_back("The field has more tiles than 8192 along a side, so it is smaller than `size`. Lower `density` or `size`, or "
							 "use several fields.");
	}
}

void FieldProperties::warn_of_ground(PackedStringArray &r_warnings) const {
	if (ground_band().is_empty()) {
		r_warnings.push_back(
				"`ground_low` is not below `ground_high`, so no ground and no place belongs to the field. Lower `ground_low`, or "
				"raise `ground_high`.");
	}
	if (ground_mask == 0) {
		r_warnings.push_back("`ground_mask` is empty, so no body is ground. Set the layers of the ground.");
	}
}

} // namespace grass

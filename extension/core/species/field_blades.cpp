// SPDX-License-Identifier: MIT
#include "core/species/field_blades.h"

#include "core/base/half.h"
#include "core/blades/blade.h"

namespace grass {

FieldBlades::FieldBlades(const TileGrid &p_grid, std::shared_ptr<const Patch> p_patch, const ClumpParams &p_clump, uint32_t p_seed,
		std::shared_ptr<const SpeciesMix> p_species, const MapLayers *p_map) :
		_grid(p_grid), _patch(std::move(p_patch)), _clump(p_clump), _seed(p_seed), _species(std::move(p_species)), _map(p_map) {}

Eigen::Vector3f FieldBlades::get_texel(int p_blade, int p_knot) const {
	const uint16_t *halves = &_patch->texels[Patch::texel_index(p_blade, p_knot)];
	return { half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]) };
}

int FieldBlades::first_of(int p_tile_x, int p_tile_z) const {
	return int(grass_tile_start(uint32_t(p_tile_x), uint32_t(p_tile_z), _seed));
}

int FieldBlades::get_species(int p_tile_x, int p_tile_z, int p_blade, float *r_height) const {
	if (!_species) {
		return 0;
	}
	const auto root_of = [this](int p_of) -> Eigen::Vector2f { return get_texel(p_of, 0).head<2>(); };
	return _species->choose_species(p_tile_x, p_tile_z, p_blade, root_of, _map, r_height);
}

FieldBlades::Pose FieldBlades::get_pose(int p_tile_x, int p_tile_z, int p_blade) const {
	Pose pose;
	pose.blade = first_of(p_tile_x, p_tile_z) + p_blade;
	float height = 1.0f;
	pose.species = get_species(p_tile_x, p_tile_z, p_blade, &height);
	pose.blade += GRASS_PATCH_BLADES * pose.species;
	pose.root = get_texel(pose.blade, 0).head<2>();
	const Eigen::Vector2f place = root_place(Eigen::Vector2f(float(p_tile_x), float(p_tile_z)), pose.root,
			Eigen::Vector2f(float(_grid.get_tiles_x()), float(_grid.get_tiles_z())), float(_grid.get_tile_size()));
	pose.clump = clump_at(place, _clump);
	pose.clump.height *= height;
	if (_map) {
		const Growth here = _map->sample(place);
		pose.clump = glsl::grass_grown(pose.clump, here, blade_length(get_texel(pose.blade, 1)));
		pose.ground = here.ground;
		pose.density = here.density;
	}
	return pose;
}

// Equals BladePoint::presence in shaders/draw/pose.gdshaderinc.
bool FieldBlades::stands(int p_tile_x, int p_tile_z, int p_blade) const {
	const Pose pose = get_pose(p_tile_x, p_tile_z, p_blade);
	const uint32_t bits = grass_tile_bits(uint32_t(p_tile_x), uint32_t(p_tile_z), _seed) + uint32_t(p_blade + GRASS_BLADES_PER_TILE);
	const uint16_t width = _patch->texels[Patch::texel_index(pose.blade, 0) + 3];
	return width != 0 && glsl::grass_presence(pose.density, glsl::grass_random(grass_hash(bits)).x) > 0.0f;
}

// Equals begin_point() in shaders/draw/pose.gdshaderinc for a plant.
FieldBlades::Standing FieldBlades::get_standing(const Pose &p_pose, int p_tile_x, int p_tile_z, int p_blade, const Border &p_border) const {
	Standing standing;
	const Eigen::Vector2f tiles(float(_grid.get_tiles_x()), float(_grid.get_tiles_z()));
	const float tile_size = float(_grid.get_tile_size());
	const Eigen::Vector2f place = root_place(Eigen::Vector2f(float(p_tile_x), float(p_tile_z)), p_pose.root, tiles, tile_size);
	const glsl::vec2 size = to_glsl(Eigen::Vector2f(tiles * tile_size));
	const float border = glsl::grass_border(to_glsl(place), size, p_border.fade, p_border.waver);
	const float density = p_pose.density * border;
	float presence = _patch->texels[Patch::texel_index(p_pose.blade, 0) + 3] != 0 ? 1.0f : 0.0f;
	if (density < 1.0f) {
		const uint32_t bits = grass_tile_bits(uint32_t(p_tile_x), uint32_t(p_tile_z), _seed) + uint32_t(p_blade + GRASS_BLADES_PER_TILE);
		presence *= glsl::grass_presence(density, glsl::grass_random(grass_hash(bits)).x);
		presence *= float(GRASS_BORDER_HEIGHT) + (1.0f - float(GRASS_BORDER_HEIGHT)) * border;
	}
	const float in_patch = blade_length(get_texel(p_pose.blade, 1));
	const float whole = in_patch * clump_at(place, _clump).height * (_map ? _map->sample(place).height : 1.0f);
	standing.angle = get_texel(p_pose.blade, 0).z();
	standing.length = whole * presence;
	standing.left = presence * std::min(in_patch * p_pose.clump.height / std::max(whole, 1e-4f), 1.0f);
	return standing;
}

void FieldBlades::find_plants(int p_tile_x, int p_tile_z, uint32_t p_species, std::vector<StandingPlant> &r_plants) const {
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const int species = get_species(p_tile_x, p_tile_z, b), blade = first_of(p_tile_x, p_tile_z) + b + GRASS_PATCH_BLADES * species;
		if ((p_species >> species & 1u) != 0 && _patch->texels[Patch::texel_index(blade, 0) + 3] != 0) {
			r_plants.push_back({ uint8_t(b), uint8_t(species), get_texel(blade, 0).head<2>() });
		}
	}
}

Eigen::Vector3f FieldBlades::get_rest_knot(const Pose &p_pose, int p_knot) const {
	return rest_knot(get_texel(p_pose.blade, p_knot), p_knot, p_pose.clump);
}

SlotGrowth FieldBlades::grow(const GrassSlot &p_slot) const {
	SlotGrowth growth;
	growth.slot = p_slot.tile.w;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const Pose pose = get_pose(p_slot.tile.x, p_slot.tile.y, b);
		growth.blades[size_t(b)] = { pose.clump.height, pose.clump.lean.x, pose.clump.lean.y, pose.ground };
		growth.species[size_t(b)] = uint8_t(pose.species);
	}
	return growth;
}

} // namespace grass

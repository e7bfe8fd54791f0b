// SPDX-License-Identifier: MIT
#include "core/lod/plant_cull.h"

#include "core/base/hash.h"

#include <algorithm>

namespace grass {

namespace {

// Most tiles whose plants are cached. Fewer: when a camera turns, they are computed again.
constexpr size_t KNOWN_TILES = 65536;

bool is_wanted(const FieldView &p_view, const Eigen::Vector3f &p_middle, const Eigen::Vector3f &p_half, float p_distance) {
	return std::ranges::any_of(p_view.cameras, [&](const ViewCamera &p_camera) {
		const float away = (p_camera.eye - p_middle).norm() - p_half.norm();
		const bool is_seen = grass_tile_visible(p_camera.planes, p_middle, p_half, 0.0f, Eigen::Vector3f::Zero());
		return away < p_distance && (is_seen || (away < p_view.shadow_distance && casts_into(p_view, p_camera, p_middle, p_half)));
	});
}

bool is_near(const FieldView &p_view, const Eigen::Vector3f &p_root, const TileCover::Tile &p_ground, const PlantKind &p_kind) {
	return std::ranges::any_of(p_view.cameras, [&](const ViewCamera &p_camera) {
		const float height = std::clamp(p_camera.eye.y(), p_ground.low, p_ground.high);
		const float away = (p_camera.eye - Eigen::Vector3f(p_root.x(), height, p_root.z())).norm();
		return away >= p_kind.nearest && away < p_kind.distance;
	});
}

using Shares = std::array<float, GRASS_MAX_SPECIES>;

// [Eq L13] Returns the share of a tile's plants to draw, for each species. p_middle: middle of the tile's box.
Shares find_shares(const FieldView &p_view, const PlantCull::Kinds &p_kinds, const std::vector<StandingPlant> &p_plants,
		const TileCover::Tile &p_ground, const Eigen::Vector3f &p_middle) {
	Shares counts{}, shares{};
	for (const StandingPlant &plant : p_plants) {
		counts[plant.species] += 1.0f;
	}
	for (size_t species = 0; species < shares.size(); species++) {
		const PlantKind &kind = p_kinds[species];
		if (counts[species] <= 0.0f || kind.distance <= 0.0f) {
			continue;
		}
		const float height = std::min(kind.length, p_ground.cut);
		const float cover = counts[species] * p_ground.grown * kind.cover * height / kind.length;
		for (const ViewCamera &camera : p_view.cameras) {
			const Eigen::Vector3f to_eye = camera.eye - p_middle;
			const bool hides = camera.pixel_slope > 0.0f && p_view.lod.pixels_min > 0.0f; // an orthogonal camera has no eye position
			const float share =
					hides ? grass_lod_in_sight(0.5f * cover, std::hypot(to_eye.x(), to_eye.z()), to_eye.y(), height, p_ground.slope) : 1.0f;
			shares[species] = std::max(shares[species], share);
		}
		shares[species] = grass_lod_plants(shares[species], cover, p_view.shadow_distance > 0.0f ? 1.0f : 0.0f);
	}
	return shares;
}

// Returns the tiles within p_distance of a camera.
TileRange around(const CullField &p_field, const FieldView &p_view, float p_distance) {
	Eigen::Vector2d low(1e30, 1e30), high(-1e30, -1e30);
	for (const ViewCamera &camera : p_view.cameras) {
		const Eigen::Vector2d eye(camera.eye.x(), camera.eye.z());
		low = low.cwiseMin(eye);
		high = high.cwiseMax(eye);
	}
	return p_field.grid.get_range(low.x(), high.x(), low.y(), high.y(), double(p_distance) + p_field.grid.get_tile_size());
}

} // namespace

const PlantCull::Plants &PlantCull::find(int p_index, int p_x, int p_z, const PlantsOf &p_plants_of) {
	if (const auto known = _known.find(p_index); known != _known.end()) {
		return known->second;
	}
	if (_known.size() >= KNOWN_TILES) {
		_known.clear();
	}
	Plants &plants = _known[p_index];
	p_plants_of(p_x, p_z, plants);
	return plants;
}

void PlantCull::choose(const CullField &p_field, const FieldView &p_view, const TileCover *p_cover, const TileCull::SlotOf &p_slot_of,
		const PlantsOf &p_plants_of, const Kinds &p_kinds) {
	for (std::vector<float> &instances : _instances) {
		instances.clear();
	}
	const float farthest = std::ranges::max(p_kinds, {}, &PlantKind::distance).distance;
	if (farthest <= 0.0f || p_view.cameras.empty()) {
		return;
	}
	const float side = 0.5f * float(p_field.grid.get_tile_size()) + p_field.overhang;
	const TileRange tiles = around(p_field, p_view, farthest);
	for (int z = tiles.z_begin; z < tiles.z_end; z++) {
		for (int x = tiles.x_begin; x < tiles.x_end; x++) {
			const TileCover::Tile ground = p_cover != nullptr ? p_cover->get(x, z) : TileCover::FULL;
			const Eigen::Vector3f centre = p_field.grid.get_centre(x, z).cast<float>();
			const float half_height = 0.5f * (p_field.height + ground.high - ground.low);
			const Eigen::Vector3f middle = centre + Eigen::Vector3f(0.0f, ground.low + half_height, 0.0f);
			if (ground.is_bare() || !is_wanted(p_view, middle, { side, half_height, side }, farthest)) {
				continue;
			}
			const int index = p_field.grid.get_index(x, z), slot = p_slot_of(index);
			const uint32_t column = uint32_t(x), row = uint32_t(z);
			const Plants &plants = find(index, x, z, p_plants_of);
			const Shares shares = find_shares(p_view, p_kinds, plants, ground, middle);
			const float hash = grass_tile_hash(column, row, p_field.seed);
			for (const StandingPlant &plant : plants) {
				const Eigen::Vector2f aside = (plant.root - Eigen::Vector2f(0.5f, 0.5f)) * float(p_field.grid.get_tile_size());
				const Eigen::Vector3f root = centre + Eigen::Vector3f(aside.x(), 0.0f, aside.y());
				const float presence = grass_lod_plant(plant.blade, p_kinds[plant.species].stems, shares[plant.species], hash);
				if (presence <= 0.0f) {
					continue;
				}
				const uint32_t start = grass_tile_start(column, row, p_field.seed) / GRASS_START_STRIDE;
				const int high = slot == GRASS_NO_SLOT ? 0 : slot / GRASS_SLOT_HALF;
				const float values[GRASS_INSTANCE_FLOATS] = { 1.0f, 0.0f, 0.0f, 0.0f, // the shader moves it to its tile's place
					0.0f, 1.0f, 0.0f, 0.0f, //
					0.0f, 0.0f, 1.0f, 0.0f, //
					float(x), float(z), float(plant.blade), presence, //
					float(start), float(slot == GRASS_NO_SLOT ? GRASS_NO_SLOT : slot % GRASS_SLOT_HALF), hash, float(high) };
				for (int stage = 0; stage < GRASS_PLANT_STAGES; stage++) {
					const size_t number = size_t(plant.species + stage * GRASS_MAX_SPECIES);
					if (p_kinds[number].distance > 0.0f && is_near(p_view, root, ground, p_kinds[number])) {
						_instances[number].insert(_instances[number].end(), std::begin(values), std::end(values));
					}
				}
			}
		}
	}
}

size_t PlantCull::get_memory_usage() const {
	size_t bytes = _known.size() * (sizeof(std::pair<int, Plants>) + 2 * sizeof(void *));
	for (const auto &[tile, plants] : _known) {
		bytes += plants.capacity() * sizeof(StandingPlant);
	}
	for (const std::vector<float> &instances : _instances) {
		bytes += instances.capacity() * sizeof(float);
	}
	return bytes;
}

} // namespace grass

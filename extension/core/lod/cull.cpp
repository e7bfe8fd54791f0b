// SPDX-License-Identifier: MIT
#include "core/lod/cull.h"

#include "core/base/hash.h"

#include <algorithm>
#include <cmath>

namespace grass {

float lod_in_sight(const CullField &p_field, const ViewCamera &p_camera, const LodParams &p_lod, const TileCover::Tile &p_ground,
		float p_away, float p_above, float p_pixel) {
	if (p_camera.pixel_slope <= 0.0f || p_lod.pixels_min <= 0.0f) {
		return 1.0f; // an orthogonal camera has no eye position
	}
	const float height = p_ground.cut < float(GRASS_UNCUT) ? std::min(p_field.size.length, p_ground.cut) : p_field.size.length;
	const float cover = p_ground.grown * grass_lod_cover(p_field.size.width, height, float(p_field.grid.get_tile_size()));
	const float share = grass_lod_in_sight(cover, p_away, p_above, height, p_ground.slope);
	return share * grass_lod_ends(height / (p_lod.pixels_min * p_pixel), share, p_lod.is_carried ? 1.0f : 0.0f);
}

bool casts_into(const FieldView &p_view, const ViewCamera &p_camera, const Eigen::Vector3f &p_middle, const Eigen::Vector3f &p_half) {
	const Eigen::Vector3f none = Eigen::Vector3f::Zero();
	return grass_tile_visible(p_camera.planes, p_middle, p_half, p_view.shadow_margin, none) ||
			std::any_of(p_view.falls.begin(), p_view.falls.end(),
					[&](const Eigen::Vector3f &p_fall) { return grass_tile_visible(p_camera.planes, p_middle, p_half, 0.0f, p_fall); });
}

void TileCull::choose(
		const CullField &p_field, const FieldView &p_view, const TileCover *p_cover, const SlotOf &p_slot_of, LevelSet p_levels) {
	_levels = p_levels;
	for (std::vector<float> &instances : _instances) {
		instances.clear();
	}
	for (int z = 0; z < p_field.grid.get_tiles_z(); z++) {
		for (int x = 0; x < p_field.grid.get_tiles_x(); x++) {
			const TileCover::Tile ground = p_cover != nullptr ? p_cover->get(x, z) : TileCover::FULL;
			if (!ground.is_bare()) {
				choose_tile(p_field, p_view, ground, x, z, p_slot_of);
			}
		}
	}
	_left_out = { leave_out(0, GRASS_LOD_LEVELS, p_field.room[0], p_field.seed),
		leave_out(GRASS_LOD_LEVELS, GRASS_ALL_LEVELS, p_field.room[1], p_field.seed) };
	_blades = { count_blades(0, GRASS_LOD_LEVELS), count_blades(GRASS_LOD_LEVELS, GRASS_ALL_LEVELS) };
}

void TileCull::choose_tile(
		const CullField &p_field, const FieldView &p_view, const TileCover::Tile &p_ground, int p_x, int p_z, const SlotOf &p_slot_of) {
	const float side = 0.5f * float(p_field.grid.get_tile_size()) + p_field.overhang;
	const float half_height = 0.5f * (p_field.height + p_ground.high - p_ground.low);
	const Eigen::Vector3f half(side, half_height, side);
	const Eigen::Vector3f middle =
			p_field.grid.get_centre(p_x, p_z).cast<float>() + Eigen::Vector3f(0.0f, p_ground.low + half_height, 0.0f);
	LodNeed seen, casting;
	for (const ViewCamera &camera : p_view.cameras) {
		const float distance = std::max((camera.eye - middle).norm(), camera.near), pixel = camera.pixel_at(distance);
		const float lod_distance = camera.pixel_slope > 0.0f ? distance : camera.near; // an orthogonal camera sees all distances alike
		if (grass_tile_visible(camera.planes, middle, half, 0.0f, Eigen::Vector3f::Zero())) {
			const Eigen::Vector3f to_eye = camera.eye - middle;
			const float away = std::hypot(to_eye.x(), to_eye.z());
			const float shown = lod_in_sight(p_field, camera, p_view.lod, p_ground, away, to_eye.y(), pixel);
			seen.add(p_view.lod, p_field.size, lod_distance, camera.near, pixel, shown);
		}
		if (distance < p_view.shadow_distance && casts_into(p_view, camera, middle, half)) {
			casting.add(p_view.lod.of_shadows(distance, p_view.shadow_distance), p_field.size, lod_distance, camera.near, pixel);
		}
	}
	add_tile(p_field, p_x, p_z, seen, 0, GRASS_LOD_LEVELS, p_slot_of);
	add_tile(p_field, p_x, p_z, casting, GRASS_LOD_LEVELS, GRASS_ALL_LEVELS, p_slot_of);
}

void TileCull::add_tile(
		const CullField &p_field, int p_x, int p_z, const LodNeed &p_need, int p_first, int p_end, const SlotOf &p_slot_of) {
	const uint32_t x = uint32_t(p_x), z = uint32_t(p_z);
	const float hash = grass_tile_hash(x, z, p_field.seed);
	const float shown = grass_lod_shown(p_need.blades, hash);
	if (shown <= 0.0f) {
		return;
	}
	const float blades = p_need.blades < 1.0f ? p_need.blades : shown;
	const float covering = grass_lod_shown(p_need.covering, hash);
	const int segments = std::min(grass_lod_segments(p_need.segments), get_lod_level(p_first).segments);
	const int level = find_lod_level(shown, segments, p_first, p_end, _levels);
	const int slot = p_slot_of(p_field.grid.get_index(p_x, p_z));
	const int low = slot == GRASS_NO_SLOT ? GRASS_NO_SLOT : slot % GRASS_SLOT_HALF;
	const int high = slot == GRASS_NO_SLOT ? 0 : slot / GRASS_SLOT_HALF;
	const auto start = grass_tile_start(x, z, p_field.seed) / GRASS_START_STRIDE; // divides without remainder
	const float values[GRASS_INSTANCE_FLOATS] = { 1.0f, 0.0f, 0.0f, 0.0f, // the shader moves it to its tile's place
		0.0f, 1.0f, 0.0f, 0.0f, //
		0.0f, 0.0f, 1.0f, 0.0f, //
		float(p_x), float(p_z), blades, grass_lod_morph(p_need.segments, segments), //
		float(start), float(low), hash, float(high) + float(GRASS_COVERING_SCALE / GRASS_BLADES_PER_TILE) * covering };
	_instances[size_t(level)].insert(_instances[size_t(level)].end(), std::begin(values), std::end(values));
}

int64_t TileCull::leave_out(int p_first, int p_end, uint32_t p_room, uint32_t p_seed) {
	int64_t chosen = 0, kept = 0;
	for (int level = p_first; level < p_end; level++) {
		chosen += get_count(level);
	}
	if (chosen <= int64_t(p_room)) {
		return 0;
	}
	const auto rank_of = [&](int p_level, const float *p_tile) {
		return grass_lod_rank(p_level, grass_tile_turn(uint32_t(p_tile[INSTANCE_TILE]), uint32_t(p_tile[INSTANCE_TILE + 1]), p_seed));
	};
	std::array<uint32_t, GRASS_RANKS> counts{};
	for (int level = p_first; level < p_end; level++) {
		const std::vector<float> &instances = _instances[size_t(level)];
		for (size_t at = 0; at < instances.size(); at += GRASS_INSTANCE_FLOATS) {
			counts[rank_of(level, &instances[at])]++;
		}
	}
	const uint32_t ranks = grass_lod_ranks(counts, p_room);
	for (int level = p_first; level < p_end; level++) {
		std::vector<float> &instances = _instances[size_t(level)];
		size_t end = 0;
		for (size_t at = 0; at < instances.size(); at += GRASS_INSTANCE_FLOATS) {
			if (rank_of(level, &instances[at]) < ranks) {
				std::copy_n(instances.begin() + ptrdiff_t(at), GRASS_INSTANCE_FLOATS, instances.begin() + ptrdiff_t(end));
				if (get_lod_level(level).segments == 1) {
					instances[end + INSTANCE_MORPH] = grass_lod_left_out(ranks);
				}
				end += GRASS_INSTANCE_FLOATS;
			}
		}
		instances.resize(end);
		kept += get_count(level);
	}
	return chosen - kept;
}

int64_t TileCull::count_blades(int p_first, int p_end) const {
	int64_t blades = 0;
	for (int level = p_first; level < p_end; level++) {
		const std::span<const float> instances = get_instances(level);
		for (size_t at = 0; at < instances.size(); at += GRASS_INSTANCE_FLOATS) {
			blades += int64_t(std::ceil(instances[at + INSTANCE_BLADES]));
		}
	}
	return blades;
}

size_t TileCull::get_memory_usage() const {
	size_t floats = 0;
	for (const std::vector<float> &instances : _instances) {
		floats += instances.capacity();
	}
	return floats * sizeof(float);
}

} // namespace grass

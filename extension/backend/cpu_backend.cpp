// SPDX-License-Identifier: MIT
#include "backend/cpu_backend.h"

#include "convert.h"
#include "core/base/hash.h"
#include "draw/blade_mesh.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/time.hpp>
#include <godot_cpp/core/memory.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

using namespace godot;

namespace grass {

namespace {
constexpr int ROW_TEXELS = GRASS_KNOTS * GRASS_POOL_BLADES_PER_ROW;
constexpr int FIRST_ROWS = 64; // of the pool texture: 512 KiB
// Ticks between looks at what the pool takes, and how many in a row must find it at least four times too large: three seconds. Then
// room for twice what is awake is kept. Less: memory comes and goes with every body that passes.
constexpr int LOOK_EVERY = 60, LOW_LOOKS = 3, MUCH = 4;
constexpr int FIRST_INSTANCES = 64; // of a level's MultiMesh: 5 KiB; grows with the tiles in view
constexpr size_t INSTANCE_TILE = 12, INSTANCE_BLADES = 14, INSTANCE_MORPH = 15; // among an instance's floats

int rows_for(int p_highest_slot) {
	return std::max(FIRST_ROWS, int(std::bit_ceil(unsigned(p_highest_slot + 1))));
}
} // namespace

CpuBackend::CpuBackend(const FieldSetup &p_setup) :
		_setup(p_setup),
		_pool(p_setup.patch, p_setup.pool_tiles),
		_parallel(memnew(Parallel)),
		_patch_texture(make_patch_texture(*p_setup.patch)),
		_materials(shader_features(p_setup)) {
	_materials.set("patch_knots", _patch_texture);
	_materials.set("blade_length", _setup.blade_length());
	_changed_slots.reset(p_setup.pool_tiles, false);
	update_pool_texture();
}

CpuBackend::~CpuBackend() {
	memdelete(_parallel);
}

bool CpuBackend::set_field(const FieldSetup &p_setup) {
	if (!p_setup.has_meshes_of(_setup)) {
		return false;
	}
	_materials.set_features(shader_features(p_setup));
	if (p_setup.patch != _setup.patch) {
		_pool.set_patch(p_setup.patch);
		update_patch_texture(_patch_texture, *p_setup.patch);
		_materials.set("blade_length", p_setup.blade_length());
	}
	if (p_setup.pool_tiles != _setup.pool_tiles) {
		_pool.set_slots(p_setup.pool_tiles);
		_changed_slots.reset(p_setup.pool_tiles, false);
		_highest_slot = std::min(_highest_slot, p_setup.pool_tiles - 1);
	}
	_setup = p_setup;
	_slot_of_tile.clear();
	_cover.reset(); // of the other grid; set_cover() follows
	_tiles_changed = true;
	for (FieldInstance &level : _levels) {
		level.set_bounds(field_bounds(_setup));
	}
	return true;
}

void CpuBackend::step(const StepInput &p_input) {
	const uint64_t begin = Time::get_singleton()->get_ticks_usec();
	const int64_t blades_before = _pool.get_simulated_blades();
	_pool.step(p_input, [this](int p_count, const std::function<void(int)> &p_body) { _parallel->run(p_count, p_body); });
	for (const GrassSlot &slot : p_input.slots) {
		_tiles_changed = _tiles_changed || (slot.list.w & (GRASS_SLOT_FRESH | GRASS_SLOT_RETIRED)) != 0;
		if (slot.list.w & GRASS_SLOT_RETIRED) {
			_slot_of_tile.erase(slot.tile.z);
		} else {
			_slot_of_tile[slot.tile.z] = slot.tile.w;
			_changed_slots.insert(slot.tile.w);
			_highest_slot = std::max(_highest_slot, slot.tile.w);
		}
	}
	_step_number = p_input.number;
	_statistics.steps++;
	_statistics.simulated_blades += _pool.get_simulated_blades() - blades_before;
	if (_measure) {
		_statistics.simulate_ms = double(Time::get_singleton()->get_ticks_usec() - begin) * 1e-3;
	}
}

void CpuBackend::tidy() {
	if (_ticks_to_look-- > 0) {
		return;
	}
	_ticks_to_look = LOOK_EVERY - 1;
	int highest = -1;
	for (const auto &[tile, slot] : _slot_of_tile) {
		highest = std::max(highest, slot);
	}
	const int needed = rows_for(highest);
	_low_looks = needed * MUCH <= rows_for(_highest_slot) ? _low_looks + 1 : 0;
	if (_low_looks >= LOW_LOOKS) {
		_low_looks = 0;
		_highest_slot = 2 * needed - 1;
		_pool.trim(_highest_slot + 1); // the texture follows in the next frame
	}
}

void CpuBackend::draw(const FieldView &p_view) {
	if (!_levels[0].is_created()) {
		return;
	}
	const uint64_t begin = Time::get_singleton()->get_ticks_usec();
	update_pool_texture();
	if (!_tiles_changed && _view == p_view) {
		return; // the same view of the same tiles: what is in the MultiMeshes still holds
	}
	choose_tiles(p_view);
	_view = p_view;
	_tiles_changed = false;
	_statistics.culls++;
	if (_measure) {
		_statistics.cull_ms = double(Time::get_singleton()->get_ticks_usec() - begin) * 1e-3;
	}
}

void CpuBackend::choose_tiles(const FieldView &p_view) {
	for (std::vector<float> &instances : _instances) {
		instances.clear();
	}
	for (int z = 0; z < _setup.grid.get_tiles_z(); z++) {
		for (int x = 0; x < _setup.grid.get_tiles_x(); x++) {
			choose_tile(p_view, x, z);
		}
	}
	_statistics.left_out_tiles = { leave_out(0, GRASS_LOD_LEVELS, uint32_t(_setup.instance_capacity())),
		leave_out(GRASS_LOD_LEVELS, GRASS_ALL_LEVELS, uint32_t(_setup.shadow_capacity())) };
	_statistics.drawn_blades = _statistics.shadow_blades = 0;
	for (size_t level = 0; level < GRASS_ALL_LEVELS; level++) {
		int64_t &blades = level < GRASS_LOD_LEVELS ? _statistics.drawn_blades : _statistics.shadow_blades;
		for (size_t at = 0; at < _instances[level].size(); at += GRASS_INSTANCE_FLOATS) {
			blades += int64_t(std::ceil(_instances[level][at + INSTANCE_BLADES]));
		}
		FieldInstance &instance = _levels[level];
		const int count = int(_instances[level].size()) / GRASS_INSTANCE_FLOATS;
		if (count > instance.capacity()) {
			instance.reserve(int(std::bit_ceil(unsigned(count))));
		}
		PackedFloat32Array buffer;
		buffer.resize(int64_t(instance.capacity()) * GRASS_INSTANCE_FLOATS);
		std::copy_n(_instances[level].begin(), size_t(count) * GRASS_INSTANCE_FLOATS, buffer.ptrw());
		instance.set_instances(buffer, count);
		_statistics.drawn_tiles[level] = count;
	}
}

namespace {

// The CPU's twins of casts_into() and choose() in shaders/detail/cull.glsl.
bool casts_into(const FieldView &p_view, const ViewCamera &p_camera, const Eigen::Vector3f &p_middle, const Eigen::Vector3f &p_half) {
	const Eigen::Vector3f none = Eigen::Vector3f::Zero();
	return grass_tile_visible(p_camera.planes, p_middle, p_half, p_view.shadow_margin, none) ||
			std::any_of(p_view.falls.begin(), p_view.falls.end(),
					[&](const Eigen::Vector3f &p_fall) { return grass_tile_visible(p_camera.planes, p_middle, p_half, 0.0f, p_fall); });
}

} // namespace

void CpuBackend::choose_tile(const FieldView &p_view, int p_x, int p_z) {
	const TileCover::Tile ground = _cover ? _cover->get(p_x, p_z) : TileCover::Tile{ 0.0f, 0.0f };
	if (ground.is_bare()) {
		return;
	}
	const float side = 0.5f * float(_setup.grid.get_tile_size()) + _setup.blade_reach();
	const float half_height = 0.5f * (_setup.blade_height() + ground.high - ground.low);
	const Eigen::Vector3f half(side, half_height, side);
	const Eigen::Vector3f middle = _setup.grid.get_centre(p_x, p_z).cast<float>() + Eigen::Vector3f(0.0f, ground.low + half_height, 0.0f);
	const BladeSize size = _setup.blade_size();
	LodNeed seen, casting;
	for (const ViewCamera &camera : p_view.cameras) {
		const float distance = std::max((camera.eye - middle).norm(), camera.near), pixel = camera.pixel_at(distance);
		const float lod_distance = camera.pixel_slope > 0.0f ? distance : camera.near; // an orthogonal camera sees all alike
		if (grass_tile_visible(camera.planes, middle, half, 0.0f, Eigen::Vector3f::Zero())) {
			seen.add(p_view.lod, size, lod_distance, camera.near, pixel);
		}
		if (distance < p_view.shadow_distance && casts_into(p_view, camera, middle, half)) {
			casting.add(p_view.lod, size, lod_distance, camera.near, pixel * p_view.lod.shadow_coarseness);
		}
	}
	add_tile(p_x, p_z, seen, 0, GRASS_LOD_LEVELS);
	add_tile(p_x, p_z, casting, GRASS_LOD_LEVELS, GRASS_ALL_LEVELS);
}

void CpuBackend::add_tile(int p_x, int p_z, const LodNeed &p_need, int p_first, int p_end) {
	if (p_need.blades <= 0.0f) {
		return;
	}
	const uint32_t x = uint32_t(p_x), z = uint32_t(p_z);
	const float hash = grass_tile_hash(x, z, _setup.seed);
	const float blades = grass_lod_shown(p_need.blades, hash);
	const int segments = std::min(grass_lod_segments(p_need.segments), get_lod_level(p_first).segments);
	const int level = grass_lod_level(blades, segments, p_first, p_end);
	const Eigen::Vector3f centre = _setup.grid.get_centre(p_x, p_z).cast<float>();
	const auto found = _slot_of_tile.find(_setup.grid.get_index(p_x, p_z));
	const int slot = found == _slot_of_tile.end() ? GRASS_NO_SLOT : found->second;
	const int low = slot == GRASS_NO_SLOT ? GRASS_NO_SLOT : slot % GRASS_SLOT_HALF;
	const int high = slot == GRASS_NO_SLOT ? 0 : slot / GRASS_SLOT_HALF;
	const float values[GRASS_INSTANCE_FLOATS] = { 1.0f, 0.0f, 0.0f, centre.x(), //
		0.0f, 1.0f, 0.0f, centre.y(), //
		0.0f, 0.0f, 1.0f, centre.z(), //
		float(p_x), float(p_z), blades, grass_lod_morph(p_need.segments, segments), //
		float(grass_tile_start(x, z, _setup.seed) / GRASS_START_STRIDE), float(low), hash, float(high) };
	_instances[size_t(level)].insert(_instances[size_t(level)].end(), std::begin(values), std::end(values));
}

int64_t CpuBackend::leave_out(int p_first, int p_end, uint32_t p_room) {
	const auto levels = std::span(_instances).subspan(size_t(p_first), size_t(p_end - p_first));
	const auto tiles = [&] {
		return std::accumulate(levels.begin(), levels.end(), int64_t(0),
				[](int64_t p_sum, const std::vector<float> &p_level) { return p_sum + int64_t(p_level.size()) / GRASS_INSTANCE_FLOATS; });
	};
	const int64_t chosen = tiles();
	if (chosen <= int64_t(p_room)) {
		return 0;
	}
	const auto rank_of = [&](int p_level, const float *p_tile) {
		return grass_lod_rank(p_level, grass_tile_turn(uint32_t(p_tile[INSTANCE_TILE]), uint32_t(p_tile[INSTANCE_TILE + 1]), _setup.seed));
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
	}
	return chosen - tiles();
}

void CpuBackend::update_pool_texture() {
	const int rows = rows_for(_highest_slot);
	const bool is_resized = rows != _pool_rows;
	if (!is_resized && _changed_slots.is_empty()) {
		return;
	}
	_pool_rows = rows;
	_pool_texels.resize(size_t(_pool_rows) * ROW_TEXELS * 4);
	if (is_resized) {
		_pool_texels.shrink_to_fit();
	}
	for (const int slot : _changed_slots) {
		if (slot >= _pool_rows) {
			break; // asleep since, or it would have a row
		}
		_pool.pack_row(slot, std::span(_pool_texels).subspan(size_t(slot) * ROW_TEXELS * 4, ROW_TEXELS * 4));
	}
	_changed_slots.reset(_setup.pool_tiles, false);
	const Ref<Image> image =
			Image::create_from_data(ROW_TEXELS, _pool_rows, false, Image::FORMAT_RGBAH, to_bytes(std::span<const uint16_t>(_pool_texels)));
	if (is_resized) {
		_pool_texture = ImageTexture::create_from_image(image);
		_materials.set("pool_knots", _pool_texture);
	} else {
		_pool_texture->update(image);
	}
}

void CpuBackend::set_cover(const std::shared_ptr<const TileCover> &p_cover, const TileRange &p_changed) {
	(void)p_changed; // asked for tile by tile
	_cover = p_cover;
	_tiles_changed = true;
	for (FieldInstance &level : _levels) {
		level.set_bounds(field_bounds(_setup, _cover.get()));
	}
}

void CpuBackend::follow(GeometryInstance3D *p_node, const Transform3D &p_transform) {
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		FieldInstance &instance = _levels[size_t(level)];
		if (!instance.is_created()) {
			Ref<ArrayMesh> mesh;
			mesh.instantiate();
			add_lod_surface(mesh, level, _materials.level(level), _setup.card_size > 0.0f);
			instance.create(mesh, FIRST_INSTANCES, false, field_bounds(_setup, _cover.get()),
					level < GRASS_LOD_LEVELS ? Role::PICTURE : Role::SHADOWS);
		}
		instance.follow(p_node, p_transform);
	}
}

std::vector<Eigen::Vector3f> CpuBackend::read_knots(int p_slot, int p_blade, int p_count) {
	std::vector<Eigen::Vector3f> knots;
	for (int blade = p_blade; blade < p_blade + p_count; blade++) {
		const std::vector<Eigen::Vector3f> own = _pool.get_knots(p_slot, blade);
		knots.insert(knots.end(), own.begin(), own.end());
	}
	return knots;
}

BackendStatistics CpuBackend::get_statistics() {
	BackendStatistics statistics = _statistics;
	for (const FieldInstance &level : _levels) {
		statistics.instance_updates += level.get_updates();
	}
	return statistics;
}

int64_t CpuBackend::get_memory_usage() const {
	int64_t bytes = int64_t(_setup.patch->texels.size()) * 4 + _pool.get_memory_usage() +
			mesh_bytes(_setup.card_size > 0.0f); // patch: here and as a texture
	bytes += int64_t(_pool_texels.capacity()) * 4; // likewise
	for (const FieldInstance &level : _levels) {
		bytes += int64_t(level.capacity()) * GRASS_INSTANCE_FLOATS * 4;
	}
	for (const std::vector<float> &instances : _instances) {
		bytes += int64_t(instances.capacity() * sizeof(float));
	}
	return bytes + int64_t(_slot_of_tile.size() * (sizeof(std::pair<int, int>) + 2 * sizeof(void *)) + _changed_slots.get_memory_usage());
}

} // namespace grass

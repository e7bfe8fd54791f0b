// SPDX-License-Identifier: MIT
#include "cpu/cpu_backend.h"

#include "shared/convert.h"
#include "shared/parallel.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/time.hpp>

#include <algorithm>
#include <bit>
#include <utility>

using namespace godot;

namespace grass {

namespace {
constexpr int FIRST_INSTANCES = 64; // of a level's MultiMesh: 5 KiB; grows with the number of tiles in view

// Uploads the instances to the MultiMesh, and makes it larger if needed.
void show_instances(FieldInstance &r_instance, std::span<const float> p_instances) {
	const int count = int(p_instances.size()) / GRASS_INSTANCE_FLOATS;
	r_instance.need(count > 0);
	if (count == 0) {
		return;
	}
	if (count > r_instance.capacity()) {
		r_instance.reserve(int(std::bit_ceil(unsigned(count))));
	}
	PackedFloat32Array buffer;
	buffer.resize(int64_t(r_instance.capacity()) * GRASS_INSTANCE_FLOATS);
	std::ranges::copy(p_instances, buffer.ptrw());
	r_instance.set_instances(buffer, count);
}
} // namespace

CpuBackend::CpuBackend(const FieldSetup &p_setup) : _setup(p_setup), _pool(p_setup.patch), _patch_texture(patch_texture(p_setup.patch)) {
	_materials.set("patch_knots", _patch_texture);
	_materials.set("blade_length", _setup.blade_length());
	update_pool_texture();
}

bool CpuBackend::set_field(const FieldSetup &p_setup) {
	if (!p_setup.has_meshes_of(_setup)) {
		return false;
	}
	if (p_setup.patch != _setup.patch) {
		_pool.set_patch(p_setup.patch);
		const Ref<ImageTexture> before = std::exchange(_patch_texture, patch_texture(p_setup.patch)); // held until nothing reads it
		set_uniform("patch_knots", _patch_texture);
		_materials.set("blade_length", p_setup.blade_length());
	}
	_pool.resize(0, {});
	_texels.reset();
	_setup = p_setup;
	_slot_of_tile.clear();
	_cover.reset(); // it belongs to the old grid; set_cover() follows
	_tiles_changed = true;
	for (FieldInstance &level : _levels) {
		level.set_bounds(field_bounds(_setup));
	}
	return true;
}

void CpuBackend::step(const StepInput &p_input) {
	const uint64_t begin = Time::get_singleton()->get_ticks_usec();
	const int64_t blades_before = _pool.get_simulated_blades(), strains_before = _pool.get_strain_blades();
	_texels.begin_step(_pool, p_input.slots);
	_pool.step(p_input, run_parallel);
	_texels.end_step(p_input.slots);
	for (const GrassSlot &slot : p_input.slots) {
		_tiles_changed = _tiles_changed || (slot.list.w & (GRASS_SLOT_FRESH | GRASS_SLOT_RETIRED)) != 0;
		if (slot.list.w & GRASS_SLOT_RETIRED) {
			_slot_of_tile.erase(slot.tile.z);
		} else {
			_slot_of_tile[slot.tile.z] = slot.tile.w;
		}
	}
	_step_number = p_input.number;
	_statistics.steps++;
	_statistics.simulated_blades += _pool.get_simulated_blades() - blades_before;
	_statistics.strain_blades += _pool.get_strain_blades() - strains_before;
	if (_measure) {
		_statistics.timed_steps++;
		_statistics.simulate_ms = double(Time::get_singleton()->get_ticks_usec() - begin) * 1e-3;
	}
}

void CpuBackend::join(std::span<const GrassSlot> p_slots, const GrassStep &p_step) {
	(void)p_step; // the pool keeps the rest poses
	for (const GrassSlot &slot : p_slots) {
		_pool.join(slot);
	}
	_texels.change(_pool, p_slots);
}

void CpuBackend::resize_pool(int p_slots, std::span<const SlotMove> p_moves) {
	_pool.resize(p_slots, p_moves);
	_texels.resize_pool(p_slots, p_moves);
	for (const SlotMove &move : p_moves) {
		if (move.to == GRASS_NO_SLOT) {
			_slot_of_tile.erase(move.tile);
		} else {
			_slot_of_tile[move.tile] = move.to;
		}
	}
	_tiles_changed = true;
}

void CpuBackend::draw(const FieldView &p_view) {
	if (_followed == 0) {
		return;
	}
	const uint64_t begin = Time::get_singleton()->get_ticks_usec();
	_is_drawn = true;
	update_pool_texture();
	if (!_tiles_changed && _view == p_view) {
		return; // the same view of the same tiles: the MultiMeshes are up to date
	}
	choose_tiles(p_view);
	_view = p_view;
	_tiles_changed = false;
	_statistics.culls++;
	if (_measure) {
		_statistics.cull_ms = double(Time::get_singleton()->get_ticks_usec() - begin) * 1e-3;
	}
}

int CpuBackend::find_slot(int p_tile) const {
	const auto found = _slot_of_tile.find(p_tile);
	return found == _slot_of_tile.end() ? GRASS_NO_SLOT : found->second;
}

void CpuBackend::set_look(const Look &p_look) {
	_materials.set_look(p_look);
	_plants.set_look(p_look);
}

void CpuBackend::set_uniform(const StringName &p_name, const Variant &p_value) {
	_materials.set(p_name, p_value);
	_plants.set_uniform(p_name, p_value);
}

void CpuBackend::set_plants(const std::vector<DrawnPlant> &p_plants, const PlantCull::PlantsOf &p_plants_of) {
	_plants.set(
			p_plants, [](float) { return FIRST_INSTANCES; }, false, field_bounds(_setup, _cover.get()));
	_plant_cull = {};
	_plants_of = p_plants_of;
	_tiles_changed = true;
	_plants.set_uniform("patch_knots", _patch_texture);
	_plants.set_uniform("pool_knots", _pool_texture);
}

void CpuBackend::choose_plants(const FieldView &p_view) {
	PlantCull::Kinds kinds{};
	for (const auto &plant : _plants.get()) {
		kinds[size_t(plant->number())] = plant->drawn.kind(plant->stage, p_view.plant_reach, _setup.grid.get_tile_size());
	}
	_plants.fit(_setup.cull_field(), p_view, _cover ? _cover->get_extremes() : TileCover::FULL);
	_plant_cull.choose(
			_setup.cull_field(), p_view, _cover.get(), [this](int p_tile) { return find_slot(p_tile); }, _plants_of, kinds);
	_statistics.drawn_plants = _statistics.drawn_impostors = _statistics.left_out_plants = 0;
	for (const auto &plant : _plants.get()) {
		const int chosen = _plant_cull.get_count(plant->number()), count = std::min(chosen, Plants::ROOM);
		show_instances(plant->instance, _plant_cull.get_instances(plant->number()).first(size_t(count) * GRASS_INSTANCE_FLOATS));
		(plant->stage == GRASS_PLANT_MESH ? _statistics.drawn_plants : _statistics.drawn_impostors) += count;
		_statistics.left_out_plants += chosen - count;
	}
}

void CpuBackend::choose_tiles(const FieldView &p_view) {
	const LevelSet levels = find_levels(_setup.cull_field(), p_view, _cover ? _cover->get_extremes() : TileCover::FULL);
	_cull.choose(
			_setup.cull_field(), p_view, _cover.get(), [this](int p_tile) { return find_slot(p_tile); }, levels);
	_statistics.left_out_tiles = _cull.get_left_out();
	_statistics.drawn_blades = _cull.get_blades()[0];
	_statistics.shadow_blades = _cull.get_blades()[1];
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		if (_cull.get_count(level) > 0) {
			make_level(level);
		}
		show_instances(_levels[size_t(level)], _cull.get_instances(level));
		_statistics.drawn_tiles[size_t(level)] = _cull.get_count(level);
	}
	if (!_plants.is_empty()) {
		choose_plants(p_view);
	}
}

void CpuBackend::update_pool_texture() {
	const int rows = std::max(_pool.get_size(), 1); // a texture cannot be empty
	const bool is_resized = rows != _pool_rows;
	if (!_texels.show(_pool, rows, _share) && !is_resized) {
		return;
	}
	_pool_rows = rows;
	_statistics.mixes += _texels.is_between() ? 1 : 0;
	const Ref<Image> image =
			Image::create_from_data(PoolTexels::ROW_TEXELS, _pool_rows, false, Image::FORMAT_RGBAH, to_bytes(_texels.get_shown()));
	if (is_resized) {
		_pool_texture = ImageTexture::create_from_image(image);
		set_uniform("pool_knots", _pool_texture);
	} else {
		_pool_texture->update(image);
	}
}

void CpuBackend::set_cover(const std::shared_ptr<const TileCover> &p_cover, const TileRange &p_changed) {
	(void)p_changed; // culling reads the cover of each tile
	_cover = p_cover;
	_tiles_changed = true;
	_plant_cull.forget(); // paint may have changed species
	_plants.set_bounds(field_bounds(_setup, _cover.get()));
	for (FieldInstance &level : _levels) {
		level.set_bounds(field_bounds(_setup, _cover.get()));
	}
}

void CpuBackend::follow(GeometryInstance3D *p_node, const Transform3D &p_transform) {
	_followed = p_node->get_instance_id();
	_transform = p_transform;
	for (FieldInstance &level : _levels) {
		level.follow(p_node, p_transform);
	}
	_plants.follow(p_node, p_transform);
}

// Makes the MultiMesh of a level when the first tile has it.
void CpuBackend::make_level(int p_level) {
	FieldInstance &instance = _levels[size_t(p_level)];
	GeometryInstance3D *node = Object::cast_to<GeometryInstance3D>(ObjectDB::get_instance(_followed));
	if (!instance.is_created() && node != nullptr) {
		const bool is_seen = p_level < GRASS_LOD_LEVELS;
		instance.create(shared_blade_mesh(LevelSet(1) << p_level, _setup.card_size > 0.0f),
				is_seen ? _materials.picture() : _materials.shadows(), FIRST_INSTANCES, Written::BY_CPU, field_bounds(_setup, _cover.get()),
				is_seen ? Role::PICTURE : Role::SHADOWS);
		instance.follow(node, _transform);
	}
}

std::vector<SimulatedKnots> CpuBackend::find_knots(std::span<const WantedBlade> p_blades) {
	std::vector<SimulatedKnots> found(p_blades.size());
	for (size_t i = 0; i < found.size(); i++) {
		const std::vector<Eigen::Vector3f> knots = _pool.get_knots(p_blades[i].slot, blade_in_tile(p_blades[i].number));
		if (knots.size() == GRASS_KNOTS) {
			std::ranges::copy(knots, found[i].emplace().begin());
		}
	}
	return found;
}

BackendStatistics CpuBackend::get_statistics() {
	BackendStatistics statistics = _statistics;
	statistics.instance_updates += _plants.get_updates();
	for (const FieldInstance &level : _levels) {
		statistics.instance_updates += level.get_updates();
	}
	return statistics;
}

LevelSet CpuBackend::find_made_levels() const {
	LevelSet made = 0;
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		made |= _levels[size_t(level)].is_created() ? LevelSet(1) << level : 0;
	}
	return made;
}

// Counts nothing for unused tiles of the pool: memory is allocated with the tiles that wake.
BackendMemory CpuBackend::get_memory() const {
	constexpr int64_t ROW_BYTES = PoolTexels::ROW_TEXELS * 8;
	const int64_t copies = !_is_drawn ? 0 : _texels.is_between() ? 4 : 2; // of a row: see PoolTexels, and the texture
	BackendMemory memory;
	memory.pool_tile = CpuPool::find_slot_bytes() + copies * ROW_BYTES;
	memory.shared = int64_t(_setup.patch->texels.size()) * 4; // in main memory and as a texture
	const int64_t pool = _pool.get_memory_usage() + int64_t(_texels.get_memory_usage()) +
			int64_t(_pool_rows) * ROW_BYTES; // visible rows are in a texture too
	memory.pool = _pool.get_size() > 0 ? pool : 0; // not the row of an empty texture
	memory.all = memory.shared + pool + mesh_bytes(find_made_levels(), _setup.card_size > 0.0f) + _plants.get_memory_usage() +
			int64_t(_cull.get_memory_usage() + _plant_cull.get_memory_usage() +
					_slot_of_tile.size() * (sizeof(std::pair<int, int>) + 2 * sizeof(void *)));
	for (const FieldInstance &level : _levels) {
		memory.all += int64_t(level.capacity()) * GRASS_INSTANCE_FLOATS * 4;
	}
	return memory;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "gpu/plant_passes.h"

#include "compute_shaders.gen.h"

#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

const PassCode PLAIN = { shader::PLANTS_SPIRV, "GrassField plants", PassOrder::PLANTS },
			   MAPPED = { shader::PLANTS_GRASS_MAP_SPIRV, "GrassField plants map", PassOrder::PLANTS };

// The push constant.
struct Constants {
	ivec4 phase;
	vec4 box, map;
};

// Returns the number of tiles along one side of the square around a camera.
int side_of(int p_tiles, double p_distance, double p_tile_size) {
	return std::min(2 * int(std::ceil(p_distance / p_tile_size)) + 1, p_tiles);
}

} // namespace

const PassCode &PlantPasses::code(bool p_is_mapped) {
	return p_is_mapped ? MAPPED : PLAIN;
}

void PlantPasses::set(const FieldSetup &p_setup, const std::vector<PlantTarget> &p_targets) {
	free();
	if (p_targets.empty()) {
		return;
	}
	_grid = p_setup.grid;
	_is_mapped = p_setup.is_mapped;
	_is_new = true;
	Mix mix{};
	size_t s = 0;
	for (const SpeciesRecord &record : p_setup.species->get_records()) {
		mix.mix[s] = { record.cell, record.strength, record.limit, record.salt };
		mix.origin[s] = { record.x, record.z, record.column, record.row };
		mix.fray[s] = record.fray;
		mix.stems[s++] = record.stems;
	}
	mix.count = p_setup.species->get_count();
	mix.texel = p_setup.species->get_texel_units();
	_mix.upload(std::span<const Mix>(&mix, 1));
	_counts.resize(COUNT_BYTES);
	for (const PlantTarget &target : p_targets) {
		_targets.push_back({ target, std::make_unique<GpuPass>() });
		_targets.back().pass->create(code(_is_mapped));
	}
}

bool PlantPasses::bind(const Shared &p_shared, const PaintedSpecies &p_painted) {
	RenderingServer *server = RenderingServer::get_singleton();
	for (const Choosing &choosing : _targets) {
		const RID instances = server->multimesh_get_buffer_rd_rid(choosing.target.multimesh);
		const RID commands = server->multimesh_get_command_buffer_rd_rid(choosing.target.multimesh);
		if (!instances.is_valid() || !commands.is_valid() || (_is_mapped && (p_painted.pages.is_null() || p_painted.painted.is_null()))) {
			return false;
		}
		GpuPass &pass = *choosing.pass;
		pass.bind_buffer(GRASS_PLANTS_VIEW, p_shared.view);
		pass.bind_buffer(GRASS_PLANTS_CAMERAS, p_shared.cameras);
		pass.bind_buffer(GRASS_PLANTS_TABLE, p_shared.table);
		pass.bind_buffer(GRASS_PLANTS_COVER, p_shared.cover);
		pass.bind_sampled(GRASS_PLANTS_PATCH, p_shared.sampler, p_shared.patch);
		pass.bind_buffer(GRASS_PLANTS_MIX, _mix.rid());
		pass.bind_buffer(GRASS_PLANTS_COUNTS, _counts.rid());
		pass.bind_buffer(GRASS_PLANTS_INSTANCES, instances);
		pass.bind_buffer(GRASS_PLANTS_COMMANDS, commands);
		if (_is_mapped) {
			pass.bind_sampled(GRASS_PLANTS_PAGES, p_shared.sampler, server->texture_get_rd_texture(p_painted.pages->get_rid()));
			pass.bind_sampled(GRASS_PLANTS_PAINTED, p_shared.sampler, server->texture_get_rd_texture(p_painted.painted->get_rid()));
		}
	}
	return true;
}

bool PlantPasses::has_changed() const {
	return _is_new || std::ranges::any_of(_targets, [](const Choosing &p_choosing) { return p_choosing.pass->has_changed(); });
}

void PlantPasses::clear_counts() {
	_is_new = false;
	_counts.clear();
}

void PlantPasses::dispatch(int64_t p_list, int p_cameras, const PaintedSpecies &p_painted) {
	for (const Choosing &choosing : _targets) {
		const PlantTarget &target = choosing.target;
		const float distance = target.kind.distance * _reach;
		const int x = side_of(_grid.get_tiles_x(), double(distance), _grid.get_tile_size());
		const int z = side_of(_grid.get_tiles_z(), double(distance), _grid.get_tile_size());
		for (const int phase : { GRASS_PLANTS_CHOOSE, GRASS_PLANTS_FINISH }) {
			const Constants constants{ { phase, target.number, target.room, target.surfaces },
				{ float(x), float(z), distance, target.kind.nearest * _reach },
				{ float(p_painted.origin.x), float(p_painted.origin.y), target.kind.length, target.kind.cover } };
			const uint32_t groups = phase == GRASS_PLANTS_FINISH ? 1 : uint32_t(x) * uint32_t(z) * uint32_t(p_cameras);
			choosing.pass->dispatch(p_list, constants, groups);
			main_device()->compute_list_add_barrier(p_list);
		}
	}
}

std::vector<PlantTarget> PlantPasses::get_targets() const {
	std::vector<PlantTarget> targets;
	for (const Choosing &choosing : _targets) {
		targets.push_back(choosing.target);
	}
	return targets;
}

void PlantPasses::count(const std::vector<PlantTarget> &p_targets, const PackedByteArray &p_counts, BackendStatistics &r_statistics) {
	r_statistics.drawn_plants = r_statistics.drawn_impostors = r_statistics.left_out_plants = 0;
	for (const PlantTarget &target : p_targets) {
		const int64_t chosen = p_counts.decode_u32(4 * target.number), room = target.room;
		(target.number < GRASS_MAX_SPECIES ? r_statistics.drawn_plants : r_statistics.drawn_impostors) += std::min(chosen, room);
		r_statistics.left_out_plants += std::max<int64_t>(chosen - room, 0);
	}
}

void PlantPasses::free() {
	for (const Choosing &choosing : _targets) {
		const RID commands = RenderingServer::get_singleton()->multimesh_get_command_buffer_rd_rid(choosing.target.multimesh);
		choosing.pass->free();
		if (commands.is_valid()) {
			main_device()->free_rid(commands);
		}
	}
	_targets.clear();
	_mix.free();
	_counts.free();
}

} // namespace grass

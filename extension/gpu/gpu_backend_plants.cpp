// SPDX-License-Identifier: MIT
// The part of GpuBackend for plants with a mesh.
#include "draw/patch_texture.h"
#include "gpu/gpu_backend.h"
#include "gpu/gpu_field.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Returns the number of plants within a distance of a camera if all blades were of one species.
int plant_room(const FieldSetup &p_setup, float p_distance) {
	const double size = p_setup.grid.get_tile_size();
	const double side_x = std::min(2.0 * double(p_distance), double(p_setup.grid.get_tiles_x()) * size),
				 side_z = std::min(2.0 * double(p_distance), double(p_setup.grid.get_tiles_z()) * size);
	return int(std::min(side_x * side_z / (size * size) * GRASS_BLADES_PER_TILE + GRASS_BLADES_PER_TILE, double(Plants::ROOM)));
}

} // namespace

void GpuBackend::set_uniform(const StringName &p_name, const Variant &p_value) {
	_materials.set(p_name, p_value);
	_plants.set_uniform(p_name, p_value);
}

void GpuBackend::set_map(const MapBinding &p_map) {
	Backend::set_map(p_map);
	if (!_plants.is_empty()) {
		_painted = { p_map.pages, p_map.species, p_map.origin };
		_drawn_jobs = -1;
	}
}

void GpuBackend::set_plants(const std::vector<DrawnPlant> &p_plants, const PlantCull::PlantsOf &p_plants_of) {
	(void)p_plants_of; // the GPU finds them itself
	const bool has_any = std::ranges::any_of(p_plants, [](const DrawnPlant &p_plant) { return p_plant.model != nullptr; });
	if (_plants.is_empty() && !has_any) {
		return;
	}
	_jobs.post([setup = _setup](GpuField &r_field) { r_field.set_plants(setup, {}); }); // while they are still there
	_plants.set(
			p_plants, [this](float p_distance) { return plant_room(_setup, p_distance); }, true, _bounds);
	set_bounds(_bounds);
	_is_fitted = false;
	_painted = {};
	set_uniform("patch_knots", _patch_texture);
	set_uniform("pool_knots", _pool_texture);
	set_uniform("pool_knots_before", _has_motion ? Variant(_pool_before_texture) : Variant());
	set_uniform("is_flipped", _is_flipped);
	std::vector<PlantTarget> targets;
	for (const auto &plant : _plants.get()) {
		const PlantKind kind = plant->drawn.kind(plant->stage, 1.0f, _setup.grid.get_tile_size());
		targets.push_back({ plant->instance.multimesh(), plant->number(), plant->instance.capacity(), int(plant->materials.size()), kind });
	}
	_jobs.post([setup = _setup, targets](GpuField &r_field) { r_field.set_plants(setup, targets); });
}

} // namespace grass

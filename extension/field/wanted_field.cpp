// SPDX-License-Identifier: MIT
#include "field/wanted_field.h"

#include "gpu/device.h"
#include "gpu/obstacles.h"

#include <algorithm>

namespace grass {

namespace {

void fit(const FieldProperties &p_properties, FieldSetup &r_setup) {
	r_setup.pool_size = int(p_properties.scaled_pool());
	r_setup.drawn_tiles_max = int(p_properties.param(PARAM_DRAWN_TILES_MAX));
	if (!p_properties.is_on_cpu && main_device() != nullptr) {
		const DeviceFit fit = fit_device(device_limits(), r_setup);
		r_setup.pool_size = fit.pool_size;
		r_setup.drawn_tiles_max = fit.drawn_tiles_max;
	}
}

} // namespace

std::shared_ptr<const SpeciesMix> find_mix(const FieldProperties &p_properties) {
	if (p_properties.species.is_plain()) {
		return nullptr;
	}
	return std::make_shared<const SpeciesMix>(p_properties.species.find_mix(), p_properties.grid(), uint32_t(p_properties.seed),
			Eigen::Vector2d(p_properties.noise_origin.x, p_properties.noise_origin.y));
}

WantedField find_wanted(const FieldProperties &p_properties) {
	WantedField wanted;
	FieldSetup &setup = wanted.setup;
	setup.grid = p_properties.grid();
	setup.patch = p_properties.species.join();
	setup.clump = p_properties.clump();
	setup.method = p_properties.method;
	setup.seed = uint32_t(p_properties.seed);
	wanted.painted = p_properties.map;
	setup.is_mapped = wanted.painted.is_valid();
	setup.follow_slope = float(p_properties.param(PARAM_FOLLOW_SLOPE));
	setup.sparse_height = float(p_properties.param(PARAM_SPARSE_HEIGHT));
	setup.has_terrain = p_properties.find_terrain_texture().is_valid();
	setup.card_size = p_properties.species.find_card_size();
	setup.leaf_area = p_properties.species.find_leaf_area();
	wanted.plants = p_properties.species.find_plants(p_properties.param(PARAM_DENSITY));
	for (const DrawnPlant &plant : wanted.plants) {
		setup.plant_size = std::max(setup.plant_size, plant.size());
	}
	const std::vector<int> stems = p_properties.species.find_stems();
	setup.has_plants = setup.plant_size > 0.0f || std::ranges::any_of(stems, [](int p_stems) { return p_stems > 1; });
	setup.species = find_mix(p_properties);
	wanted.species = p_properties.species.find_grown();
	fit(p_properties, setup);
	return wanted;
}

int find_pool_size(const FieldProperties &p_properties, const FieldSetup &p_setup) {
	FieldSetup setup = p_setup;
	fit(p_properties, setup);
	return setup.pool_size;
}

std::optional<MapPlace> find_map_place(const FieldProperties &p_properties) {
	if (!p_properties.species.prepare_patches()) {
		return {};
	}
	return find_wanted(p_properties).setup.map_place();
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "core/field/grass_at.h"

#include <algorithm>

namespace grass {

namespace {

Growth growth_at(const Eigen::Vector2f &p_place, const MapLayers *p_layers) {
	return p_layers != nullptr ? p_layers->sample(p_place) : glsl::grass_unpainted(1.0f);
}

// Returns the mean height of the grass around a place, metres, without clump and map.
double mean_height_at(const Field &p_field, const Eigen::Vector2f &p_place, const MapLayers *p_layers) {
	const FieldSetup &setup = p_field.get_setup();
	if (!setup.species) {
		return setup.patch->mean_height;
	}
	const std::array<float, GRASS_MAX_SPECIES> shares = setup.species->get_shares_at(p_place, p_layers);
	double height = 0.0;
	for (size_t s = 0; s < p_field.get_species().size(); s++) {
		height += double(shares[s] * p_field.get_species()[s]->mean_height);
	}
	return height;
}

} // namespace

double density_at(const Eigen::Vector2f &p_place, const MapLayers *p_layers) {
	return growth_at(p_place, p_layers).density;
}

double height_at(const Field &p_field, const Eigen::Vector2f &p_place, const MapLayers *p_layers) {
	const Growth here = growth_at(p_place, p_layers);
	const double clump = clump_at(p_place, p_field.get_setup().clump).height;
	return here.density > 0.0f ? std::min(mean_height_at(p_field, p_place, p_layers) * clump * here.height, double(here.cut)) : 0.0;
}

GrassKind kind_of(const Field &p_field) {
	const FieldSetup &setup = p_field.get_setup();
	const double tile = setup.grid.get_tile_size();
	GrassKind kind{ setup.patch->mean_height, setup.blade_length(), GRASS_BLADES_PER_TILE / (tile * tile), {} };
	if (setup.species) {
		kind.height_at = [&p_field](const Eigen::Vector2d &p_place) {
			return mean_height_at(p_field, p_place.cast<float>(), p_field.get_layers());
		};
	}
	return kind;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "core/field/canopy.h"

#include "core/field/grass_at.h"
#include "core/lod/lod.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace grass {

namespace {

// The parts of a line, metres: half a tile of the default density. Longer: the border of grass is missed by more.
constexpr double SIGHT_PART = 0.25;
// The least height of flat grass, as a share of its blades' length: blades lie on each other.
constexpr double FLATTEST = 0.03;

// The mean blade around a place, without clump and map.
struct MeanBlade {
	double height = 0.0, length = 0.0, width = 0.0; // metres
};

MeanBlade mean_blade_at(const Field &p_field, const Eigen::Vector2f &p_place, const MapLayers *p_layers) {
	const FieldSetup &setup = p_field.get_setup();
	MeanBlade mean{ setup.patch->mean_height, setup.patch->mean_length, setup.patch->mean_width };
	if (setup.species) {
		const std::array<float, GRASS_MAX_SPECIES> shares = setup.species->get_shares_at(p_place, p_layers);
		mean = {};
		for (size_t s = 0; s < p_field.get_species().size(); s++) {
			const Patch &patch = *p_field.get_species()[s];
			mean.height += double(shares[s] * patch.mean_height);
			mean.length += double(shares[s] * patch.mean_length);
			mean.width += double(shares[s] * patch.mean_width);
		}
	}
	mean.width += double(width_of_leaf(setup.leaf_area, float(mean.length)));
	return mean;
}

Eigen::Vector3d bend_at(const Field &p_field, const Eigen::Vector2f &p_place) {
	const TileGrid &grid = p_field.get_grid();
	const TilePlace tile = grid.get_place({ double(p_place.x()), 0.0, double(p_place.y()) });
	return grid.has_tile(tile.x, tile.z) ? p_field.get_tiles().get_bend(grid.get_index(tile.x, tile.z)).cast<double>()
										 : Eigen::Vector3d(0.0, 0.0, 0.0);
}

// Returns the share of a way from height p_from to p_to that is between two heights.
double share_between(double p_from, double p_to, double p_low, double p_high) {
	const double low = std::min(p_from, p_to), high = std::max(p_from, p_to);
	if (high - low < 1e-9) {
		return low >= p_low && low <= p_high ? 1.0 : 0.0;
	}
	return std::max(std::min(high, p_high) - std::max(low, p_low), 0.0) / (high - low);
}

} // namespace

Canopy canopy_at(const Field &p_field, const Eigen::Vector2f &p_place, const MapLayers *p_layers) {
	const TileGrid &grid = p_field.get_grid();
	const TilePlace tile = grid.get_place({ double(p_place.x()), 0.0, double(p_place.y()) });
	Canopy canopy;
	if (p_field.get_setup().patch->is_empty() || !grid.has_tile(tile.x, tile.z)) {
		return canopy;
	}
	const Growth growth = p_layers != nullptr ? p_layers->sample(p_place) : glsl::grass_unpainted(1.0f);
	const MeanBlade mean = mean_blade_at(p_field, p_place, p_layers);
	const double grown = height_at(p_field, p_place, p_layers) / std::max(mean.height, 1e-6); // blades are that much longer than the mean
	const double length = mean.length * grown;
	canopy.ground = double(growth.ground);
	if (!(length > 0.0) || !(growth.density > 0.0f)) {
		return canopy;
	}
	canopy.blades = double(growth.density) * GRASS_BLADES_PER_TILE / (grid.get_tile_size() * grid.get_tile_size());
	canopy.blade_area = double(GRASS_LOD_FULLNESS) * mean.width * length;
	canopy.along = Eigen::Vector3d(0.0, mean.height / mean.length, 0.0) + bend_at(p_field, p_place);
	canopy.along.y() = std::max(canopy.along.y(), FLATTEST);
	canopy.along /= std::max(canopy.along.norm(), 1.0);
	canopy.height = length * canopy.along.y();
	return canopy;
}

double canopy_density(const Canopy &p_canopy, const Eigen::Vector3d &p_line) {
	if (!(p_canopy.height > 0.0)) {
		return 0.0;
	}
	const double mean = p_canopy.along.dot(p_line), spread = (1.0 - p_canopy.along.squaredNorm()) / 3.0;
	const double across = std::sqrt(std::max(1.0 - mean * mean - spread, 0.0)); // the mean sine of the angle between blade and line
	return 2.0 / std::numbers::pi * p_canopy.blades * p_canopy.blade_area * across / p_canopy.height;
}

double hidden_share(const Field &p_field, const LayersAt &p_layers, const Eigen::Vector3d &p_from, const Eigen::Vector3d &p_to) {
	const Eigen::Vector3d way = p_to - p_from;
	const double length = way.norm();
	if (!(length > 0.0)) {
		return 0.0;
	}
	const double highest =
			(p_field.get_cover() != nullptr ? double(p_field.get_cover()->get_high()) : 0.0) + p_field.get_setup().blade_height();
	const int parts = std::max(int(std::ceil(length / SIGHT_PART)), 1);
	double depth = 0.0;
	for (int part = 0; part < parts; part++) {
		const Eigen::Vector3d begin = p_from + way * (double(part) / parts), end = p_from + way * (double(part + 1) / parts);
		if (std::min(begin.y(), end.y()) > highest) {
			continue;
		}
		const Eigen::Vector2f place(float(0.5 * (begin.x() + end.x())), float(0.5 * (begin.z() + end.z())));
		const Canopy canopy = canopy_at(p_field, place, p_layers(place));
		depth += canopy_density(canopy, way / length) * length / parts *
				share_between(begin.y(), end.y(), canopy.ground, canopy.ground + canopy.height);
	}
	return 1.0 - std::exp(-depth);
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "editor/bake_offer.h"

#include "physics/ground_rays.h"
#include "shared/convert.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace godot;

namespace grass {

namespace {

constexpr int RAYS_A_SIDE = 7; // rays along each side of the field
constexpr double HIDDEN_BY_GRASS = 0.1; // metres from the plane: grass hides that much

bool is_baked(const GrassField &p_field) {
	return !p_field.get_parts().sources.get_terrain().is_empty() ||
			(p_field.get_map().is_valid() && p_field.get_map()->get_map().uses(MAP_GROUND));
}

} // namespace

String find_bake_offer(const GrassField &p_field) {
	GroundRays rays(is_baked(p_field) ? Ref<World3D>() : p_field.get_world_3d(), p_field.field_transform());
	if (!rays.is_usable()) {
		return String();
	}
	rays.stand(p_field);
	rays.keep_within(p_field.get_parts().settings.get_ground_band());
	double low = 0.0, high = 0.0;
	for (int i = 0; i < RAYS_A_SIDE * RAYS_A_SIDE; i++) {
		const Eigen::Vector2d ray(i % RAYS_A_SIDE, std::div(i, RAYS_A_SIDE).quot);
		const Eigen::Vector2d share = (ray.array() + 0.5) / RAYS_A_SIDE - 0.5;
		const double height = rays.height_at(share.cwiseProduct(to_eigen(p_field.get_parts().settings.get_size())));
		low = std::fmin(low, height); // NaN, where there is no ground, changes nothing
		high = std::fmax(high, height);
	}
	if (low > -HIDDEN_BY_GRASS && high < HIDDEN_BY_GRASS) {
		return String();
	}
	return vformat("Bake Ground: here it lies from %.1f to %.1f m, and the grass at 0 m", low, high);
}

} // namespace grass

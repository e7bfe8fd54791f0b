// SPDX-License-Identifier: MIT
#include "core/collider.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

Vec3<float> xyz(const vec4 &p_a) {
	return { p_a.x, p_a.y, p_a.z };
}
Turn<float> turn_of(const vec4 &p_a) {
	return { xyz(p_a), p_a.w };
}
float total(const vec4 &p_a) {
	return std::abs(p_a.x) + std::abs(p_a.y) + std::abs(p_a.z) + std::abs(p_a.w);
}

// Of a radius: an edge this long with both knots on the surface cuts l^2 / 8r, within 2 %.
constexpr float BLUNT = 0.5f;

// Radius of a sphere about the shape's centre, the least thickness, and the longest edge that knots stand for.
void measure(int p_shape, const Vec3<float> &p_size, float &r_bound, float &r_thin, float &r_blunt) {
	r_blunt = 0.0f; // corners
	switch (p_shape) {
		case GRASS_CAPSULE:
			r_bound = p_size.x + p_size.y;
			r_thin = p_size.x;
			r_blunt = BLUNT * p_size.x;
			break;
		case GRASS_BOX:
			r_bound = length(p_size);
			r_thin = std::min({ p_size.x, p_size.y, p_size.z });
			break;
		case GRASS_CYLINDER:
			r_bound = std::sqrt(p_size.x * p_size.x + p_size.y * p_size.y);
			r_thin = std::min(p_size.x, p_size.y);
			break;
		case GRASS_HULL:
			r_bound = p_size.x;
			r_thin = 0.0f;
			break;
		default:
			r_bound = p_size.x;
			r_thin = p_size.x;
			r_blunt = BLUNT * p_size.x;
	}
}

} // namespace

bool make_tile_collider(const GrassCollider &p_collider, int p_tile_x, int p_tile_z, float p_tile_size,
		std::span<const Eigen::Vector4f> p_planes, TileCollider &r_collider) {
	const float sum = total(p_collider.position) + total(p_collider.rotation) + total(p_collider.position_before) +
			total(p_collider.rotation_before) + total(p_collider.size);
	if (!(sum < 1e30f)) {
		return false;
	}
	r_collider.shape = p_collider.anchor.z;
	r_collider.planes = {};
	if (r_collider.shape == GRASS_HULL) {
		const float count = p_collider.position_before.w;
		const int first = p_collider.anchor.w;
		if (!(count >= 1.0f) || first < 0 || size_t(first) + size_t(count) > p_planes.size()) {
			return false;
		}
		r_collider.planes = p_planes.subspan(size_t(first), size_t(count));
	}
	const Vec3<float> anchor{ float(p_collider.anchor.x - p_tile_x) * p_tile_size, 0.0f,
		float(p_collider.anchor.y - p_tile_z) * p_tile_size };
	r_collider.size = xyz(p_collider.size);
	r_collider.centre = xyz(p_collider.position) + anchor;
	r_collider.centre_before = xyz(p_collider.position_before) + anchor;
	r_collider.turn = turn_of(p_collider.rotation);
	r_collider.turn_before = turn_of(p_collider.rotation_before);
	r_collider.friction = std::max(p_collider.position.w, 0.0f);
	measure(r_collider.shape, r_collider.size, r_collider.bound, r_collider.thin, r_collider.blunt);
	return true;
}

} // namespace grass

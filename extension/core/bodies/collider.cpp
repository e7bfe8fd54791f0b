// SPDX-License-Identifier: MIT
#include "core/bodies/collider.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

// Returns the distance of a hull's nearest plane from its centre, metres.
float least_plane(const TileCollider &p_collider) {
	float least = p_collider.bound;
	for (const Eigen::Vector4f &plane : p_collider.planes) {
		least = std::min(least, plane.w());
	}
	return std::max(least, 0.0f);
}

Turn<float> turn_between(const Turn<float> &p_before, const Turn<float> &p_now, float p_share) {
	const float cosine = dot(p_before.axis, p_now.axis) + p_before.w * p_now.w;
	const float share = cosine < 0.0f ? -p_share : p_share;
	const Vec3<float> axis = p_before.axis * (1.0f - p_share) + p_now.axis * share;
	const float w = p_before.w * (1.0f - p_share) + p_now.w * share;
	const float scale = 1.0f / std::sqrt(std::max(dot(axis, axis) + w * w, TINY_SQUARED));
	return { axis * scale, w * scale };
}

} // namespace

bool is_sharp(const GrassCollider &p_collider, float p_segment) {
	float bound = 0.0f, thin = 0.0f, blunt = 0.0f;
	Vec3<float> box;
	measure(p_collider.anchor.z, xyz(p_collider.size), bound, box, thin, blunt);
	return !(blunt > STRETCH * p_segment);
}

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
	const Turn<float> &turn = r_collider.turn, &before = r_collider.turn_before;
	const float cosine = dot(turn.axis, before.axis) + turn.w * before.w; // of half the turn's angle
	r_collider.spin = 2.0f * std::sqrt(std::max(1.0f - cosine * cosine, 0.0f));
	Vec3<float> box;
	measure(r_collider.shape, r_collider.size, r_collider.bound, box, r_collider.thin, r_collider.blunt);
	const Vec3<float> way = r_collider.centre - r_collider.centre_before;
	r_collider.grown = 1.0f / (1.0f - p_collider.size.w);
	r_collider.scale = 1.0f;
	r_collider.moved = std::sqrt(dot(way, way)) + std::abs(r_collider.grown - 1.0f) * r_collider.bound +
			(r_collider.shape == GRASS_SPHERE ? 0.0f : r_collider.spin * r_collider.bound);
	r_collider.shortfall = SHORTFALL;
	if (r_collider.shape == GRASS_HULL) {
		r_collider.thin = least_plane(r_collider);
		r_collider.shortfall = r_collider.bound / std::max(r_collider.thin, 1e-12f);
	}
	const Vec3<float> x = turned(turn, { box.x, 0.0f, 0.0f }), y = turned(turn, { 0.0f, box.y, 0.0f }),
					  z = turned(turn, { 0.0f, 0.0f, box.z });
	const float bound = r_collider.bound * BOX_MARGIN;
	r_collider.box = { std::min((std::abs(x.x) + std::abs(y.x) + std::abs(z.x)) * BOX_MARGIN, bound),
		std::min((std::abs(x.y) + std::abs(y.y) + std::abs(z.y)) * BOX_MARGIN, bound),
		std::min((std::abs(x.z) + std::abs(y.z) + std::abs(z.z)) * BOX_MARGIN, bound) };
	return true;
}

namespace {

// Makes it as large as it is at share p_to of the step, after it grew from share p_from on.
void grow_between(TileCollider &r_collider, float p_from, float p_to) {
	const float before = 1.0f / r_collider.grown, from = before + (1.0f - before) * p_from;
	const float to = p_to < 1.0f ? before + (1.0f - before) * p_to : 1.0f;
	r_collider.grown = to / from;
	r_collider.scale = to;
	r_collider.size = r_collider.size * to;
	r_collider.box = r_collider.box * to;
	r_collider.bound *= to;
	r_collider.thin *= to;
	r_collider.blunt *= to;
}

} // namespace

TileCollider between(const TileCollider &p_collider, float p_from, float p_to) {
	TileCollider collider = p_collider;
	const Vec3<float> way = p_collider.centre - p_collider.centre_before;
	collider.centre_before = p_collider.centre_before + way * p_from;
	collider.turn_before = turn_between(p_collider.turn_before, p_collider.turn, p_from);
	if (p_to < 1.0f) {
		collider.centre = p_collider.centre_before + way * p_to;
		collider.turn = turn_between(p_collider.turn_before, p_collider.turn, p_to);
	}
	if (collider.grown != 1.0f) {
		grow_between(collider, p_from, p_to);
	}
	collider.spin = collider.spin * (p_to - p_from) * SPIN_MARGIN;
	const float bound = collider.bound * BOX_MARGIN;
	collider.box = collider.spin > 0.0f ? Vec3<float>{ bound, bound, bound } : collider.box;
	return collider;
}

} // namespace grass

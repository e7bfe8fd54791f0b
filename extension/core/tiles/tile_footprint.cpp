// SPDX-License-Identifier: MIT
#include "core/tiles/tile_footprint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace grass {

namespace {

// n.xyz, d; inside: n.x <= d. In the shape's space, metres.
using Plane = Eigen::Vector4d;
using Planes = std::vector<Plane>;

void add_box(const Eigen::Vector3d &p_half_extents, Planes &r_planes) {
	for (int axis = 0; axis < 3; axis++) {
		for (const double sign : { 1.0, -1.0 }) {
			Plane plane = Plane::Zero();
			plane[axis] = sign;
			plane.w() = p_half_extents[axis];
			r_planes.push_back(plane);
		}
	}
}

void add_hull(const ColliderShape &p_collider, Planes &r_planes) {
	for (const Eigen::Vector4f &plane : p_collider.planes) {
		r_planes.push_back(plane.cast<double>());
	}
}

// Returns the planes of a body that contains the shape.
Planes planes_around(const ColliderShape &p_collider) {
	Planes planes;
	if (p_collider.type == GRASS_HULL) {
		add_hull(p_collider, planes);
	} else {
		add_box(p_collider.get_half_extents(), planes);
	}
	return planes;
}

// Returns the planes of a body inside the shape.
Planes planes_within(const ColliderShape &p_collider) {
	constexpr int SIDES = 8;
	Planes planes;
	if (p_collider.type == GRASS_HULL) {
		add_hull(p_collider, planes);
	} else if (p_collider.type == GRASS_BOX) {
		add_box(p_collider.size, planes);
	} else if (p_collider.type == GRASS_SPHERE) {
		add_box(Eigen::Vector3d::Constant(p_collider.size.x() / std::numbers::sqrt3), planes);
	} else { // rotationally symmetric about y; a capsule without its caps
		for (int i = 0; i < SIDES; i++) {
			const double angle = 2.0 * std::numbers::pi * i / SIDES;
			planes.push_back({ std::cos(angle), 0.0, std::sin(angle), p_collider.size.x() * std::cos(std::numbers::pi / SIDES) });
		}
		planes.push_back({ 0.0, 1.0, 0.0, p_collider.size.y() });
		planes.push_back({ 0.0, -1.0, 0.0, p_collider.size.y() });
	}
	return planes;
}

// A half space in field space.
struct HalfSpace {
	Eigen::Vector3d normal;
	double room;
};

HalfSpace place(const Plane &p_plane, const ColliderPose &p_pose) {
	const Eigen::Vector3d normal = p_pose.rotation * Eigen::Vector3d(p_plane.head<3>());
	return { normal, p_plane.w() + normal.dot(p_pose.position) };
}

} // namespace

TileFootprint::TileFootprint(const ColliderShape &p_collider, const Bounds &p_swept, const TileGrid &p_grid, const TileParams &p_params) :
		_grid(p_grid), _params(p_params) {
	add_outer(p_collider, p_swept);
	add_inner(p_collider, p_collider.before);
	add_inner(p_collider, p_collider.now);
	_is_tall = p_swept.max.y() >= p_params.height;
}

// Adds the outline, widened by as much as the collider moves in the step, since it may be anywhere in between.
void TileFootprint::add_outer(const ColliderShape &p_collider, const Bounds &p_swept) {
	ColliderShape still = p_collider;
	still.before = still.now;
	const Bounds now = still.get_swept_bounds();
	const double way = std::max((now.min - p_swept.min).norm(), (p_swept.max - now.max).norm());
	for (const Plane &plane : planes_around(p_collider)) {
		const HalfSpace half = place(plane, p_collider.now);
		const double least = std::min(half.normal.y() * _params.low, half.normal.y() * _params.height);
		const double blades = (std::abs(half.normal.x()) + std::abs(half.normal.z())) * (0.5 * _grid.get_tile_size() + _params.overhang);
		add_side(half.normal, half.room - least + blades + way, _outer);
	}
}

// Adds its section at the height of the grass, or at its own top or bottom if it does not reach that height.
void TileFootprint::add_inner(const ColliderShape &p_collider, const ColliderPose &p_pose) {
	constexpr double MARGIN = 0.02; // share of its height: at its very top or bottom there may be no section
	ColliderShape still = p_collider;
	still.before = still.now = p_pose;
	const Bounds bounds = still.get_swept_bounds();
	const double margin = MARGIN * (bounds.max.y() - bounds.min.y());
	const double height = std::clamp(0.5 * (_params.low + _params.height), bounds.min.y() + margin, bounds.max.y() - margin);
	for (const Plane &plane : planes_within(p_collider)) {
		const HalfSpace half = place(plane, p_pose);
		const double blades = (std::abs(half.normal.x()) + std::abs(half.normal.z())) * (0.5 * _grid.get_tile_size() + _params.overhang);
		add_side(half.normal, half.room - half.normal.y() * height - blades, _inner);
	}
}

// Adds a side. p_room: for the centre of a tile on the plane y = 0.
void TileFootprint::add_side(const Eigen::Vector3d &p_normal, double p_room, std::vector<Side> &r_sides) const {
	const Eigen::Vector3d first = _grid.get_centre(0, 0);
	const double size = _grid.get_tile_size();
	r_sides.push_back({ size * p_normal.x(), size * p_normal.z(), p_room - p_normal.dot(first) });
}

TileFootprint::Span TileFootprint::clip(const std::vector<Side> &p_sides, int p_z, const Span &p_limits) {
	constexpr double UPRIGHT = 1e-9; // metres for each column: the whole row is on one side
	double low = p_limits.begin, high = p_limits.end - 1;
	for (const Side &side : p_sides) {
		const double room = side.room - side.z * p_z;
		if (side.x > UPRIGHT) {
			high = std::min(high, room / side.x);
		} else if (side.x < -UPRIGHT) {
			low = std::max(low, room / side.x);
		} else if (room < 0.0) {
			return {};
		}
	}
	if (!(low <= high)) {
		return {};
	}
	return { int(std::ceil(low)), int(std::floor(high)) + 1 };
}

} // namespace grass

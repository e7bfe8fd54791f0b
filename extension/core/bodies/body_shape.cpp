// SPDX-License-Identifier: MIT
#include "core/bodies/body_shape.h"

#include "core/bodies/hull.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

// Returns whether a component exceeds p_limit. NaN counts as exceeding it.
bool exceeds(const Eigen::Vector3d &p_value, double p_limit) {
	return !(p_value.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= p_limit);
}

bool sanitise_pose(ColliderPose &r_pose, const char *&r_reason) {
	if (exceeds(r_pose.position, ColliderShape::MAX_POSITION)) {
		r_reason = "its position is not finite or more than 10,000 km away";
		return false;
	}
	const double length = r_pose.rotation.norm();
	if (!(length > 1e-6 && length < 1e6)) {
		r_reason = "its rotation is not a valid rotation";
		return false;
	}
	r_pose.rotation.coeffs() /= length;
	return true;
}

bool sanitise_planes(const std::vector<Eigen::Vector4f> &p_planes, const char *&r_reason) {
	if (p_planes.empty() || p_planes.size() > size_t(Hull::MAX_PLANES)) {
		r_reason = "its hull has no planes or too many";
		return false;
	}
	const auto is_plane = [](const Eigen::Vector4f &p_plane) {
		return p_plane.allFinite() && std::abs(p_plane.head<3>().norm() - 1.0f) < 1e-3f;
	};
	if (!std::all_of(p_planes.begin(), p_planes.end(), is_plane)) {
		r_reason = "a plane of its hull is not finite or not of unit length";
		return false;
	}
	return true;
}

Bounds get_bounds(const Eigen::Vector3d &p_half_extents, const ColliderPose &p_pose) {
	const Eigen::Vector3d half = p_pose.rotation.toRotationMatrix().cwiseAbs() * p_half_extents;
	return { p_pose.position - half, p_pose.position + half };
}

vec4 to_vec4(const Eigen::Vector3f &p_xyz, float p_w) {
	return { p_xyz.x(), p_xyz.y(), p_xyz.z(), p_w };
}

vec4 to_vec4(const Quaternion &p_rotation) {
	return { float(p_rotation.x()), float(p_rotation.y()), float(p_rotation.z()), float(p_rotation.w()) };
}

double handedness(const Eigen::Matrix3d &p_basis) {
	return ColliderShape::mirrors(p_basis) ? -1.0 : 1.0;
}

} // namespace

Eigen::Vector3d ColliderShape::get_half_extents() const {
	switch (type) {
		case GRASS_SPHERE:
			return Eigen::Vector3d::Constant(size.x());
		case GRASS_CAPSULE:
			return { size.x(), size.y() + size.x(), size.x() };
		case GRASS_CYLINDER:
			return { size.x(), size.y(), size.x() };
		default:
			return size;
	}
}

void ColliderShape::grow_from(const Eigen::Vector3d &p_half_extents) {
	const Eigen::Array3d shares = 1.0 - p_half_extents.array() / get_half_extents().array();
	const double least = shares.minCoeff(), most = shares.maxCoeff();
	const bool is_same_shape = least >= -1.0 && most <= 0.5;
	growth = is_same_shape ? std::max(least, 0.0) + std::min(most, 0.0) : 0.0;
}

void ColliderShape::set_poses(const Eigen::Affine3d &p_before, const Eigen::Affine3d &p_now) {
	before = make_pose(p_before);
	now = make_pose(p_now);
}

ColliderPose ColliderShape::make_pose(const Eigen::Affine3d &p_transform) {
	const Eigen::Matrix3d linear = p_transform.linear() * handedness(p_transform.linear());
	Eigen::Matrix3d axes;
	axes.col(0) = linear.col(0).normalized();
	axes.col(2) = axes.col(0).cross(linear.col(1)).normalized();
	axes.col(1) = axes.col(2).cross(axes.col(0));
	return { p_transform.translation(), Quaternion(axes) };
}

Eigen::Vector3d ColliderShape::scale_of(const Eigen::Matrix3d &p_basis) {
	return p_basis.colwise().norm().transpose() * handedness(p_basis);
}

void ColliderShape::scale(const Eigen::Vector3d &p_scale) {
	if (p_scale.isApproxToConstant(1.0, 1e-4) || !p_scale.allFinite()) {
		return;
	}
	const Eigen::Vector3d factors = p_scale.cwiseAbs();
	if (type == GRASS_BOX || type == GRASS_HULL) {
		size = size.cwiseProduct(factors);
	} else { // rotationally symmetric about y: radius, half length along y
		size = { size.x() * std::max(factors.x(), factors.z()), size.y() * factors.y(), 0.0 };
	}
	for (Eigen::Vector4f &plane : planes) { // all other shapes are symmetric about the origin
		const Eigen::Vector3f normal = plane.head<3>().cwiseQuotient(p_scale.cast<float>());
		plane = Eigen::Vector4f(normal.x(), normal.y(), normal.z(), plane.w()) / normal.norm();
	}
}

bool ColliderShape::sanitise(const char *&r_reason) {
	if (type < GRASS_SPHERE || type > GRASS_HULL) {
		r_reason = "its shape is of an unknown type";
		return false;
	}
	if (exceeds(size, MAX_SIZE)) {
		r_reason = "its size is not finite or above 100 km";
		return false;
	}
	if (!std::isfinite(friction)) {
		r_reason = "its friction is not finite";
		return false;
	}
	if (type == GRASS_HULL && !sanitise_planes(planes, r_reason)) {
		return false;
	}
	const double min_axis = type == GRASS_CAPSULE ? 0.0 : MIN_SIZE; // a capsule without an axis is a sphere
	size = Eigen::Vector3d(std::max(size.x(), MIN_SIZE), std::max(size.y(), min_axis), std::max(size.z(), MIN_SIZE));
	friction = std::clamp(friction, 0.0, 1.0);
	return sanitise_pose(now, r_reason) && sanitise_pose(before, r_reason);
}

Bounds ColliderShape::get_swept_bounds() const {
	const Eigen::Vector3d half = get_half_extents();
	const Bounds a = get_bounds(half, before), b = get_bounds(half, now);
	// On its way a point turns along an arc, which departs from its chord by at most r (1 - cos(angle / 2)).
	const double cosine = std::min(1.0, std::abs(before.rotation.dot(now.rotation)));
	const double arc = type == GRASS_SPHERE ? 0.0 : half.norm() * (1.0 - cosine);
	return { (a.min.cwiseMin(b.min).array() - arc).matrix(), (a.max.cwiseMax(b.max).array() + arc).matrix() };
}

bool ColliderShape::has_moved() const {
	constexpr double STILL_DISTANCE = 1e-5, STILL_ANGLE = 1e-4; // metres, radians
	return (now.position - before.position).norm() > STILL_DISTANCE || std::abs(growth) * get_half_extents().maxCoeff() > STILL_DISTANCE ||
			1.0 - std::abs(before.rotation.dot(now.rotation)) > STILL_ANGLE * STILL_ANGLE / 8.0; // 1 - cos(angle / 2)
}

GrassCollider ColliderShape::pack(const TileGrid &p_grid, int p_first_plane) const {
	const TilePlace place = p_grid.get_place(now.position);
	const bool is_hull = type == GRASS_HULL;
	GrassCollider collider;
	collider.anchor = { place.x, place.z, type, is_hull ? p_first_plane : 0 };
	collider.position = to_vec4(place.offset, float(friction));
	collider.rotation = to_vec4(now.rotation);
	collider.position_before = to_vec4(p_grid.get_offset(before.position, place.x, place.z), is_hull ? float(planes.size()) : 0.0f);
	// Keep both rotations in one half of the sphere, so that a blend of the two takes the short way.
	Quaternion turned = before.rotation;
	if (turned.dot(now.rotation) < 0.0) {
		turned.coeffs() = -turned.coeffs();
	}
	collider.rotation_before = to_vec4(turned);
	collider.size = to_vec4(is_hull ? Eigen::Vector3f(float(size.norm()), 0.0f, 0.0f) : Eigen::Vector3f(size.cast<float>()), float(growth));
	return collider;
}

} // namespace grass

// SPDX-License-Identifier: MIT
// The box in which a field looks for objects that may bend it, apart from the bodies that the physics server reports.
#pragma once

#include "core/bodies/body_shape.h"
#include "shared/convert.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/transform3d.hpp>

namespace grass {

struct FieldReach {
	// Margin around the grass, in metres, so that an object is read some ticks before it touches a blade.
	static constexpr double APPROACH = 3.0;

	FieldReach(const godot::Ref<godot::World3D> &p_world, const godot::Transform3D &p_field, const godot::Vector3 &p_half_extents,
			uint32_t p_mask) :
			world(p_world), from_world(to_eigen(p_field).inverse(Eigen::Isometry)), half_extents(to_eigen(p_half_extents)), mask(p_mask) {}

	// Return whether a box is near the grass; false also if it is not finite. In field space:
	bool is_near(const Bounds &p_bounds) const { return is_near(0.5 * (p_bounds.min + p_bounds.max), 0.5 * (p_bounds.max - p_bounds.min)); }
	bool is_near_global(const Eigen::AlignedBox3d &p_box) const {
		return is_near(from_world * Eigen::Vector3d(p_box.center()), from_world.linear().cwiseAbs() * (0.5 * p_box.sizes()));
	}

	const godot::Ref<godot::World3D> world;
	const Eigen::Affine3d from_world; // into the field's space
	const Eigen::Vector3d half_extents; // of the box around its grass, metres
	const uint32_t mask; // physics layers that bend it

private:
	bool is_near(const Eigen::Vector3d &p_middle, const Eigen::Vector3d &p_half) const {
		return ((p_middle.cwiseAbs() - p_half - half_extents).array() <= APPROACH).all();
	}
};

} // namespace grass

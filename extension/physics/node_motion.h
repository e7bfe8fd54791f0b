// SPDX-License-Identifier: MIT
// The motion, from tick to tick, of a node without physics: only its positions show it.
#pragma once

#include "core/bodies/body_shape.h"
#include "core/bodies/motion.h"

#include <Eigen/Geometry>

namespace grass {

class NodeMotion {
public:
	// The friction of an ordinary body, as the tracker scales it.
	static constexpr double FRICTION = 0.5;

	// Sets both poses of r_collider, which is at p_now, field space, in this tick.
	void pose(const Eigen::Affine3d &p_now, const MotionTick &p_tick, ColliderShape &r_collider);
	// Returns the pose in the tick before; the identity if there was none.
	const Eigen::Affine3d &get_before() const { return _before; }
	void forget() { _has_before = false; }

private:
	Eigen::Affine3d _before = Eigen::Affine3d::Identity();
	bool _has_before = false;
	Motion _motion;
};

} // namespace grass

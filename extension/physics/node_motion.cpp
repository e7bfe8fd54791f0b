// SPDX-License-Identifier: MIT
#include "physics/node_motion.h"

namespace grass {

void NodeMotion::pose(const Eigen::Affine3d &p_now, const MotionTick &p_tick, ColliderShape &r_collider) {
	const Eigen::Vector3d nobody_knows = Eigen::Vector3d::Zero(), before = _before.translation(), now = p_now.translation();
	if (!_has_before) {
		_motion.start(now, nobody_knows, nobody_knows, p_tick);
		_before = p_now;
		_has_before = true;
	} else {
		const Eigen::Vector3d from = _motion.follow(before, now, nobody_knows, p_tick);
		const bool is_mirrored = ColliderShape::mirrors(_before.linear()) != ColliderShape::mirrors(p_now.linear());
		if ((from == now && from != before) || is_mirrored) { // it was put there
			_before.linear() = p_now.linear();
		}
		_before.translation() = from;
	}
	r_collider.set_poses(_before, p_now);
	_before = p_now;
}

} // namespace grass

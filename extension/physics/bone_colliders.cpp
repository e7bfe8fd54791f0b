// SPDX-License-Identifier: MIT
#include "physics/bone_colliders.h"

#include "resources/grass_bone_colliders_3d.h"
#include "shared/convert.h"

namespace grass {

namespace {

// Returns the pose of a capsule, whose axis is its y.
Eigen::Affine3d pose_between(const Eigen::Vector3d &p_from, const Eigen::Vector3d &p_to, const Eigen::Affine3d &p_before) {
	Eigen::Affine3d pose = Eigen::Affine3d::Identity();
	pose.linear() = swing_axes(p_before.linear(), p_to - p_from);
	pose.translation() = 0.5 * (p_from + p_to);
	return pose;
}

} // namespace

void BoneColliders::collect(const FieldReach &p_reach, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders) {
	std::map<std::pair<uint64_t, int>, NodeMotion> motions;
	for (const auto &[id, node] : GrassBoneColliders3D::get_all()) {
		if (node->get_world() != p_reach.world) {
			continue;
		}
		const Eigen::AlignedBox3d bounds = node->find_bounds(_reads.engine_calls);
		if (bounds.isEmpty() || !p_reach.is_near_global(bounds)) {
			continue;
		}
		for (const GrassBoneColliders3D::Bone &bone : node->find_bones(_reads.engine_calls)) {
			const std::pair key(id, bone.index);
			const Eigen::Vector3d from = p_reach.from_world * to_eigen(bone.from), to = p_reach.from_world * to_eigen(bone.to);
			ColliderShape collider;
			collider.type = GRASS_CAPSULE;
			collider.size = { bone.radius, 0.5 * (to - from).norm(), bone.radius };
			collider.friction = NodeMotion::FRICTION;
			collider.owner = id;
			NodeMotion &motion = motions[key] = _motions[key];
			motion.pose(pose_between(from, to, motion.get_before()), p_tick, collider);
			r_colliders.push_back(collider);
			_reads.poses++;
		}
	}
	_count = int64_t(motions.size());
	_motions.swap(motions); // keeps those of bones that still exist
}

} // namespace grass

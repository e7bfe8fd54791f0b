// SPDX-License-Identifier: MIT
#include "nodes/bone_colliders.h"

#include "convert.h"
#include "nodes/grass_bone_colliders_3d.h"

namespace grass {

namespace {

// A capsule's axis is its y.
Eigen::Affine3d pose_along(const Eigen::Vector3d &p_from, const Eigen::Vector3d &p_to) {
	Eigen::Affine3d pose = Eigen::Affine3d::Identity();
	pose.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), p_to - p_from).toRotationMatrix();
	pose.translation() = 0.5 * (p_from + p_to);
	return pose;
}

} // namespace

void BoneColliders::collect(const godot::Ref<godot::World3D> &p_world, const godot::Transform3D &p_field, const MotionTick &p_tick,
		std::vector<ColliderShape> &r_colliders) {
	const std::vector<const GrassBoneColliders3D *> nodes = GrassBoneColliders3D::get_all();
	std::map<std::pair<uint64_t, int>, NodeMotion> motions;
	if (!nodes.empty()) {
		const Eigen::Affine3d from_world = to_eigen(p_field).inverse(Eigen::Isometry);
		for (const GrassBoneColliders3D *node : nodes) {
			if (node->get_world_3d() != p_world) {
				continue;
			}
			for (const GrassBoneColliders3D::Bone &bone : node->find_bones()) {
				const std::pair key(uint64_t(node->get_instance_id()), bone.index);
				const Eigen::Vector3d from = from_world * to_eigen(bone.from), to = from_world * to_eigen(bone.to);
				ColliderShape collider;
				collider.type = GRASS_CAPSULE;
				collider.size = { bone.radius, 0.5 * (to - from).norm(), bone.radius };
				collider.friction = NodeMotion::FRICTION;
				collider.owner = key.first;
				motions[key] = _motions[key];
				motions[key].pose(pose_along(from, to), p_tick, collider);
				r_colliders.push_back(collider);
			}
		}
	}
	_count = int64_t(motions.size());
	_motions.swap(motions); // of bones that are still there
}

} // namespace grass

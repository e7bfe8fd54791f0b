// SPDX-License-Identifier: MIT
// The bones of all GrassBoneColliders3D of a world as colliders of a field.
#pragma once

#include "core/bodies/body_shape.h"
#include "nodes/node_motion.h"

#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <map>
#include <utility>
#include <vector>

namespace grass {

class BoneColliders {
public:
	// Appends every bone of p_world, posed in the field's space. p_field: the field's transform (orthonormal).
	void collect(const godot::Ref<godot::World3D> &p_world, const godot::Transform3D &p_field, const MotionTick &p_tick,
			std::vector<ColliderShape> &r_colliders);
	void forget_motion() { _motions.clear(); } // see BodyTracker
	int64_t get_count() const { return _count; } // bones of the world in the last tick

private:
	std::map<std::pair<uint64_t, int>, NodeMotion> _motions; // by node and bone
	int64_t _count = 0;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// Makes colliders of a field from the bones of all GrassBoneColliders3D of a world.
#pragma once

#include "core/bodies/body_reads.h"
#include "core/bodies/body_shape.h"
#include "physics/field_reach.h"
#include "physics/node_motion.h"

#include <map>
#include <utility>
#include <vector>

namespace grass {

class BoneColliders {
public:
	// Appends every bone of skeletons near the grass, posed in the field's space.
	void collect(const FieldReach &p_reach, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders);
	void forget_motion() { _motions.clear(); } // see BodyTracker
	int64_t get_count() const { return _count; } // bones near the grass in the last tick
	const BodyReads &get_reads() const { return _reads; }

private:
	std::map<std::pair<uint64_t, int>, NodeMotion> _motions; // by node and bone
	int64_t _count = 0;
	BodyReads _reads;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// Finds, once a tick for all fields that rest, what bends grass without being reported by an area of the physics server: forces, soft
// bodies, skeletons.
#pragma once

#include "physics/soft_bodies.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace grass {

struct Mover {
	uint64_t world = 0; // instance id
	Eigen::AlignedBox3d box; // global
};

class Movers {
public:
	std::vector<Mover> find(BodyReads &r_reads);

private:
	SoftBodies _soft_bodies; // knows their boxes
};

} // namespace grass

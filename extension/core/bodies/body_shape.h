// SPDX-License-Identifier: MIT
// What pushes the grass, as the CPU sees it: shapes of bodies with their poses now and one step before, in field space
// (metres, y up, ground at y = 0) in double precision.
#pragma once

#include "core/base/tile_grid.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cstdint>
#include <vector>

namespace grass {

// Unaligned: such objects may live in memory that an engine's allocator made.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

struct ColliderPose {
	Eigen::Vector3d position = Eigen::Vector3d::Zero(); // Metres.
	Quaternion rotation = Quaternion::Identity();
};

struct Bounds {
	Eigen::Vector3d min, max; // Field space, metres.
};

// One shape of one body in one step.
struct ColliderShape {
	static constexpr double MAX_POSITION = 1e7, MAX_SIZE = 1e5; // Metres. Beyond that it is a mistake, not a body.
	static constexpr double MIN_SIZE = 1e-4; // Metres; smaller sizes (a capsule's axis excepted) become this.

	int type = GRASS_SPHERE; // GRASS_SPHERE, GRASS_CAPSULE, GRASS_BOX, GRASS_CYLINDER or GRASS_HULL.
	// Sphere: radius; capsule: radius, half the axis between the caps' centres (along y); box: half extents; cylinder:
	// radius, half height (along y). Hull: half extents of the box around it, centred at the shape's origin (put the
	// origin at Hull::centre). Metres.
	Eigen::Vector3d size = Eigen::Vector3d::Constant(0.5);
	uint64_t owner = 0; // Whose it is, for whoever made it; the core passes it on.
	double friction = 0.5; // 0: blades slide freely along it, 1: they stick.
	std::vector<Eigen::Vector4f> planes; // Hull only, in the shape's space: n.xyz, d; n.x <= d inside; metres.
	ColliderPose now, before; // At the end and at the start of the step; equal after a teleport.
	// Which of StepInput::forces it is: then it wakes tiles as a body does, and touches nothing.
	int force = NO_FORCE;
	static constexpr int NO_FORCE = -1;
	uint64_t revision = 0; // of a force: another one whenever it blows otherwise than in the step before
	// Whoever gives it one promises: while it is the same, so is all of the collider. Spares TileManager to look again. 0: none.
	uint64_t stamp = 0;

	// From a transform into field space; scale and shear are left out. Of one that mirrors it is the rotation that is left when all
	// three axes point the other way: its scale_of() is negative, and turns the shape inside out through its origin.
	static ColliderPose make_pose(const Eigen::Affine3d &p_transform);
	static bool mirrors(const Eigen::Matrix3d &p_basis) { return p_basis.determinant() < 0.0; }
	// Along each axis; all three are negative where the basis mirrors.
	static Eigen::Vector3d scale_of(const Eigen::Matrix3d &p_basis);
	// Poses hold rotation only: the shape itself takes the scale_of() its basis.
	void scale(const Eigen::Vector3d &p_scale);
	// Both poses.
	void set_poses(const Eigen::Affine3d &p_before, const Eigen::Affine3d &p_now);

	// Makes it fit for the solver: rotations of unit length, sizes at least MIN_SIZE, friction within [0, 1]. False, with
	// r_reason, for what cannot be mended: an unknown type, values that are not finite, absurdly large or far, a rotation
	// of zero, a hull without planes or with too many. TileManager::update() asks it of every shape.
	[[nodiscard]] bool sanitise(const char *&r_reason);

	// Half extents of a box, axes of the shape, centred at its origin, around it. Metres.
	Eigen::Vector3d get_half_extents() const;

	// A box around everything that it passes on its way from before to now, both ends included. Field space.
	Bounds get_swept_bounds() const;

	// By more than a body trembles that lies still: 0.01 mm or 0.1 mrad in the step.
	bool has_moved() const;

	// As the shaders take it, relative to the tile that its centre is over. p_first_plane: where a hull's planes begin in
	// StepInput::planes.
	GrassCollider pack(const TileGrid &p_grid, int p_first_plane) const;
};

} // namespace grass

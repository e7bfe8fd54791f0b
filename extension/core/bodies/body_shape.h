// SPDX-License-Identifier: MIT
// What pushes the grass, as the CPU sees it: the shapes of bodies with their poses now and one step before, in field space (metres, y up,
// ground at y = 0) and double precision.
#pragma once

#include "core/base/tile_grid.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cstdint>
#include <vector>

namespace grass {

// Unaligned, since an engine's allocator may have made the memory of such objects.
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
	static constexpr double MAX_POSITION = 1e7, MAX_SIZE = 1e5; // Metres. Anything beyond is a mistake, not a body.
	static constexpr double MIN_SIZE = 1e-4; // Metres; smaller sizes (except a capsule's axis) are raised to this.

	int type = GRASS_SPHERE; // GRASS_SPHERE, GRASS_CAPSULE, GRASS_BOX, GRASS_CYLINDER or GRASS_HULL.
	// Sphere: radius; capsule: radius, half the axis between the caps' centres (along y); box: half extents; cylinder:
	// radius, half height (along y). Hull: half extents of the box around it, centred at the shape's origin (put the
	// origin at Hull::centre). Metres.
	Eigen::Vector3d size = Eigen::Vector3d::Constant(0.5);
	uint64_t owner = 0; // Whose shape it is. The caller sets it, and the core passes it on.
	double friction = 0.5; // 0: blades slide freely along it, 1: they stick.
	std::vector<Eigen::Vector4f> planes; // Hull only, in the shape's space: n.xyz, d; n.x <= d inside; metres.
	ColliderPose now, before; // At the end and at the start of the step; equal after a teleport.
	double growth = 0.0; // How much smaller it was at the start of the step, as a share of its size. TileManager sets it by grow_from().
	// The index in StepInput::forces if this is a force: then it wakes tiles as a body does, but touches nothing.
	int force = NO_FORCE;
	static constexpr int NO_FORCE = -1;
	float air = 0.0f; // of a force: the speed of its air where it is strongest now, m/s
	uint64_t revision = 0; // of a force: changes whenever it blows differently than in the step before
	// While a caller keeps this the same, it guarantees that the whole collider is the same, and TileManager need not compare it again. 0:
	// no guarantee.
	uint64_t stamp = 0;

	// Returns the pose of a transform into field space, without scale and shear. A transform that mirrors keeps the rotation that remains
	// when all three axes are reversed: its scale_of() is negative and turns the shape inside out through its origin.
	static ColliderPose make_pose(const Eigen::Affine3d &p_transform);
	static bool mirrors(const Eigen::Matrix3d &p_basis) { return p_basis.determinant() < 0.0; }
	// Returns the scale along each axis; all three are negative where the basis mirrors.
	static Eigen::Vector3d scale_of(const Eigen::Matrix3d &p_basis);
	// Scales the shape by scale_of() of its basis, since poses hold rotations only.
	void scale(const Eigen::Vector3d &p_scale);
	// Sets both poses.
	void set_poses(const Eigen::Affine3d &p_before, const Eigen::Affine3d &p_now);

	// Makes the shape valid for the solver: rotations of unit length, sizes of at least MIN_SIZE, friction within [0, 1]. Returns false,
	// with r_reason, if that is impossible: an unknown type, values that are not finite, absurdly large or far away, a rotation of zero, a
	// hull without planes or with too many. TileManager::update() calls it for every shape.
	[[nodiscard]] bool sanitise(const char *&r_reason);

	// Sets its growth. p_size: the half extents that it had at the start of the step. Only the factor that all of them have in common is
	// growth. If they were less than half or more than twice as large as now, it is another shape.
	void grow_from(const Eigen::Vector3d &p_half_extents);

	// Returns the half extents, metres, of a box around the shape, along its axes and centred at its origin.
	Eigen::Vector3d get_half_extents() const;

	// Returns a box in field space around everything that the shape passes from before to now, both ends included.
	Bounds get_swept_bounds() const;

	// Returns whether it moved or grew in the step by more than a resting body trembles: 0.01 mm or 0.1 mrad.
	bool has_moved() const;

	// Returns the record for the shaders, relative to the tile below its centre. p_first_plane: index in StepInput::planes of a hull's
	// first plane.
	GrassCollider pack(const TileGrid &p_grid, int p_first_plane) const;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// Where a body was and is in a field, and how much of that is motion: bodies that are put somewhere bend nothing on the way.
#pragma once

#include "core/bodies/body_shape.h"
#include "core/bodies/motion.h"
#include "physics/field_path.h"
#include "physics/server_body.h"

#include <Eigen/Geometry>

#include <vector>

namespace grass {

class ShapeWarnings;

// The data that following a body in a tick reads and writes, besides the body.
struct BodyTick {
	const FieldPath &field;
	const MotionTick &tick;
	std::vector<ColliderShape> &colliders;
	BodyReads &reads;
	uint64_t &stamps; // of colliders; number given so far
	ShapeWarnings &warnings;
	const godot::Callable &woke; // see ServerBody::watch_sleep()
	int look_every; // ticks between two looks at a body
};

class BodyMotion {
public:
	bool is_known() const { return _past != Past::NONE; } // from a tick before
	bool was_put() const { return _past != Past::FOLLOWED; } // get_before() is not its place in the last tick
	// Returns where it was in the tick before; in a tick, after follow(), where its path in the tick begins. In field space.
	const Eigen::Affine3d &get_before() const { return _before; }
	// Returns where it was in the world in the last tick: a field may move over resting ground.
	const godot::Transform3D &get_world_before() const { return _world_before; }
	bool is_open() const { return _motion.is_open(); } // see Motion
	bool is_at_rest() const { return _motion.is_at_rest(); }

	// Follow it in a tick, in this order.
	Eigen::Affine3d pose_of(const ServerBody &p_body, const godot::Transform3D &p_world, const FieldPath &p_field) const;
	// Returns whether it is ground, which bends no grass.
	bool stand(const ServerBody &p_body, const godot::Transform3D &p_world, const Eigen::Affine3d &p_now, const FieldPath &p_field);
	// Follows it to its pose now. p_waited: ticks since it was last followed, whose motion bends nothing.
	void follow(const ServerBody &p_body, const Eigen::Affine3d &p_now, int p_waited, const BodyTick &p_tick);
	void end(const Eigen::Affine3d &p_now) { _before = p_now; }

	void stay() { _past = Past::FOLLOWED; } // it is taken to be where it was
	void forget() { _past = Past::NONE; } // time has passed in which it was not followed

private:
	// What is known of the tick before.
	enum class Past {
		NONE,
		PUT, // it was put where it is since then
		FOLLOWED,
	};

	bool rides(const Eigen::Affine3d &p_now) const;
	bool follows_late(const ServerBody &p_body, const godot::Transform3D &p_world, const FieldPath &p_field) const;
	void catch_up(const Eigen::Affine3d &p_now, int p_waited);
	void begin(const ServerBody &p_body, const Eigen::Affine3d &p_now, const Eigen::Vector3d &p_passing, const BodyTick &p_tick);
	void judge(const ServerBody &p_body, const Eigen::Affine3d &p_now, const BodyTick &p_tick);
	void judge_turn(const ServerBody &p_body, const Eigen::Affine3d &p_now, const BodyTick &p_tick);

	godot::Transform3D _world_before;
	Motion _motion; // in field space
	Eigen::Affine3d _before = Eigen::Affine3d::Identity();
	Past _past = Past::NONE;
	int _still_ticks = 0; // without motion, of a static one; starts as ground
};

} // namespace grass

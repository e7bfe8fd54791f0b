// SPDX-License-Identifier: MIT
// Finds the physics bodies in a field, without any setup by the user: an area in the physics server reports which bodies overlap the field,
// and in every tick their shapes and poses become colliders.
#pragma once

#include "core/base/parallel_for.h"
#include "core/bodies/body_reads.h"
#include "core/bodies/body_shape.h"
#include "core/bodies/motion.h"
#include "core/tiles/tiles.h"
#include "physics/physics_shapes.h"
#include "physics/resting_bodies.h"
#include "shared/watched_box.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/collision_object3d.hpp>
#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <array>
#include <map>
#include <vector>

namespace grass {

class BodyTracker {
public:
	~BodyTracker() { stop(); }

	// Starts to watch a box, see set_box(). p_changed is called with the five arguments of PhysicsServer3D.area_set_monitor_callback, and
	// must pass the first three to body_changed(). p_woke is called with the id of a body's RID, and must pass it to body_woke().
	// p_area_changed: the same for areas, with the arguments of area_set_area_monitor_callback. p_carriers: instance ids of nodes that
	// carry the field. Their bodies are its ground.
	void start(const godot::RID &p_space, const godot::Callable &p_changed, const godot::Callable &p_area_changed,
			const godot::Callable &p_woke, uint32_t p_mask, std::vector<uint64_t> &&p_carriers);
	// Watches p_half_extents (metres) around p_transform, and some metres more, so that fast bodies are known in time. p_delta: seconds of
	// a tick.
	void set_box(const godot::Transform3D &p_transform, const godot::Vector3 &p_half_extents, double p_delta);
	void set_mask(uint32_t p_mask);
	// Returns true if a node carries the field.
	bool carries(uint64_t p_instance_id) const;
	void stop();

	void body_changed(int64_t p_status, const godot::RID &p_body, int64_t p_instance_id);
	// Must be called when the physics server puts a body to sleep or wakes it.
	void body_woke(int64_t p_body);
	// Fills r_colliders with every shape that may touch grass in this tick, posed in the field's space. Pass the r_colliders of the last
	// call unchanged: those of resting bodies are not written again. p_field: the field's transform (orthonormal); the tracker sets
	// p_tick.watched itself. p_tiles: the field's tiles, as they received these colliders in the tick before. p_parallel_for reads crowds,
	// with the same result; its threads call the physics server.
	void collect(const godot::Transform3D &p_field, const MotionTick &p_tick, const TileManager &p_tiles, const ParallelFor &p_parallel_for,
			std::vector<ColliderShape> &r_colliders);
	// Must be called when time has passed without collect(): the way from the bodies' last positions is not motion then.
	void forget_motion();

	// Drops bodies that left. Must be called instead of collect() in ticks that are skipped.
	void forget_left();

	// Returns true if so many bodies moved in this tick that threads are worth their cost.
	bool is_crowded() const;
	const BodyReads &get_reads() const { return _reads; }
	int64_t body_count() const;
	std::vector<uint64_t> find_instances(size_t p_most) const; // ids of the first bodies
	// Returns false unless every body rests, so that collect() has nothing to do until one of them moves, sleeps no more, enters or leaves.
	// Appends those that may be moved without a word.
	bool find_resting(std::vector<RestingBody> &r_bodies) const;
	uint32_t get_mask() const { return _mask; }
	const godot::Vector3 &get_box_extents() const { return _box.get_half_extents(); } // of the watched box
	// Returns the number of convex pieces of moving bodies' trimeshes in the last tick.
	int64_t get_mesh_pieces() const { return _mesh_pieces; }

private:
	// Ticks between two reads of a body that waits for slots. More: it is noticed later once slots are free. Fewer: crowds cost more.
	static constexpr int WAITING_TICKS = 8;
	// Ticks after a jump of the field for which bodies that the server reports as gone are kept, since kinematic ones follow late.
	static constexpr int JUMP_TICKS = 6;

	struct Body {
		// First the members that a tick reads of a resting body.
		bool is_asleep = false; // according to the server; it is not queried until its node reports a change
		bool is_at_rest = false; // asleep or not: its next tick equals its last one, if it has not moved
		bool is_lost = false; // has left, or was freed
		bool is_carrier = false; // carries the field, and thus is its ground, however it moves
		bool is_plain = false; // until the next check only its pose is needed, and nothing that it shares with others
		bool is_written = false, is_written_still = false; // its colliders are at first_collider; with a single pose
		int next_read = 0; // ticks until the next check whether it was moved while asleep
		int waited = 0; // ticks since it was last read, while the pool has no slot for a tile below it
		int turn = 0; // the ticks in which it is read while it waits
		int next_look = 0, lively_looks = 0; // ticks until the next check; remaining checks in every tick
		int left_for = 0; // ticks since its last shape left the area
		int64_t overlaps = 0; // number of its shapes in the area
		uint32_t first_collider = 0, colliders = 0; // index of the first, and number
		int64_t mesh_pieces = 0; // of these
		uint64_t state_id = 0; // of the server's state object, which has its pose and ends with the body
		godot::PhysicsDirectBodyState3D *state = nullptr;
		const godot::CollisionObject3D *node = nullptr; // of a body that is put where its node is; nullptr: the server moves it
		godot::Transform3D world_before; // in the last tick; in the world, since a field may move over resting ground

		// The members that a tick reads of a body that moves.
		std::vector<TrackedShape> shapes; // from the last check; none while it is ground
		Motion motion; // in field space
		Eigen::Affine3d before = Eigen::Affine3d::Identity(); // in field space, in the last tick
		Eigen::Vector3d scale = Eigen::Vector3d::Ones(); // its own, which its shapes inherit; negative if it mirrors
		bool has_before = false;
		bool was_put = true; // since then: `before` is not its place in the last tick
		bool is_static = false; // ground while it rests: static since it was found, and not of a node that is made to move
		bool is_driven = false; // moves according to its velocity; a character's velocity is in its node
		bool is_character = false;
		int still_ticks = 0; // without motion, of a static one; starts as ground
		uint64_t instance_id = 0;

		godot::RID rid;
		int next_look_at_all = 0; // checks until the next check of everything
		double friction = 0.0; // of blades along it
		std::vector<bool> disabled; // by shape
		bool is_watched = false; // its node reports when it wakes
	};
	// The field's pose in this tick, and in the one before.
	struct FieldPose {
		Eigen::Affine3d from_world, from_world_before;
		bool has_jumped = false;
		bool has_moved = false; // since the tick before
		bool has_begun = false; // it has moved, and was at rest before
	};

	// The data that following a body reads and writes, besides the body.
	struct Following {
		const FieldPose &field;
		const MotionTick &tick;
		std::vector<ColliderShape> &colliders;
		BodyReads &reads;
		uint64_t &stamps; // of colliders; number given so far
	};
	// A plain body whose colliders have their places in this tick.
	struct Member {
		Body *body;
		uint64_t stamps; // given before its own
	};

	FieldPose pose_field(const godot::Transform3D &p_field);
	void line_up();
	void visit(Body &r_body, const TileManager &p_tiles, const Following &p_following);
	void read(Body &r_body, const Following &p_following);
	void place(Body &r_body) const;
	static bool keep_at_rest(Body &r_body, const FieldPose &p_field);
	void follow(Body &r_body, const godot::Transform3D &p_world, bool p_is_due, const Following &p_following);
	static bool find_state(Body &r_body, BodyReads &r_reads);
	bool has_left(Body &r_body) const;
	// body_crowd.cpp
	static bool is_plain(const Body &p_body);
	static bool is_plain_now(const Body &p_body);
	void join_crowd(Body &r_body, const Following &p_following);
	void follow_crowd(const Following &p_following, const ParallelFor &p_parallel_for);
	void follow_member(Body &r_body, const Following &p_following);
	void drop_lost(std::vector<ColliderShape> &r_colliders);
	// body_look.cpp
	static int look_every(size_t p_bodies);
	bool look(Body &r_body);
	static const godot::CollisionObject3D *find_leader(const Body &p_body, int64_t p_mode, BodyReads &r_reads);
	void look_at_shapes(Body &r_body);
	bool read_shapes(Body &r_body);
	static void fit_part(const Body &p_body, ShapePart &r_part);
	static void fit_scale(Body &r_body, const Eigen::Affine3d &p_now);
	static bool is_odd(const TrackedShape &p_shape); // to be warned of once it moves
	void warn_of(const Body &p_body, const TrackedShape &p_shape);
	void read_traits(Body &r_body, int32_t p_count);
	void follow_sleep(Body &r_body, const godot::Transform3D &p_world, bool p_is_due);
	void watch_sleep(Body &r_body, bool p_watch);
	void write_shapes(Body &r_body, const Eigen::Affine3d &p_now, const Following &p_following);
	// body_motion.cpp
	bool is_its_turn(const Body &p_body) const { return _tick == p_body.turn; }
	static bool waits_for_slots(const Body &p_body, const TileManager &p_tiles);
	void wait(Body &r_body, const Following &p_following);
	static void catch_up(Body &r_body, const Eigen::Affine3d &p_now);
	static godot::Transform3D find_place(const Body &p_body, BodyReads &r_reads);
	static bool follows_late(const Body &p_body, const godot::Transform3D &p_world, const FieldPose &p_field);
	static bool rides(const Body &p_body, const Eigen::Affine3d &p_now);
	Eigen::Affine3d pose_of(const Body &p_body, const godot::Transform3D &p_world, const FieldPose &p_field) const;
	bool is_ground(Body &r_body, const godot::Transform3D &p_world, bool p_is_carried) const;
	static Eigen::Vector3d server_place(const Body &p_body, const Eigen::Affine3d &p_now, const Following &p_following);
	static Eigen::Vector3d server_velocity(const Body &p_body, BodyReads &r_reads);
	static Eigen::Vector3d own_velocity(const Body &p_body, const Eigen::Vector3d &p_motion, BodyReads &r_reads);
	static void judge_motion(Body &r_body, const Eigen::Affine3d &p_now, const Following &p_following);
	static void judge_turn(Body &r_body, const Eigen::Affine3d &p_now, const Following &p_following);

	WatchedBox _box; // including the approach
	godot::Callable _woke;
	double _approach = 0.0; // metres
	uint32_t _mask = 1;
	std::vector<uint64_t> _carriers; // instance ids
	Eigen::Affine3d _from_world_before = Eigen::Affine3d::Identity();
	bool _has_field_before = false, _has_field_moved = false; // there was a tick before; the field moved in it
	int _ticks_since_jump = 1 << 30;
	std::array<bool, 3> _has_warned{}; // of a height map, a trimesh, a convex polygon
	int64_t _mesh_pieces = 0; // in this tick
	size_t _written = 0; // colliders in this tick that have their places
	int _tick = 0; // calls of collect(), modulo WAITING_TICKS
	uint64_t _stamps = 0; // of colliders; number given so far
	int _look_every = 0; // ticks between two checks of a body, in this tick
	BodyReads _reads; // since construction
	std::map<uint64_t, Body> _bodies; // by the RID's id: the order of colliders is the same in every run
	std::vector<Body *> _line; // the same in their order, since walking through a map waits for each step; empty once bodies come or go
	std::vector<Member> _crowd; // of this tick: the plain ones that are read, in the order of the line
	bool _has_lost = false; // one of them was lost in this tick
};

} // namespace grass

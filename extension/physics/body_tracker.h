// SPDX-License-Identifier: MIT
// Finds the physics bodies in a field, without any setup by the user: an area in the physics server reports which bodies overlap the field,
// and in every tick their shapes and poses become colliders. docs/internals/bodies.md follows a body through a tick.
#pragma once

#include "core/base/parallel_for.h"
#include "core/tiles/tiles.h"
#include "physics/field_path.h"
#include "physics/resting_bodies.h"
#include "physics/tracked_body.h"
#include "shared/watched_box.h"

#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <map>
#include <vector>

namespace grass {

class BodyTracker {
public:
	~BodyTracker() { stop(); }

	// Starts to watch a box, see set_box(). p_changed gets the five arguments of PhysicsServer3D.area_set_monitor_callback, and must pass
	// the first three to body_changed(). p_woke gets the id of a body's RID, and must pass it to body_woke(). p_area_changed: the same for
	// areas, with the arguments of area_set_area_monitor_callback. p_carriers: instance ids of nodes that carry the field. Their bodies are
	// its ground.
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
	// Returns whether every body rests: then collect() has nothing to do until one of them moves, wakes, enters or leaves. Appends those
	// that may be moved without notice.
	bool find_resting(std::vector<RestingBody> &r_bodies) const;
	uint32_t get_mask() const { return _mask; }
	const godot::Vector3 &get_box_extents() const { return _box.get_half_extents(); } // of the watched box
	// Returns the number of convex pieces of moving bodies' trimeshes in the last tick.
	int64_t get_mesh_pieces() const { return _mesh_pieces; }

private:
	// Ticks between two reads of a body that waits for slots. More: it is noticed later once slots are free. Fewer: crowds cost more.
	static constexpr int WAITING_TICKS = 8;

	// A plain body whose colliders have their places in this tick.
	struct Member {
		TrackedBody *body;
		uint64_t stamps; // given before its own
	};

	void line_up();
	template <typename F> void drop(F &&p_is_gone);
	void visit(TrackedBody &r_body, const TileManager &p_tiles, const BodyTick &p_tick);
	// body_crowd.cpp
	void join_crowd(TrackedBody &r_body, const BodyTick &p_tick);
	void follow_crowd(const BodyTick &p_tick, const ParallelFor &p_parallel_for);
	void drop_lost(std::vector<ColliderShape> &r_colliders);

	WatchedBox _box; // including the approach
	godot::Callable _woke;
	double _approach = 0.0; // metres
	uint32_t _mask = 1;
	std::vector<uint64_t> _carriers; // instance ids
	FieldPath _field;
	ShapeWarnings _warnings;
	int64_t _mesh_pieces = 0; // in this tick
	size_t _written = 0; // colliders in this tick that have their places
	int _tick = 0; // calls of collect(), modulo WAITING_TICKS
	uint64_t _stamps = 0; // of colliders; number given so far
	BodyReads _reads; // since construction
	std::map<uint64_t, TrackedBody> _bodies; // by the RID's id: the order of colliders is the same in every run
	std::vector<TrackedBody *>
			_line; // the same in their order, since walking through a map waits for each step; empty once bodies come or go
	std::vector<Member> _crowd; // of this tick: the plain ones that are read, in the order of the line
	bool _has_lost = false; // one of them was lost in this tick
};

} // namespace grass

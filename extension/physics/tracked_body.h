// SPDX-License-Identifier: MIT
// A body near a field, from tick to tick. docs/internals/bodies.md draws its states.
#pragma once

#include "core/tiles/tiles.h"
#include "physics/body_motion.h"
#include "physics/body_shapes.h"
#include "physics/resting_bodies.h"
#include "physics/server_body.h"

#include <cstdint>

namespace grass {

struct TrackedBody {
	// How a tick treats it.
	enum class State {
		FULL, // all of it is read
		PLAIN, // until the next look only its pose is needed, and nothing that it shares with others
		ASLEEP, // according to the server; it is not queried until its node reports a change
		LOST, // has left, or was freed
	};

	TrackedBody(const godot::RID &p_rid, uint64_t p_instance_id, bool p_is_carrier) : server(p_rid, p_instance_id, p_is_carrier) {}

	bool is_near() const { return overlaps > 0; }
	bool is_plain_now() const { return state == State::PLAIN && is_near() && next_look > 0; }
	// Returns whether it needs no tick until it reports a change, or is moved without notice.
	bool rests() const;
	// Returns whether following it would have no effect: the full pool had no slot for any tile that it met.
	bool waits_for_slots(const TileManager &p_tiles) const;

	// Follow it in one tick, each in another state. p_place: where its colliders begin in that tick.
	void sleep(size_t p_place, const BodyTick &p_tick);
	void put_off(size_t p_place, const BodyTick &p_tick);
	void read(size_t p_place, const BodyTick &p_tick);
	void read_pose(const BodyTick &p_tick); // of a plain one, which has its place; on any thread

	void stir(); // it may have changed
	void wake();
	void forget_motion();

	// First the members that a tick reads of a resting body.
	State state = State::FULL;
	BodyColliders colliders;
	int next_read = 0; // ticks until the next check whether it was moved while asleep
	int waited = 0; // ticks since it was last read, while the pool has no slot for a tile below it
	int turn = 0; // the ticks in which it is read while it waits
	int next_look = 0; // ticks until the next look at its kind and shapes
	int left_for = 0; // ticks since its last shape left the area
	int64_t overlaps = 0; // number of its shapes in the area
	ServerBody server;
	BodyMotion motion;
	BodyShapes shapes;

private:
	bool look(const BodyTick &p_tick);
	bool has_left(const FieldPath &p_field);
	bool is_plain() const;
	bool keep_at_rest(const FieldPath &p_field);
	void follow(const godot::Transform3D &p_world, bool p_is_due, const BodyTick &p_tick);
	void follow_sleep(const godot::Transform3D &p_world, bool p_is_due, const BodyTick &p_tick);
};

} // namespace grass

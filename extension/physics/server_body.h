// SPDX-License-Identifier: MIT
// One body of the physics server: how it moves, and where it is. Calls into the engine are most of the cost of a body, so they are counted.
#pragma once

#include "core/bodies/body_reads.h"

#include <Eigen/Core>

#include <godot_cpp/classes/collision_object3d.hpp>
#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <cstdint>
#include <vector>

namespace grass {

class ServerBody {
public:
	enum class Kind {
		PUT, // it is put where it is, by scripts as a rule
		DRIVEN, // its velocity moves it
		CHARACTER, // the velocity in its node moves it
		STATIC, // it is ground while it rests: static since it was found, and not of a node that is made to move
		CARRIER, // it carries the field, and is its ground however it moves
	};

	ServerBody(const godot::RID &p_rid, uint64_t p_instance_id, bool p_is_carrier) :
			_instance_id(p_instance_id), _kind(p_is_carrier ? Kind::CARRIER : Kind::PUT), _rid(p_rid) {}

	Kind get_kind() const { return _kind; }
	const godot::RID &get_rid() const { return _rid; }
	uint64_t get_instance_id() const { return _instance_id; } // of its node
	// Finds the body. Must be called first in each tick that reads it. Returns false once it is freed: it may stay listed until the
	// server's next report.
	bool find(BodyReads &r_reads);
	bool is_found() const { return _state_id != 0; }
	// Returns the object whose transform changes when the body moves.
	uint64_t get_mover() const { return _node != nullptr ? _instance_id : _state_id; }
	bool has_leader() const { return _node != nullptr; }

	// Reads its kind. p_has_moved: it was not ground before.
	void look(bool p_has_moved, BodyReads &r_reads);
	// Returns the body's pose in this tick. A node that a script moves updates the server after the field's tick, and the server moves the
	// body even later: the picture shows the body at its node.
	godot::Transform3D find_place(BodyReads &r_reads) const;
	godot::Vector3 find_server_place(BodyReads &r_reads) const; // to which its velocity led; its node may be a tick ahead
	// Return velocities in the world, metres or radians per second. The server's velocity of a body that is put follows from its places,
	// including teleports.
	Eigen::Vector3d find_server_velocity(BodyReads &r_reads) const;
	Eigen::Vector3d find_turning(BodyReads &r_reads) const;
	// Returns the velocity that moves it; zero if unknown. p_motion: its motion in this tick, to choose between the velocity that a
	// character intended and the one that was possible.
	Eigen::Vector3d find_own_velocity(const Eigen::Vector3d &p_motion, BodyReads &r_reads) const;
	// Returns the friction of blades along it.
	double find_friction(BodyReads &r_reads) const;
	// Returns which of its p_count shapes its node has disabled.
	std::vector<bool> find_disabled(int32_t p_count, BodyReads &r_reads) const;

	// Begins to listen to its node, once it sleeps, since the server does not report when it wakes. p_woke: called with the id of its RID.
	// Returns whether the node reports it.
	bool watch_sleep(const godot::Callable &p_woke, BodyReads &r_reads);
	void stop_watching(const godot::Callable &p_woke);

private:
	const godot::CollisionObject3D *find_leader(int64_t p_mode, BodyReads &r_reads) const;

	// First the members that a tick reads of a body that moves.
	uint64_t _instance_id;
	uint64_t _state_id = 0; // of the server's state object, which has its pose and ends with the body
	godot::PhysicsDirectBodyState3D *_state = nullptr;
	const godot::CollisionObject3D *_node = nullptr; // of a body that is put where its node is; nullptr: the server moves it
	Kind _kind;

	bool _is_watched = false; // its node reports when it wakes
	godot::RID _rid;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// The physics ticks of a GrassField: collects what bends the grass, lets the field simulate, and reports bodies that enter and leave the
// grass. Rests while a tick would change nothing (docs/history/0100-fields-that-rest.md).
#pragma once

#include "field/movers.h"
#include "nodes/field_parts.h"
#include "nodes/field_record.h"
#include "physics/resting_bodies.h"
#include "shared/frames.h"

#include <godot_cpp/variant/callable.hpp>

#include <span>
#include <vector>

namespace grass {

class FieldTicks {
	friend struct FieldApi;

public:
	explicit FieldTicks(FieldParts &p_parts) : _parts(p_parts) {}

	// What the node calls back: see BodyTracker::start().
	struct Callbacks {
		godot::Callable body_changed, area_changed, body_woke;
	};
	void enter(const Callbacks &p_callbacks); // must be called when the node enters the tree
	void leave(); // must be called when it leaves the tree
	// Emits that all bodies have left the grass. Scripts run: afterwards the field may be gone.
	void emit_leaving();

	bool needs_tick() const;
	void tick(double p_delta); // scripts run: afterwards the field may be gone
	// Must be called after tick(). If nothing is left to do, rests until something calls stir(), and returns the bodies to watch meanwhile.
	std::vector<RestingBody> rest();
	void stir() { _rests = false; }
	bool is_stirred_by(std::span<const Mover> p_movers) const; // one of them is near
	bool is_resting() const { return _rests; }
	void count_reads(const BodyReads &p_reads) { _shared_reads.add(p_reads); } // that serve all fields

	// Shows what changed in the map: in a tick or a frame, whichever is next.
	void update_map();
	// Returns the share of the last step in this frame: 1 unless blades moved in this tick and the engine interpolates.
	float find_share() const;
	void skip_between() { _moved_in = UINT64_MAX; } // the node was moved elsewhere: do not interpolate between the two places

	void body_changed(int64_t p_status, const godot::RID &p_body, int64_t p_instance_id);
	void area_changed(int64_t p_status, int64_t p_instance_id);
	void body_woke(int64_t p_body);
	void register_collider(godot::Node3D *p_node, const godot::Ref<godot::Shape3D> &p_shape);
	void unregister_collider(godot::Node3D *p_node);

	double get_gather_ms() const { return _gather_ms; }
	void add_to(FieldStatistics &r_statistics) const;

private:
	bool can_rest(std::vector<RestingBody> &r_bodies) const;
	bool update_plants();
	bool simulate(double p_delta);
	void play();
	bool is_listened_to() const;
	void emit_visits();
	bool emit_for_each(const char *p_signal, const std::vector<uint64_t> &p_bodies);

	FieldParts &_parts;
	FieldRecord _record{ _parts };
	bool _rests = false; // until stir()
	uint64_t _world = 0; // its instance id
	UndrawnTicks _undrawn;
	uint64_t _moved_in = UINT64_MAX; // the physics tick in which a step last moved blades; none if they are drawn without interpolation
	int64_t _visited = 0;
	BodyReads _shared_reads;
	double _gather_ms = 0.0; // CPU time of reading bodies in the last tick
};

} // namespace grass

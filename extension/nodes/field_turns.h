// SPDX-License-Identifier: MIT
// Calls the fields that have something to do, once a tick and once a frame. The others rest and cost next to nothing: however many there
// are, the engine makes one call (docs/history/0100-fields-that-rest.md).
#pragma once

#include "field/movers.h"
#include "physics/resting_bodies.h"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/object.hpp>

#include <cstdint>

namespace grass {

class GrassField;

class FieldTurns : public godot::Object {
	GDCLASS(FieldTurns, godot::Object)

public:
	// Starts the turns of p_inside's tree. Cheap after the first call.
	static void start(godot::Node *p_inside);
	// Must be called when a field leaves the tree.
	static void remove(const GrassField &p_field);
	// Must be called when the library is unloaded.
	static void free_singleton();

protected:
	static void _bind_methods() {}

private:
	void _begin_tick();
	void _begin_frame();
	// Run from the engine's message queue: shared/script_call.h.
	void _tick();
	void _frame();
	void stir_by_bodies();
	void stir_by_movers();
	static void count(const BodyReads &p_reads);

	static FieldTurns *_singleton;
	uint64_t _tree = 0; // instance id
	RestingBodies _bodies;
	Movers _movers;
};

} // namespace grass

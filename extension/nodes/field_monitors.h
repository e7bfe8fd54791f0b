// SPDX-License-Identifier: MIT
// Custom monitors in the engine's debugger: what all fields of the running game do and cost in total. They exist as long as any field does.
#pragma once

#include <godot_cpp/classes/object.hpp>

#include <array>
#include <vector>

namespace grass {

class GrassField;

// A number to which each field adds its share.
enum FieldMonitor {
	MONITOR_AWAKE_TILES,
	MONITOR_SIMULATED_BLADES, // in a tick
	MONITOR_DRAWN_BLADES,
	MONITOR_DRAWN_TRIANGLES,
	MONITOR_MANAGEMENT, // seconds of CPU time in a tick
	MONITOR_SIMULATE, // seconds in a tick
	MONITOR_CULL, // seconds in a frame
	MONITOR_MEMORY, // bytes
	MONITOR_COUNT,
};

class FieldMonitors : public godot::Object {
	GDCLASS(FieldMonitors, godot::Object)

public:
	// Counts p_field from now on, until remove(). Main thread only.
	static void add(GrassField *p_field);
	static void remove(GrassField *p_field);
	static std::vector<GrassField *> get_fields(); // all fields that count: those in the tree
	// Must be called when the library is unloaded.
	static void free_singleton();

protected:
	static void _bind_methods() {}

private:
	double _read(int64_t p_monitor);
	void show();
	void hide();

	static FieldMonitors *_singleton;
	std::vector<GrassField *> _fields;
	std::array<bool, MONITOR_COUNT> _is_shown{}; // set by show(); other monitors with these names belong to a script
};

} // namespace grass

// SPDX-License-Identifier: MIT
// Whether the engine renders anything, and how long ago it did.
#pragma once

#include <godot_cpp/classes/display_server.hpp>
#include <godot_cpp/classes/engine.hpp>

#include <atomic>
#include <cstdint>

namespace grass {

// Returns false in an engine that runs headless: it has no renderer.
inline bool draws_frames() {
	return godot::DisplayServer::get_singleton()->get_name() != "headless";
}

// The last process frame that was drawn. Each field writes it before it is drawn; any thread reads it. Engine::get_frames_drawn() also
// counts other things: waits for the device.
inline std::atomic<uint64_t> last_drawn_frame = 0;

// Ticks without a drawn frame after which fields no longer wait for one: the window is minimised, or a script has stopped the rendering.
// More: more piles up in the engine, which keeps all that its device was given until a frame ends. Fewer: a frame that is merely slow, of
// at most `max_physics_steps_per_frame` (8) ticks, would have to wait for the device.
constexpr uint64_t UNDRAWN_TICKS = 32;

// Counts ticks since the last drawn frame.
class UndrawnTicks {
public:
	// Counts a tick. Must be called at least once in each. Returns true once in every UNDRAWN_TICKS-th tick without a drawn frame.
	bool count(uint64_t p_drawn_frame, uint64_t p_tick) {
		if (_drawn_frame != p_drawn_frame) {
			_drawn_frame = p_drawn_frame;
			_since = p_tick;
		}
		const bool is_due = p_tick >= _since + UNDRAWN_TICKS;
		_since = is_due ? p_tick : _since;
		return is_due;
	}

private:
	uint64_t _drawn_frame = 0, _since = 0;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// The memory of a number of slots on the device. A driver takes milliseconds to make much of it, so it can be made on any thread, beside
// the frames. Everything else must be called on the render thread, the destructor too.
#pragma once

#include "gpu/device.h"
#include "gpu/pool_rows.h"

#include <array>

namespace grass {

class PoolRoom {
public:
	struct Kind {
		bool has_growth, has_species; // of blades
		bool is_mixed, has_motion; // frames show a mix of two steps; motion vectors are read
	};

	PoolRoom(int p_slots, const Kind &p_kind);
	~PoolRoom();
	PoolRoom(const PoolRoom &) = delete;
	PoolRoom &operator=(const PoolRoom &) = delete;

	int get_slots() const { return _slots; }
	// Returns a texture, which belongs to the caller from now on. One that its kind does not have is made now.
	godot::RID take_rows(Rows p_rows);

	// Sets all buffers to zeros.
	void clear();
	// Returns the bytes of each slot of a field with a map, several species and motion vectors. p_is_mixed: see Kind.
	static int64_t find_slot_bytes(bool p_is_mixed);

	// By slot, see GpuPool. What is in them is undefined.
	GpuBuffer knots, halves, twists, energy, growth, blade_species;

	static constexpr int64_t TWIST_BYTES = int64_t(GRASS_LENGTH_ROW + 1) * GRASS_BLADES_PER_TILE * int64_t(sizeof(float)); // of a slot
	static constexpr int64_t GROWTH_BYTES = int64_t(sizeof(SlotGrowth::blades)), SPECIES_BYTES = int64_t(sizeof(SlotGrowth::species));

private:
	int _slots;
	std::array<godot::RID, ALL_ROWS> _rows;
};

} // namespace grass

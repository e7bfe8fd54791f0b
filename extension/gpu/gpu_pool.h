// SPDX-License-Identifier: MIT
// The slots of a field on the device: how the blades of its awake tiles are bent, for the passes that move them, and the textures that show
// it. Render thread.
#pragma once

#include "gpu/knot_reader.h"
#include "gpu/pool_mix.h"
#include "gpu/pool_room.h"
#include "gpu/pool_rows.h"

#include <godot_cpp/classes/texture2drd.hpp>

namespace grass {

class GpuPool {
public:
	// Creates the pool. p_shown: receives the texture that the picture reads.
	void create(const godot::Ref<godot::Texture2DRD> &p_shown);
	// Starts without slots, for the blades of a field with a map or not, with several species or not.
	void start(bool p_is_mapped, bool p_has_species);
	// Changes the number of slots. Their tiles go on where p_moves says. p_room: the memory for that many; null: it is made.
	void resize(int p_slots, std::span<const SlotMove> p_moves, PoolRoom *p_room);
	void free();
	int64_t get_slots() const { return _slots; } // that exist

	// Bind what a pass needs of each slot.
	void bind(GpuPass &r_pass) const;
	void bind_energy(GpuPass &r_pass) const { r_pass.bind_buffer(GRASS_BINDING_ENERGY, _energy.rid()); }
	void bind(KnotReader &r_reader) const { r_reader.bind(_knots.rid(), _halves.rid()); }
	// Sets how the blades of these slots grow. Returns the uploaded bytes.
	int64_t write_growth(std::span<const SlotGrowth> p_growth);
	const godot::RID &get_sampler() const { return _sampler; }
	godot::RID get_energy() const { return _energy.rid(); }
	uint32_t get_energy_bytes() const { return uint32_t(_used_rows * int64_t(sizeof(vec4))); } // in use

	// Must be called around a step of these slots.
	void begin_step(std::span<const GrassSlot> p_slots);
	void end_step(std::span<const GrassSlot> p_slots);
	void set_moved() { _has_moved = true; } // blades were posed without a step
	// Must be called at the beginning of a frame.
	void begin_frame();

	// Sets p_before, which receives a texture of where the last drawn frame showed the blades; null: nothing reads motion vectors.
	void set_motion(const godot::Ref<godot::Texture2DRD> &p_before);
	// Sets whether frames between two ticks show a mix of their steps; if so, mix() must be called.
	void set_between(bool p_is_between);
	// Mixes p_share of the last step with the rest of the one before. Must be called before begin_frame(). Returns whether it did anything.
	bool mix(float p_share);

	int64_t get_memory_usage() const; // bytes

private:
	PoolRoom::Kind kind() const { return { _has_growth, _has_species, _mix.is_created(), _before.is_valid() }; }
	void take(PoolRoom &r_room, std::span<const SlotMove> p_moves);
	void take_textures(PoolRoom &r_room, int p_kept, std::span<const SlotMove> p_moves);
	void keep_shown();
	void rest_before(std::span<const GrassSlot> p_slots);
	void free_unneeded_rows();

	bool _has_growth = false, _has_species = false;
	int64_t _slots = 0;
	int _used_rows = 0; // of the texture
	// Live as long as there are slots, read and written by simulate and join, all by slot: knots, now and one step earlier in two halves;
	// which half is which; twists of their joints or strains, and the blades' lengths; energy.
	GpuBuffer _knots, _halves, _twists, _energy;
	// By slot, written by the main thread when the map changes, read by simulate: how blades grow; of which species they are. Fields
	// without a map or with one species have none (16 bytes).
	GpuBuffer _growth, _blade_species;
	// By slot, written by simulate, read by the blade shader: offsets of the knots from rest.
	godot::RID _texture, _sampler;
	godot::Ref<godot::Texture2DRD> _shown;
	// A copy of the texture, which exists while motion vectors are read: written before the first step of a frame, read by the blade
	// shader.
	godot::RID _before_texture;
	godot::Ref<godot::Texture2DRD> _before; // null: nothing reads them
	// If physics is interpolated: written in each frame in which the share of the last step changes, read by the blade shader instead of
	// the texture.
	PoolMix _mix;
	RestingRows _resting_rows; // to copy into that copy and the mix; exist as long as one of them
	bool _has_kept = false; // since the last frame
	bool _has_moved = false; // whether blades have, since the copy was made
};

} // namespace grass

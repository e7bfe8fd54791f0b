// SPDX-License-Identifier: MIT
#include "gpu/gpu_pool.h"

#include "core/field/device_fit.h"

#include <godot_cpp/classes/rd_sampler_state.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

void GpuPool::create(const Ref<Texture2DRD> &p_shown) {
	_shown = p_shown;
	Ref<RDSamplerState> state;
	state.instantiate();
	_sampler = main_device()->sampler_create(state);
}

void GpuPool::start(bool p_is_mapped, bool p_has_species) {
	_has_growth = p_is_mapped || p_has_species;
	_has_species = p_has_species;
	if (!_has_species) {
		_blade_species.free();
	}
	_used_rows = 0;
	resize(0, {}, nullptr); // also if it was empty: what a slot has may differ
}

void GpuPool::resize(int p_slots, std::span<const SlotMove> p_moves, PoolRoom *p_room) {
	if (p_room != nullptr) {
		take(*p_room, p_moves);
	} else {
		PoolRoom room(p_slots, kind());
		take(room, p_moves);
	}
}

// Swaps the old memory for the new one, which begins as zeros: a replay must not depend on what a device left there.
void GpuPool::take(PoolRoom &r_room, std::span<const SlotMove> p_moves) {
	const int slots = r_room.get_slots(), kept = std::min(_used_rows, slots);
	r_room.clear();
	_slots = slots;
	_knots.swap_parts(r_room.knots, SLOT_BYTES, kept, p_moves);
	_halves.swap_parts(r_room.halves, int64_t(sizeof(uint32_t)), kept, p_moves);
	_twists.swap_parts(r_room.twists, PoolRoom::TWIST_BYTES, kept, p_moves);
	_energy.swap_parts(r_room.energy, int64_t(sizeof(vec4)), kept, p_moves);
	_growth.swap_parts(r_room.growth, _has_growth ? PoolRoom::GROWTH_BYTES : 0, kept, p_moves);
	if (_has_species) {
		_blade_species.swap_parts(r_room.blade_species, PoolRoom::SPECIES_BYTES, kept, p_moves);
	}
	take_textures(r_room, kept, p_moves);
	_used_rows = kept;
}

// Takes over textures. Each is shown before the old one is freed, since what shows it has a view of the old one.
void GpuPool::take_textures(PoolRoom &r_room, int p_kept, std::span<const SlotMove> p_moves) {
	const RID old = std::exchange(_texture, r_room.take_rows(Rows::NOW));
	move_rows(old, _texture, p_kept, p_moves);
	const auto show = [this] { _shown->set_texture_rd_rid(_mix.is_showing() ? _mix.get_shown() : _texture); };
	if (_mix.is_created()) {
		_mix.resize(_texture, _sampler, r_room, p_kept, p_moves, show);
	}
	show();
	if (old.is_valid()) {
		main_device()->free_rid(old);
	}
	if (_before_texture.is_valid()) {
		const RID old_before = std::exchange(_before_texture, r_room.take_rows(Rows::BEFORE));
		move_rows(old_before, _before_texture, p_kept, p_moves);
		replace_texture(_before, old_before, _before_texture);
	}
}

void GpuPool::free() {
	set_motion(Ref<Texture2DRD>());
	set_between(false);
	if (_shown.is_valid()) { // the texture resource first, since it has a view of what is freed next
		_shown->set_texture_rd_rid(RID());
		_shown.unref();
	}
	for (RID *rid : { &_texture, &_sampler }) {
		if (rid->is_valid()) {
			main_device()->free_rid(std::exchange(*rid, RID()));
		}
	}
	for (GpuBuffer *buffer : { &_knots, &_halves, &_twists, &_energy, &_growth, &_blade_species }) {
		buffer->free();
	}
}

void GpuPool::bind(GpuPass &r_pass) const {
	r_pass.bind_buffer(GRASS_BINDING_KNOTS, _knots.rid());
	r_pass.bind_buffer(GRASS_BINDING_HALVES, _halves.rid());
	r_pass.bind_buffer(GRASS_BINDING_TWISTS, _twists.rid());
	r_pass.bind_image(GRASS_BINDING_POOL_TEXTURE, _texture);
	r_pass.bind_buffer(GRASS_BINDING_GROWTH, _growth.rid());
	if (_has_species) {
		r_pass.bind_buffer(GRASS_BINDING_BLADE_SPECIES, _blade_species.rid());
	}
}

int64_t GpuPool::write_growth(std::span<const SlotGrowth> p_growth) {
	int64_t uploaded = 0;
	for (const SlotGrowth &growth : p_growth) {
		uploaded += _growth.write(growth.slot * int64_t(sizeof(growth.blades)), std::span<const vec4>(growth.blades));
		if (_has_species) {
			uploaded += _blade_species.write(growth.slot * int64_t(sizeof(growth.species)), std::span<const uint8_t>(growth.species));
		}
	}
	return uploaded;
}

void GpuPool::begin_step(std::span<const GrassSlot> p_slots) {
	if (!_has_kept) {
		keep_shown();
	}
	if (_mix.is_created()) {
		_mix.keep(_texture, _used_rows);
	}
	rest_before(p_slots);
}

void GpuPool::end_step(std::span<const GrassSlot> p_slots) {
	_has_kept = _has_moved = true;
	for (const GrassSlot &slot : p_slots) {
		_used_rows = std::max(_used_rows, slot.tile.w + 1);
	}
}

void GpuPool::begin_frame() {
	if (!std::exchange(_has_kept, false)) {
		keep_shown();
	}
}

// Keeps what the last frame showed, for the motion vectors of the next one.
void GpuPool::keep_shown() {
	if (_before.is_valid() && _has_moved && _used_rows > 0) {
		copy_rows(_mix.is_showing() ? _mix.get_shown() : _texture, _before_texture, 0, 0, _used_rows);
		_has_moved = false;
	}
}

// Tiles that wake in this step were at rest in the frame and in the step before. Their rows hold the blades of other tiles, or are
// undefined.
void GpuPool::rest_before(std::span<const GrassSlot> p_slots) {
	if (_before.is_valid()) {
		_resting_rows.copy_to(_before_texture, p_slots);
	}
	if (_mix.is_created()) {
		_resting_rows.copy_to(_mix.get_earlier(), p_slots);
	}
}

void GpuPool::free_unneeded_rows() {
	if (!_before.is_valid() && !_mix.is_created()) {
		_resting_rows.free();
	}
}

void GpuPool::set_motion(const Ref<Texture2DRD> &p_before) {
	if (_before.is_valid()) {
		replace_texture(_before, std::exchange(_before_texture, RID()), RID());
	}
	_before = p_before;
	if (_before.is_valid()) {
		_before_texture = make_rows(Rows::BEFORE, _slots);
		_before->set_texture_rd_rid(_before_texture);
		_has_moved = true;
	}
	free_unneeded_rows();
}

void GpuPool::set_between(bool p_is_between) {
	if (p_is_between == _mix.is_created()) {
		return;
	}
	if (p_is_between) {
		_mix.create(_texture, _sampler, _slots, _used_rows);
	} else {
		_shown->set_texture_rd_rid(_texture); // it has a view of the texture that is freed next
		_mix.free();
		free_unneeded_rows();
	}
	_has_moved = true;
}

bool GpuPool::mix(float p_share) {
	if (!std::exchange(_has_kept, true)) {
		keep_shown();
	}
	const bool was_showing = _mix.is_showing(), has_mixed = _mix.mix(p_share, _used_rows);
	if (_mix.is_showing() && !was_showing) {
		_shown->set_texture_rd_rid(_mix.get_shown());
	}
	_has_moved = _has_moved || has_mixed;
	return has_mixed;
}

int64_t GpuPool::get_memory_usage() const {
	int64_t bytes = POOL_ROW_BYTES * (_before.is_valid() ? 2 : 1) * _slots + _mix.get_memory_usage() + _resting_rows.get_memory_usage();
	for (const GpuBuffer *buffer : { &_knots, &_halves, &_twists, &_energy, &_growth, &_blade_species }) {
		bytes += buffer->size();
	}
	return bytes;
}

} // namespace grass

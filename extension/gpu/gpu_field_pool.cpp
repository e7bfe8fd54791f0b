// SPDX-License-Identifier: MIT
// GpuField's pool: as many slots as the field's awake tiles need, which become more and fewer while tiles are awake.
#include "core/base/cpu_clock.h"
#include "gpu/gpu_field.h"

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

// With as many slots as before, tiles have only come to rest.
void GpuField::resize_pool(int p_slots, std::span<const SlotMove> p_moves, PoolRoom *p_room) {
	for (const SlotMove &move : p_moves) {
		const int32_t entry = move.to == GRASS_NO_SLOT ? 0 : move.to + 1; // as simulate writes it
		_table.write(int64_t(move.tile) * 4, std::span(&entry, 1));
	}
	_table_changed = true;
	if (p_slots != _pool_size) {
		CpuClock clock;
		p_room != nullptr ? take_room(*p_room, p_moves) : make_pool(p_slots, p_moves);
		std::lock_guard lock(_report->mutex);
		_report->statistics.pool_makings++;
		_report->statistics.pool_ms = clock.lap();
	}
}

void GpuField::make_pool(int p_slots, std::span<const SlotMove> p_moves) {
	PoolRoom room(p_slots, { _is_mapped || _kind.species, _kind.species, _mix.is_created(), _before.is_valid() });
	take_room(room, p_moves);
}

// Swaps the old memory for the new one, which begins as zeros: a replay must not depend on what a device left there.
void GpuField::take_room(PoolRoom &r_room, std::span<const SlotMove> p_moves) {
	const int slots = r_room.get_slots(), kept = std::min(_used_rows, slots);
	r_room.clear();
	_pool_size = slots;
	_knots.swap_parts(r_room.knots, SLOT_BYTES, kept, p_moves);
	_halves.swap_parts(r_room.halves, int64_t(sizeof(uint32_t)), kept, p_moves);
	_twists.swap_parts(r_room.twists, PoolRoom::TWIST_BYTES, kept, p_moves);
	_energy.swap_parts(r_room.energy, int64_t(sizeof(vec4)), kept, p_moves);
	_growth.swap_parts(r_room.growth, _is_mapped || _kind.species ? PoolRoom::GROWTH_BYTES : 0, kept, p_moves);
	if (_kind.species) {
		_blade_species.swap_parts(r_room.blade_species, PoolRoom::SPECIES_BYTES, kept, p_moves);
	}
	take_textures(r_room, kept, p_moves);
	_used_rows = kept;
	if (slots == 0) {
		_work.reset();
	}
	bind_simulate();
	std::lock_guard lock(_report->mutex);
	report_memory();
}

// Each texture is shown before the old one is freed, since what shows it has a view of that.
void GpuField::take_textures(PoolRoom &r_room, int p_kept, std::span<const SlotMove> p_moves) {
	const RID old = std::exchange(_pool_texture, r_room.take_rows(Rows::NOW));
	move_rows(old, _pool_texture, p_kept, p_moves);
	const auto show = [this] { _pool->set_texture_rd_rid(_mix.is_showing() ? _mix.get_shown() : _pool_texture); };
	if (_mix.is_created()) {
		_mix.resize(_pool_texture, _sampler, r_room, p_kept, p_moves, show);
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

} // namespace grass

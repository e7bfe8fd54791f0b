// SPDX-License-Identifier: MIT
// How GpuField's pool becomes larger or smaller while tiles are awake.
#include "gpu/gpu_field.h"

#include <algorithm>

using namespace godot;

namespace grass {

void GpuField::resize_pool(int p_slots, std::span<const SlotMove> p_moves) {
	const int kept = std::min(_used_rows, p_slots);
	_pool_size = p_slots;
	const auto resize = [&](GpuBuffer &r_buffer, int64_t p_bytes) { r_buffer.resize_parts(p_bytes, p_slots, kept, p_moves); };
	resize(_knots, SLOT_BYTES);
	resize(_halves, 4);
	resize(_twists, TWIST_FLOATS_PER_SLOT * 4);
	resize(_energy, int64_t(sizeof(vec4)));
	if (_is_mapped || _kind.species) {
		resize(_growth, int64_t(sizeof(SlotGrowth::blades)));
	}
	if (_kind.species) {
		resize(_blade_species, int64_t(sizeof(SlotGrowth::species)));
	}
	const RID old = replace_pool_texture();
	copy_rows(old, _pool_texture, 0, 0, kept);
	for (const SlotMove &move : p_moves) {
		const int32_t entry = move.to == GRASS_NO_SLOT ? 0 : move.to + 1; // as simulate writes it
		_table.write(int64_t(move.tile) * 4, std::span(&entry, 1));
		copy_rows(old, _pool_texture, move.from, move.to, move.to == GRASS_NO_SLOT ? 0 : 1);
	}
	_table_changed = true;
	replace_texture(_pool, old, _pool_texture);
	_used_rows = kept;
	if (_mix.is_created()) {
		_mix.create(_pool_texture, _sampler, _pool_size);
		_mix.keep(_pool_texture, _used_rows);
	}
	make_before_texture();
	keep_pool();
	bind_simulate();
	std::lock_guard lock(_report->mutex);
	report_memory();
}

} // namespace grass

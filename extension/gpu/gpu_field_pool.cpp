// SPDX-License-Identifier: MIT
// GpuField's pool: as many slots as the field's awake tiles need, which become more and fewer while tiles are awake.
#include "core/base/cpu_clock.h"
#include "gpu/gpu_field.h"

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

// With as many slots as before, tiles have only come to rest.
void GpuField::resize_pool(int p_slots, std::span<const SlotMove> p_moves) {
	for (const SlotMove &move : p_moves) {
		const int32_t entry = move.to == GRASS_NO_SLOT ? 0 : move.to + 1; // as simulate writes it
		_table.write(int64_t(move.tile) * 4, std::span(&entry, 1));
	}
	_table_changed = true;
	if (p_slots != _pool_size) {
		CpuClock clock;
		make_pool(p_slots, p_moves);
		std::lock_guard lock(_report->mutex);
		_report->statistics.pool_makings++;
		_report->statistics.pool_ms = clock.lap();
	}
}

void GpuField::make_pool(int p_slots, std::span<const SlotMove> p_moves) {
	const int kept = std::min(_used_rows, p_slots);
	_pool_size = p_slots;
	const auto resize = [&](GpuBuffer &r_buffer, int64_t p_bytes) { r_buffer.resize_parts(p_bytes, p_slots, kept, p_moves); };
	resize(_knots, SLOT_BYTES);
	resize(_halves, 4);
	resize(_twists, TWIST_FLOATS_PER_SLOT * 4);
	resize(_energy, int64_t(sizeof(vec4)));
	resize(_growth, _is_mapped || _kind.species ? int64_t(sizeof(SlotGrowth::blades)) : 0);
	if (_kind.species) {
		resize(_blade_species, int64_t(sizeof(SlotGrowth::species)));
	}
	resize_textures(kept, p_moves);
	_used_rows = kept;
	if (p_slots == 0) {
		_work.reset();
	}
	bind_simulate();
	std::lock_guard lock(_report->mutex);
	report_memory();
}

// Each texture is shown before the old one is freed, since what shows it has a view of that.
void GpuField::resize_textures(int p_kept, std::span<const SlotMove> p_moves) {
	const TextureUsage usage = RenderingDevice::TEXTURE_USAGE_STORAGE_BIT | RenderingDevice::TEXTURE_USAGE_SAMPLING_BIT |
			RenderingDevice::TEXTURE_USAGE_CAN_COPY_FROM_BIT | RenderingDevice::TEXTURE_USAGE_CAN_COPY_TO_BIT;
	const RID old = std::exchange(_pool_texture, make_rows(_pool_size, usage));
	move_rows(old, _pool_texture, p_kept, p_moves);
	const auto show = [this] { _pool->set_texture_rd_rid(_mix.is_showing() ? _mix.get_shown() : _pool_texture); };
	if (_mix.is_created()) {
		_mix.resize(_pool_texture, _sampler, _pool_size, p_kept, p_moves, show);
	}
	show();
	if (old.is_valid()) {
		main_device()->free_rid(old);
	}
	if (_before_texture.is_valid()) {
		const RID old_before = std::exchange(_before_texture, make_before_rows());
		move_rows(old_before, _before_texture, p_kept, p_moves);
		replace_texture(_before, old_before, _before_texture);
	}
}

RID GpuField::make_before_rows() {
	return make_rows(_pool_size,
			RenderingDevice::TEXTURE_USAGE_SAMPLING_BIT | RenderingDevice::TEXTURE_USAGE_CAN_COPY_FROM_BIT |
					RenderingDevice::TEXTURE_USAGE_CAN_COPY_TO_BIT);
}

int64_t GpuField::find_pool_tile_bytes(bool p_is_between) {
	return (p_is_between ? 4 : 2) * POOL_ROW_BYTES + SLOT_BYTES + (TWIST_FLOATS_PER_SLOT + 1) * 4 +
			int64_t(sizeof(vec4) + sizeof(SlotGrowth::blades) + sizeof(SlotGrowth::species));
}

} // namespace grass

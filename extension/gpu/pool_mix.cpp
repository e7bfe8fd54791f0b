// SPDX-License-Identifier: MIT
#include "gpu/pool_mix.h"

#include "compute_shaders.gen.h"
#include "gpu/pool_rows.h"
#include "solver/mix.inc"

#include <utility>

using namespace godot;

namespace grass {

namespace {
const PassCode MIX = { shader::MIX_SPIRV, "GrassField mix", PassOrder::MIX, PassCode::NO_METHOD, GRASS_TILES_ONE, true };
} // namespace

void PoolMix::create(const RID &p_pool, const RID &p_sampler, int64_t p_slots, int p_rows) {
	free();
	_slots = p_slots;
	_earlier = make_rows(Rows::EARLIER, p_slots);
	_shown = make_rows(Rows::SHOWN, p_slots);
	_pass.create(MIX, GpuPass::Compile::LATER);
	bind(p_pool, p_sampler);
	keep(p_pool, p_rows);
}

void PoolMix::bind(const RID &p_pool, const RID &p_sampler) {
	_pass.bind_sampled(GRASS_MIX_EARLIER, p_sampler, _earlier);
	_pass.bind_sampled(GRASS_MIX_NOW, p_sampler, p_pool);
	_pass.bind_image(GRASS_MIX_SHOWN, _shown);
}

void PoolMix::resize(const RID &p_pool, const RID &p_sampler, PoolRoom &r_room, int p_kept, std::span<const SlotMove> p_moves,
		const std::function<void()> &p_show) {
	_slots = r_room.get_slots();
	const RID earlier = std::exchange(_earlier, r_room.take_rows(Rows::EARLIER));
	const RID shown = std::exchange(_shown, r_room.take_rows(Rows::SHOWN));
	move_rows(earlier, _earlier, p_kept, p_moves);
	move_rows(shown, _shown, p_kept, p_moves);
	bind(p_pool, p_sampler);
	p_show();
	main_device()->free_rid(earlier);
	main_device()->free_rid(shown);
}

void PoolMix::free() {
	_pass.free();
	for (RID *texture : { &_earlier, &_shown }) {
		if (texture->is_valid()) {
			main_device()->free_rid(std::exchange(*texture, RID()));
		}
	}
	_is_showing = false;
}

void PoolMix::keep(const RID &p_pool, int p_rows) {
	copy_rows(p_pool, _earlier, 0, 0, p_rows);
}

bool PoolMix::mix(float p_share, int p_rows) {
	if (!is_created() || !_pass.is_ready()) {
		return false;
	}
	_is_showing = true;
	if (p_rows > 0) {
		const vec4 share{ p_share, float(p_rows), 0.0f, 0.0f };
		RenderingDevice *device = main_device();
		const int64_t list = device->compute_list_begin();
		_pass.dispatch(list, share, uint32_t(int64_t(p_rows) * POOL_TEXTURE_WIDTH / GRASS_MIX_GROUP));
		device->compute_list_end();
	}
	return p_rows > 0;
}

int64_t PoolMix::get_memory_usage() const {
	return is_created() ? 2 * _slots * POOL_ROW_BYTES : 0;
}

} // namespace grass

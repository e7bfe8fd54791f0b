// SPDX-License-Identifier: MIT
#include "gpu/pool_rows.h"

#include <godot_cpp/classes/rd_texture_format.hpp>
#include <godot_cpp/classes/rd_texture_view.hpp>

#include <algorithm>
#include <utility>
#include <vector>

using namespace godot;

namespace grass {

namespace {
constexpr RenderingDevice::DataFormat POOL_FORMAT = RenderingDevice::DATA_FORMAT_R16G16B16A16_SFLOAT;
} // namespace

RID make_texture(RenderingDevice::DataFormat p_format, int64_t p_width, int64_t p_height, TextureUsage p_usage,
		const TypedArray<PackedByteArray> &p_data) {
	Ref<RDTextureFormat> format;
	format.instantiate();
	format->set_format(p_format);
	format->set_width(uint32_t(p_width));
	format->set_height(uint32_t(std::max<int64_t>(p_height, 1))); // a texture cannot be empty
	format->set_usage_bits(p_usage);
	Ref<RDTextureView> view;
	view.instantiate();
	return main_device()->texture_create(format, view, p_data);
}

RID make_rows(Rows p_rows, int64_t p_slots) {
	const int64_t read = RenderingDevice::TEXTURE_USAGE_SAMPLING_BIT | RenderingDevice::TEXTURE_USAGE_CAN_COPY_FROM_BIT |
			RenderingDevice::TEXTURE_USAGE_CAN_COPY_TO_BIT;
	const bool is_written = p_rows == Rows::NOW || p_rows == Rows::SHOWN; // by a pass
	const TextureUsage usage = is_written ? read | RenderingDevice::TEXTURE_USAGE_STORAGE_BIT : read;
	const int64_t width = p_slots > 0 ? POOL_TEXTURE_WIDTH : 1; // a card stores at least eight rows, also of a texture that nobody reads
	return make_texture(POOL_FORMAT, width, p_slots, usage);
}

void copy_rows(const RID &p_from, const RID &p_to, int p_from_row, int p_to_row, int p_rows) {
	if (p_rows > 0) {
		const Vector3 size(POOL_TEXTURE_WIDTH, real_t(p_rows), 1);
		main_device()->texture_copy(p_from, p_to, Vector3(0, real_t(p_from_row), 0), Vector3(0, real_t(p_to_row), 0), size, 0, 0, 0, 0);
	}
}

void move_rows(const RID &p_from, const RID &p_to, int p_kept, std::span<const SlotMove> p_moves) {
	copy_rows(p_from, p_to, 0, 0, p_kept);
	for (const SlotMove &move : p_moves) {
		copy_rows(p_from, p_to, move.from, move.to, move.to == GRASS_NO_SLOT ? 0 : 1);
	}
}

void replace_texture(const Ref<Texture2DRD> &p_shown, const RID &p_old, const RID &p_new) {
	p_shown->set_texture_rd_rid(p_new); // it has a view of the texture that is freed next
	if (p_old.is_valid()) {
		main_device()->free_rid(p_old);
	}
}

void RestingRows::copy_to(const RID &p_to, std::span<const GrassSlot> p_slots) {
	std::vector<int> rows;
	for (const GrassSlot &slot : p_slots) {
		if ((slot.list.w & GRASS_SLOT_FRESH) != 0) {
			rows.push_back(slot.tile.w);
		}
	}
	if (!rows.empty() && !_rows.is_valid()) {
		PackedByteArray zeros;
		zeros.resize(COUNT * POOL_ROW_BYTES);
		zeros.fill(0);
		_rows = make_texture(POOL_FORMAT, POOL_TEXTURE_WIDTH, COUNT, RenderingDevice::TEXTURE_USAGE_CAN_COPY_FROM_BIT, Array::make(zeros));
	}
	std::ranges::sort(rows);
	for (size_t first = 0, next = 0; first < rows.size(); first = next) { // consecutive rows, with a single copy
		while (next < rows.size() && rows[next] - rows[first] == int(next - first) && int(next - first) < COUNT) {
			next++;
		}
		copy_rows(_rows, p_to, 0, rows[first], int(next - first));
	}
}

void RestingRows::free() {
	if (_rows.is_valid()) {
		main_device()->free_rid(std::exchange(_rows, RID()));
	}
}

} // namespace grass

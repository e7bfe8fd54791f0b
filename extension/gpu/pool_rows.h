// SPDX-License-Identifier: MIT
// Textures on the device, and those with a row for each slot of the pool: RGBA16F, the offset of each knot of its blades from rest.
// Everything here must be called on the render thread.
#pragma once

#include "core/solver/step.h"
#include "gpu/device.h"

#include <godot_cpp/classes/texture2drd.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace grass {

inline constexpr int POOL_TEXTURE_WIDTH = GRASS_KNOTS * GRASS_POOL_BLADES_PER_ROW;
inline constexpr int64_t POOL_ROW_BYTES = POOL_TEXTURE_WIDTH * 8;

using TextureUsage = godot::BitField<godot::RenderingDevice::TextureUsageBits>;

// Makes a texture. p_data: the texels; if empty, the contents are undefined.
godot::RID make_texture(godot::RenderingDevice::DataFormat p_format, int64_t p_width, int64_t p_height, TextureUsage p_usage,
		const godot::TypedArray<godot::PackedByteArray> &p_data = {});
// The textures that have a row for each slot: of the last step; as the last frame showed it; of the step before; the mix of both steps.
enum class Rows { NOW, BEFORE, EARLIER, SHOWN };
inline constexpr int ALL_ROWS = 4;
// Makes such a texture, whose contents are undefined; on any thread.
godot::RID make_rows(Rows p_rows, int64_t p_slots);
void copy_rows(const godot::RID &p_from, const godot::RID &p_to, int p_from_row, int p_to_row, int p_rows);
// Copies rows into those that replace them: the first p_kept, and others as p_moves says.
void move_rows(const godot::RID &p_from, const godot::RID &p_to, int p_kept, std::span<const SlotMove> p_moves);
// Shows p_new instead of p_old, and frees p_old.
void replace_texture(const godot::Ref<godot::Texture2DRD> &p_shown, const godot::RID &p_old, const godot::RID &p_new);

// A few rows of blades at rest, for the slots of tiles that wake, since these still have the blades of other tiles.
class RestingRows {
public:
	static constexpr int COUNT = 16;

	// Copies rows at rest into p_to for the fresh slots among p_slots.
	void copy_to(const godot::RID &p_to, std::span<const GrassSlot> p_slots);
	void free();
	int64_t get_memory_usage() const { return _rows.is_valid() ? COUNT * POOL_ROW_BYTES : 0; }

private:
	godot::RID _rows;
};

} // namespace grass

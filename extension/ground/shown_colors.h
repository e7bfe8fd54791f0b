// SPDX-License-Identifier: MIT
// Shows the colours that a terrain reports as a texture over the field.
#pragma once

#include "core/fill/terrain_piece.h"

#include <godot_cpp/classes/image_texture.hpp>

#include <optional>

namespace grass {

class ShownColors {
public:
	// Starts with no colours, for a terrain that reports some. p_area: of the field.
	void start(const MapRegion &p_area);
	void stop();
	// Covers another area, where no colours are known. The texture shows the old ones until the next show().
	void move(const MapRegion &p_area);
	// Forgets all colours, in the same way.
	void clear();
	void put(const TerrainPiece &p_piece);
	// Updates the texture. p_is_read: nothing waits to be read.
	void show(bool p_is_read);

	const godot::Ref<godot::ImageTexture> &get_texture() const { return _texture; } // null: the terrain reports no colours
	int64_t get_memory_usage() const { return _colors ? 2 * int64_t(_colors->get_memory_usage()) : 0; } // bytes: here and as a texture

private:
	std::optional<TerrainColors> _colors;
	godot::Ref<godot::ImageTexture> _texture;
	bool _is_of_elsewhere = false; // the texture
};

} // namespace grass

// SPDX-License-Identifier: MIT
#include "ground/shown_colors.h"

#include "core/fill/terrain_picture.h"
#include "draw/frame_share.h"
#include "shared/convert.h"

#include <godot_cpp/classes/image.hpp>

using namespace godot;

namespace grass {

void ShownColors::start(const MapRegion &p_area) {
	_colors.emplace();
	_colors->set_area(p_area);
}

void ShownColors::stop() {
	_colors.reset();
	_texture.unref();
}

void ShownColors::move(const MapRegion &p_area) {
	if (_colors) {
		_colors->set_area(p_area);
		_is_of_elsewhere = true;
	}
}

void ShownColors::clear() {
	if (_colors) {
		_colors->clear();
		_is_of_elsewhere = true;
	}
}

void ShownColors::put(const TerrainPiece &p_piece) {
	if (_colors) {
		p_piece.put_colors(*_colors);
	}
}

// Waits until everything is read, since a picture has mipmaps, which change as a whole.
void ShownColors::show(bool p_is_read) {
	if (!_colors || (_texture.is_valid() && !p_is_read && !_is_of_elsewhere) || !_colors->take_changed()) {
		return;
	}
	_is_of_elsewhere = false;
	const std::vector<TerrainColor> texels = picture_of(*_colors);
	const PackedByteArray bytes = to_bytes(std::span(texels));
	const Ref<Image> image = Image::create_from_data(_colors->get_width(), _colors->get_depth(), false, Image::FORMAT_RGBA8, bytes);
	image->generate_mipmaps();
	FrameShare::count_bytes(bytes.size());
	if (_texture.is_valid() && _texture->get_width() == _colors->get_width() && _texture->get_height() == _colors->get_depth()) {
		_texture->update(image);
	} else {
		_texture = ImageTexture::create_from_image(image);
	}
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "draw/map_textures.h"

#include "shared/convert.h"

#include <godot_cpp/classes/image.hpp>

using namespace godot;

namespace grass {

namespace {

Ref<Image> make_image(int p_side, Image::Format p_format, PackedByteArray p_bytes) {
	if (p_bytes.is_empty()) {
		p_bytes.resize(int64_t(p_side) * p_side * (p_format == Image::FORMAT_R8 ? 1 : 4));
	}
	return Image::create_from_data(p_side, p_side, false, p_format, p_bytes);
}

template <typename T> PackedByteArray texel_bytes(const std::vector<T> &p_texels) {
	return to_bytes(std::span<const T>(p_texels));
}

} // namespace

// Returns the image of a layer. p_layer -1: an empty layer for later use.
Ref<Image> MapTextures::image_of(const MapLayers &p_layers, int p_kind, int p_layer) {
	static const MapLayer none;
	const MapLayer &layer = p_layer < 0 ? none : p_layers.get_layer(p_layer);
	switch (p_kind) {
		case GROWTH:
			return make_image(MapLayer::FINE, Image::FORMAT_RGBA8, texel_bytes(layer.growth));
		case FORM:
			return make_image(MapLayer::COARSE, Image::FORMAT_RGBA8, texel_bytes(layer.form));
		case GROUND:
			return make_image(MapLayer::COARSE, Image::FORMAT_RF, texel_bytes(layer.ground));
		case TINT:
			return make_image(MapLayer::COARSE, Image::FORMAT_RGBA8, texel_bytes(layer.tint));
		default:
			return make_image(MapLayer::COARSE, Image::FORMAT_R8, texel_bytes(layer.species));
	}
}

GrowingArrays::MakeImage MapTextures::of_layers(const MapLayers &p_layers) {
	return [&p_layers](int p_kind, int p_layer) { return image_of(p_layers, p_kind, p_layer); };
}

// Returns what makes the images of ledges. Few chunks have ledges, but these take four times the memory of all other channels together, so
// they have layers of their own.
GrowingArrays::MakeImage MapTextures::of_ledges(const MapLayers &p_layers) {
	return [&p_layers](int, int p_page) {
		const std::vector<uint8_t> none;
		const std::vector<uint8_t> &codes = p_page < 0 ? none : p_layers.get_layer(p_layers.get_ledge_layers()[size_t(p_page)]).ledge;
		return make_image(GRASS_LEDGE_TEXELS, Image::FORMAT_R8, texel_bytes(codes));
	};
}

void MapTextures::make_room(const MapLayers &p_layers, int p_room, bool p_at_once) {
	_arrays.want_room(std::max(p_room, p_layers.get_count()), p_layers.get_count(), p_at_once, of_layers(p_layers));
	if (const int ledges = int(p_layers.get_ledge_layers().size()); ledges > 0) {
		_ledges.want_room(ledges, ledges, p_at_once, of_ledges(p_layers));
	}
}

void MapTextures::make(const MapLayers &p_layers, int p_room) {
	make_room(p_layers, p_room, true);
	update_pages(p_layers);
}

void MapTextures::update(const MapLayers &p_layers, const std::vector<int> &p_changed, int p_room) {
	const int had_room = _arrays.get_room(), had_ledges = _ledges.get_room();
	make_room(p_layers, p_room, false);
	const std::vector<int> &ledges = p_layers.get_ledge_layers();
	for (const int layer : p_changed) {
		if (_arrays.get_room() == had_room) { // otherwise made from these very layers
			_arrays.change(layer, of_layers(p_layers));
		}
		const auto found = std::find(ledges.begin(), ledges.end(), layer);
		if (found != ledges.end() && _ledges.get_room() == had_ledges) {
			_ledges.change(int(found - ledges.begin()), of_ledges(p_layers));
		}
	}
	update_pages(p_layers);
}

void MapTextures::work(const MapLayers &p_layers) {
	const int had_room = _arrays.get_room(), had_ledges = _ledges.get_room();
	if (_arrays.can_work()) {
		_arrays.work(p_layers.get_count(), of_layers(p_layers));
	} else {
		_ledges.work(int(p_layers.get_ledge_layers().size()), of_ledges(p_layers));
	}
	if (_arrays.get_room() != had_room || _ledges.get_room() != had_ledges) {
		make_room(p_layers, 0, false); // more layers may have been added meanwhile
		update_pages(p_layers);
	}
}

void MapTextures::update_pages(const MapLayers &p_layers) {
	const std::vector<int> &ledges = p_layers.get_ledge_layers();
	std::vector<float> pages;
	for (const float layer : p_layers.get_pages()) {
		const auto found = std::find(ledges.begin(), ledges.end(), int(layer));
		const auto page = found - ledges.begin();
		pages.push_back(int(layer) < _arrays.get_room() ? layer : float(GRASS_NO_LAYER));
		pages.push_back(found == ledges.end() || page >= _ledges.get_room() ? float(GRASS_NO_LAYER) : float(page));
	}
	_are_new = _arrays.take_new() || _are_new;
	_are_new = _ledges.take_new() || _are_new;
	if (_pages.is_null() || _uploaded_pages != pages) {
		_uploaded_pages = std::move(pages);
		const PackedByteArray bytes = to_bytes(std::span<const float>(_uploaded_pages));
		_pages = ImageTexture::create_from_image(
				Image::create_from_data(p_layers.get_width(), p_layers.get_depth(), false, Image::FORMAT_RGF, bytes));
		_uploaded += bytes.size();
		_are_new = true;
	}
}

MapBinding MapTextures::bind(const MapLayers &p_layers) {
	_are_new = false;
	return { _arrays.get(GROWTH), _arrays.get(FORM), _arrays.get(GROUND), _arrays.get(TINT),
		_arrays.get_count() > SPECIES ? _arrays.get(SPECIES) : Ref<Texture2DArray>(), _ledges.get(0), _pages,
		Vector2(p_layers.get_first().x, p_layers.get_first().z) };
}

void MapBinding::set_uniforms(const SetUniform &p_set) const {
	p_set("map_growth", growth);
	p_set("map_form", form);
	p_set("map_ground", ground);
	p_set("map_tint", tint);
	p_set("map_species", species);
	p_set("map_ledges", ledges);
	p_set("map_pages", pages);
	p_set("map_origin", origin);
}

int64_t MapTextures::get_memory_usage() const {
	constexpr int64_t LAYER = 4 * (int64_t(MapLayer::FINE) * MapLayer::FINE + 3 * int64_t(MapLayer::COARSE) * MapLayer::COARSE);
	constexpr int64_t SPECIES_LAYER = int64_t(MapLayer::COARSE) * MapLayer::COARSE;
	return _arrays.get_room() * (LAYER + (_arrays.get_count() == KINDS ? SPECIES_LAYER : 0)) + int64_t(_uploaded_pages.size()) * 4 +
			int64_t(_ledges.get_room()) * GRASS_LEDGE_TEXELS * GRASS_LEDGE_TEXELS;
}

} // namespace grass

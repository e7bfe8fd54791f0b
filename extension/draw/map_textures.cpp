// SPDX-License-Identifier: MIT
#include "draw/map_textures.h"

#include "shared/convert.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <bit>

using namespace godot;

namespace grass {

namespace {

constexpr const char *NAMES[] = { "map_growth", "map_form", "map_ground", "map_tint", "map_species" };
constexpr int FIRST_ROOM = 4; // layers

Ref<Image> make_image(int p_side, Image::Format p_format, PackedByteArray p_bytes) {
	if (p_bytes.is_empty()) {
		p_bytes.resize(int64_t(p_side) * p_side * (p_format == Image::FORMAT_R8 ? 1 : 4));
	}
	return Image::create_from_data(p_side, p_side, false, p_format, p_bytes);
}

} // namespace

// p_layer null: room for a layer to come.
Ref<Image> MapTextures::image_of(const MapLayer *p_layer, Kind p_kind) const {
	const int side = p_kind == GROWTH ? MapLayer::FINE : MapLayer::COARSE;
	if (p_kind == GROUND) {
		return make_image(side, Image::FORMAT_RF, p_layer ? to_bytes(std::span<const float>(p_layer->ground)) : PackedByteArray());
	}
	if (p_kind == SPECIES) {
		return make_image(side, Image::FORMAT_R8, p_layer ? to_bytes(std::span<const uint8_t>(p_layer->species)) : PackedByteArray());
	}
	PackedByteArray bytes;
	if (p_layer) {
		bytes = to_bytes(std::span<const uint8_t>(p_kind == GROWTH ? p_layer->growth : (p_kind == FORM ? p_layer->form : p_layer->tint)));
	}
	return make_image(side, Image::FORMAT_RGBA8, bytes);
}

void MapTextures::make(const MapLayers &p_layers, Kind p_kind) {
	const Ref<Image> empty = image_of(nullptr, p_kind);
	TypedArray<Ref<Image>> images;
	for (int layer = 0; layer < _room; layer++) {
		images.push_back(layer < p_layers.get_count() ? image_of(&p_layers.get_layer(layer), p_kind) : empty);
		_uploaded += empty->get_data_size();
	}
	_arrays[size_t(p_kind)].instantiate();
	_arrays[size_t(p_kind)]->create_from_images(images);
	_are_new = true;
}

bool MapTextures::make_one(const MapLayers &p_layers, int p_room) {
	make_room(p_room);
	for (int kind = 0; kind < _kinds; kind++) {
		if (_arrays[size_t(kind)].is_null()) {
			make(p_layers, Kind(kind));
			return true;
		}
	}
	return false;
}

bool MapTextures::are_made(int p_room) const {
	return _room >= p_room && _room > 0 &&
			std::all_of(_arrays.begin(), _arrays.begin() + _kinds, [](const auto &p_array) { return p_array.is_valid(); });
}

void MapTextures::make_room(int p_layers) {
	if (_room == 0 || p_layers > _room) {
		_arrays = {};
		_room = std::max(FIRST_ROOM, std::min(int(std::bit_ceil(unsigned(p_layers))), GRASS_MAX_LAYERS));
	}
}

void MapTextures::update(const MapLayers &p_layers, const std::vector<int> &p_changed) {
	make_room(p_layers.get_count());
	for (int kind = 0; kind < _kinds; kind++) {
		if (_arrays[size_t(kind)].is_null()) {
			make(p_layers, Kind(kind));
			continue;
		}
		for (const int layer : p_changed) {
			const Ref<Image> image = image_of(&p_layers.get_layer(layer), Kind(kind));
			_arrays[size_t(kind)]->update_layer(image, layer);
			_uploaded += image->get_data_size();
		}
	}
	update_ledges(p_layers, p_changed);
	update_pages(p_layers);
}

// Few chunks have ledges, and those that have take four times as much as all else.
void MapTextures::update_ledges(const MapLayers &p_layers, const std::vector<int> &p_changed) {
	const std::vector<int> &layers = p_layers.get_ledge_layers();
	const auto image_of_ledges = [&](size_t p_page) {
		const std::vector<uint8_t> &codes = p_layers.get_layer(layers[std::min(p_page, layers.size() - 1)]).ledge;
		_uploaded += int64_t(codes.size());
		return Image::create_from_data(
				GRASS_LEDGE_TEXELS, GRASS_LEDGE_TEXELS, false, Image::FORMAT_R8, to_bytes(std::span<const uint8_t>(codes)));
	};
	if (int(layers.size()) > _ledge_room) {
		_ledge_room = int(std::bit_ceil(layers.size()));
		TypedArray<Ref<Image>> images;
		for (size_t page = 0; page < size_t(_ledge_room); page++) {
			images.push_back(image_of_ledges(page));
		}
		_ledges.instantiate();
		_ledges->create_from_images(images);
		_are_new = true;
		return;
	}
	for (size_t page = 0; page < layers.size(); page++) {
		if (std::find(p_changed.begin(), p_changed.end(), layers[page]) != p_changed.end()) {
			_ledges->update_layer(image_of_ledges(page), int32_t(page));
		}
	}
}

void MapTextures::update_pages(const MapLayers &p_layers) {
	const std::vector<int> &ledges = p_layers.get_ledge_layers();
	std::vector<float> pages;
	for (const float layer : p_layers.get_pages()) {
		const auto found = std::find(ledges.begin(), ledges.end(), int(layer));
		pages.push_back(layer);
		pages.push_back(found == ledges.end() ? float(GRASS_NO_LAYER) : float(found - ledges.begin()));
	}
	if (_pages.is_null() || _uploaded_pages != pages) {
		_uploaded_pages = std::move(pages);
		const PackedByteArray bytes = to_bytes(std::span<const float>(_uploaded_pages));
		_pages = ImageTexture::create_from_image(
				Image::create_from_data(p_layers.get_width(), p_layers.get_depth(), false, Image::FORMAT_RGF, bytes));
		_uploaded += bytes.size();
		_are_new = true;
	}
}

void MapTextures::set_uniforms(const MapLayers &p_layers, const SetUniform &p_set) {
	for (int kind = 0; kind < _kinds; kind++) {
		p_set(NAMES[kind], _arrays[size_t(kind)]);
	}
	p_set("map_pages", _pages);
	p_set("map_ledges", _ledges);
	p_set("map_origin", Vector2(p_layers.get_first().x, p_layers.get_first().z));
	_are_new = false;
}

void MapTextures::clear_uniforms(const SetUniform &p_set) {
	for (const char *name : NAMES) {
		p_set(name, Variant());
	}
	p_set("map_pages", Variant());
	p_set("map_ledges", Variant());
}

int64_t MapTextures::get_memory_usage() const {
	constexpr int64_t LAYER = 4 * (int64_t(MapLayer::FINE) * MapLayer::FINE + 3 * int64_t(MapLayer::COARSE) * MapLayer::COARSE);
	constexpr int64_t SPECIES_LAYER = int64_t(MapLayer::COARSE) * MapLayer::COARSE;
	return _room * (LAYER + (_kinds == KINDS ? SPECIES_LAYER : 0)) + int64_t(_uploaded_pages.size()) * 4 +
			int64_t(_ledge_room) * GRASS_LEDGE_TEXELS * GRASS_LEDGE_TEXELS;
}

} // namespace grass

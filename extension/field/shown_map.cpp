// SPDX-License-Identifier: MIT
#include "field/shown_map.h"

#include "core/field/field_setup.h"
#include "draw/frame_share.h"

using namespace godot;

namespace grass {

ShownPlace shown_place_of(const FieldSetup &p_setup) {
	return { { p_setup.grid, double(p_setup.blade_length()), p_setup.follow_slope }, p_setup.species != nullptr };
}

PreparedMap::PreparedMap(const PaintMap &p_map, const ShownPlace &p_place, bool p_with_textures) :
		laid(p_map, p_place.map), textures(p_place.has_species), has_species(p_place.has_species) {
	if (!p_with_textures) {
		return;
	}
	textures.make(laid.field.get_layers(), laid.field.count_painted(laid.map));
}

namespace {

// What another thread prepared, or all of it to be laid out still.
std::pair<FieldMap, MapTextures> begin(const PaintMap &p_map, const ShownPlace &p_place, std::unique_ptr<PreparedMap> p_prepared) {
	if (p_prepared && p_prepared->has_species == p_place.has_species) {
		if (std::optional<FieldMap> field = std::move(p_prepared->laid).take(p_map, p_place.map)) {
			return { std::move(*field), std::move(p_prepared->textures) };
		}
	}
	return { FieldMap(p_place.map.grid, p_place.map.tallest, p_place.map.follow), MapTextures(p_place.has_species) };
}

} // namespace

ShownMap::ShownMap(const Ref<GrassMap> &p_map, const FieldSetup &p_setup, std::unique_ptr<PreparedMap> p_prepared) :
		ShownMap(p_map, begin(p_map->get_map(), shown_place_of(p_setup), std::move(p_prepared))) {}

ShownMap::ShownMap(const Ref<GrassMap> &p_map, std::pair<FieldMap, MapTextures> &&p_begun) :
		_map(p_map), _field(std::move(p_begun.first)), _textures(std::move(p_begun.second)) {
	_map->show(this, _field.get_region().grown(MapLayers::CHANGE_MARGIN)); // what lies a little beyond blends into the border
}

void ShownMap::preview(const std::function<BrushResult(PaintMap &)> &p_change) {
	end_preview();
	_preview = std::make_unique<PaintMap>(_map->get_map()); // shares all texels but those that change
	const BrushResult result = p_change(*_preview);
	if (result.changed.empty()) {
		_preview.reset();
		return;
	}
	_previewed = { result.min, result.max };
	touch(_previewed);
}

bool ShownMap::end_preview() {
	if (!_preview) {
		return false;
	}
	_preview.reset();
	touch(_previewed);
	return true;
}

FieldMap::Changes ShownMap::update(const std::function<bool()> &p_go_on) {
	FieldMap::Changes changes;
	const bool was_growing = is_growing();
	while (get_waiting() > 0 && p_go_on()) {
		changes.add(_field.work(shown()));
	}
	const int64_t before = _textures.get_uploaded_bytes();
	_textures.update(_field.get_layers(), changes.layers, 0);
	while (was_growing && _textures.can_work() && p_go_on()) {
		_textures.work(_field.get_layers());
	}
	FrameShare::count_bytes(_textures.get_uploaded_bytes() - before);
	return changes;
}

void ShownMap::work() {
	const int64_t before = _textures.get_uploaded_bytes();
	if (_textures.can_work()) {
		_textures.work(_field.get_layers());
	} else {
		_textures.update(_field.get_layers(), _field.work(shown()).layers, _field.count_painted(shown()));
	}
	FrameShare::count_bytes(_textures.get_uploaded_bytes() - before);
}

void ShownMap::set_uniforms(const MapTextures::SetUniform &p_set, bool p_all) {
	if (p_all || has_new_textures()) {
		_textures.set_uniforms(_field.get_layers(), p_set);
	}
	p_set("map_base_density", _map->get_base_density());
}

} // namespace grass

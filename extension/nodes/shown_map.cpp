// SPDX-License-Identifier: MIT
#include "nodes/shown_map.h"

#include "core/field/field_setup.h"

using namespace godot;

namespace grass {

ShownMap::ShownMap(const Ref<GrassMap> &p_map, const FieldSetup &p_setup) :
		_map(p_map), _field(p_setup.grid, p_setup.blade_length(), p_setup.follow_slope), _textures(p_setup.species != nullptr) {}

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
	while (get_waiting() > 0 && p_go_on()) {
		changes.add(_field.work(shown()));
	}
	_textures.update(_field.get_layers(), changes.layers);
	return changes;
}

bool ShownMap::work() {
	if (_textures.make_one(_field.get_layers(), _field.count_painted(shown()))) {
		return true;
	}
	if (get_waiting() == 0) {
		return false;
	}
	_textures.update(_field.get_layers(), _field.work(shown()).layers);
	return true;
}

void ShownMap::set_uniforms(const MapTextures::SetUniform &p_set) {
	if (_textures.are_new()) {
		_textures.set_uniforms(_field.get_layers(), p_set);
	}
	p_set("map_base_density", _map->get_base_density());
}

} // namespace grass

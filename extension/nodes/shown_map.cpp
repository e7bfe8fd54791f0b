// SPDX-License-Identifier: MIT
#include "nodes/shown_map.h"

#include "core/field/field_setup.h"

using namespace godot;

namespace grass {

ShownMap::ShownMap(const Ref<GrassMap> &p_map, const FieldSetup &p_setup) :
		_map(p_map), _field(p_setup.grid, p_setup.blade_length(), p_setup.follow_slope), _textures(p_setup.species != nullptr) {}

FieldMap::Changes ShownMap::update(const std::function<bool()> &p_go_on) {
	FieldMap::Changes changes;
	while (get_waiting() > 0 && p_go_on()) {
		changes.add(_field.work(_map->get_map()));
	}
	_textures.update(_field.get_layers(), changes.layers);
	return changes;
}

bool ShownMap::work() {
	if (_textures.make_one(_field.get_layers(), _field.count_painted(_map->get_map()))) {
		return true;
	}
	if (get_waiting() == 0) {
		return false;
	}
	_textures.update(_field.get_layers(), _field.work(_map->get_map()).layers);
	return true;
}

void ShownMap::set_uniforms(const MapTextures::SetUniform &p_set) {
	if (_textures.are_new()) {
		_textures.set_uniforms(_field.get_layers(), p_set);
	}
	p_set("map_base_density", _map->get_base_density());
}

} // namespace grass

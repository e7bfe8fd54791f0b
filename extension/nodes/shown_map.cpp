// SPDX-License-Identifier: MIT
#include "nodes/shown_map.h"

#include "core/field/field_setup.h"

using namespace godot;

namespace grass {

namespace {

FieldMap begin(const GrassMap &p_map, const MapPlace &p_place, std::unique_ptr<LaidMap> p_laid) {
	std::optional<FieldMap> laid = p_laid ? std::move(*p_laid).take(p_map.get_map(), p_place) : std::nullopt;
	return laid ? std::move(*laid) : FieldMap(p_place.grid, p_place.tallest, p_place.follow);
}

} // namespace

MapPlace map_place_of(const FieldSetup &p_setup) {
	return { p_setup.grid, double(p_setup.blade_length()), p_setup.follow_slope };
}

ShownMap::ShownMap(const Ref<GrassMap> &p_map, const FieldSetup &p_setup, std::unique_ptr<LaidMap> p_laid) :
		_map(p_map), _field(begin(**p_map, map_place_of(p_setup), std::move(p_laid))), _textures(p_setup.species != nullptr) {}

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

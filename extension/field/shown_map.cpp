// SPDX-License-Identifier: MIT
#include "field/shown_map.h"

#include "draw/frame_share.h"

#include <utility>

using namespace godot;

namespace grass {

void ShownMap::prepare(const PaintMap &p_map, bool p_with_textures) {
	_prepared = p_map;
	_layers.update(p_map, _layers.get_region());
	if (p_with_textures) {
		_textures.make(_layers, _layers.count_painted(p_map));
	}
}

std::unique_ptr<ShownMap> ShownMap::make(const Ref<GrassMap> &p_map, const MapPlace &p_place, std::unique_ptr<ShownMap> p_prepared) {
	const bool fits = p_prepared && p_prepared->_layers.get_place() == p_place;
	std::unique_ptr<ShownMap> shown = fits ? std::move(p_prepared) : std::make_unique<ShownMap>(p_place);
	shown->show(p_map);
	return shown;
}

void ShownMap::show(const Ref<GrassMap> &p_map) {
	_map = p_map;
	if (_prepared) {
		_layers.touch(*_prepared, _map->get_map());
		_prepared.reset();
	}
	_map->show(this, _layers.get_region().grown(MapLayers::CHANGE_MARGIN)); // what lies a little beyond blends into the border
}

ShownMap::~ShownMap() {
	if (_map.is_valid()) {
		_map->hide(this);
	}
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

MapLayers::Changes ShownMap::update(const std::function<bool()> &p_go_on) {
	MapLayers::Changes changes;
	const bool was_growing = is_growing();
	while (get_waiting() > 0 && p_go_on()) {
		changes.add(_layers.work(shown()));
	}
	const int64_t before = _textures.get_uploaded_bytes();
	_textures.update(_layers, changes.layers, 0);
	while (was_growing && _textures.can_work() && p_go_on()) {
		_textures.work(_layers);
	}
	FrameShare::count_bytes(_textures.get_uploaded_bytes() - before);
	return changes;
}

void ShownMap::work() {
	const int64_t before = _textures.get_uploaded_bytes();
	if (_textures.can_work()) {
		_textures.work(_layers);
	} else {
		_textures.update(_layers, _layers.work(shown()).layers, _layers.count_painted(shown()));
	}
	FrameShare::count_bytes(_textures.get_uploaded_bytes() - before);
}

} // namespace grass

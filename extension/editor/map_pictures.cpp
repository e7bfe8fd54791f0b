// SPDX-License-Identifier: MIT
#include "editor/map_pictures.h"

#include "shared/convert.h"

#include <godot_cpp/classes/file_access.hpp>

using namespace godot;

namespace grass {

namespace {

// Returns the field's rectangle in its own map.
Rect2 area_of(const GrassField &p_field) {
	return { p_field.get_parts().settings.get_size() * -0.5f, p_field.get_parts().settings.get_size() };
}

// Returns a region of the fields' parent in the map of p_field.
Rect2 to_map_of(const GrassField &p_field, const MapRegion &p_region) {
	const Vector3 centre = p_field.get_position();
	return { to_godot(p_region.min) - Vector2(centre.x, centre.z), to_godot(Eigen::Vector2d(p_region.max - p_region.min)) };
}

// Returns the field's rectangle in its parent.
MapRegion in_parent(const GrassField &p_field) {
	const Eigen::Vector3d centre = to_eigen(p_field.get_position());
	const Eigen::Vector2d place(centre.x(), centre.z()), half = 0.5 * to_eigen(p_field.get_parts().settings.get_size());
	return { place - half, place + half };
}

} // namespace

String MapPictures::path_of(const GrassField &p_field) const {
	if (_world == nullptr) {
		return _path;
	}
	const Vector2i plot = _world->get_plot_at(p_field.get_global_position());
	return vformat("%s_%d_%d.%s", _path.get_basename(), plot.x, plot.y, _path.get_extension());
}

bool MapPictures::note(const GrassField &p_field, const PictureProblem &p_problem) {
	if (p_problem.error == OK) {
		_fields.push_back(&p_field);
	} else if (_problem.is_empty()) {
		_problem = vformat("'%s': %s", path_of(p_field), p_problem.text);
	}
	return p_problem.error == OK;
}

void MapPictures::write(const GrassField &p_field) {
	const Ref<GrassMap> map = p_field.get_map();
	note(p_field,
			map.is_valid() ? write_picture(**map, _channel, path_of(p_field), area_of(p_field))
						   : PictureProblem{ ERR_DOES_NOT_EXIST, "the field has no map yet. Paint it first." });
}

bool MapPictures::read(GrassField &r_field) {
	const String path = path_of(r_field);
	if (_world != nullptr && !FileAccess::file_exists(path)) { // a plot that has no picture stays as it is
		return false;
	}
	if (!note(r_field, read_picture(**r_field.get_map(), _channel, path, area_of(r_field)))) {
		return false;
	}
	for (size_t n = 0; _world != nullptr && n + 1 < _fields.size(); n++) {
		sew(*_fields[n], r_field);
		sew(r_field, *_fields[n]);
	}
	return true;
}

// Copies the edge of a field into a neighbour's map: a plot shows the edges of its neighbours.
void MapPictures::sew(const GrassField &p_from, const GrassField &p_to) {
	const MapRegion strip = in_parent(p_from).shared(in_parent(p_to).grown(MapLayers::CHANGE_MARGIN));
	if (strip.has_area()) {
		const Ref<Image> edge = get_channel_image(**p_from.get_map(), _channel, to_map_of(p_from, strip), true);
		set_channel_image(**p_to.get_map(), _channel, edge, to_map_of(p_to, strip));
	}
}

} // namespace grass

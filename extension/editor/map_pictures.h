// SPDX-License-Identifier: MIT
// Pictures of the maps of a field or of a world's plots: a plot has a picture of its own, NAME_X_Z.png.
#pragma once

#include "resources/channel_images.h"
#include "world/grass_world.h"

#include <vector>

namespace grass {

class MapPictures {
public:
	// Begins pictures of a channel. p_world: null for a field of its own.
	MapPictures(GrassMap::Channel p_channel, const godot::String &p_path, const GrassWorld *p_world) :
			_channel(p_channel), _path(p_path), _world(p_world) {}

	void write(const GrassField &p_field);
	// Reads the field's picture into its map, and borders of plots into each other's maps. Returns whether it was read.
	bool read(GrassField &r_field);

	int get_count() const { return int(_fields.size()); } // of pictures that were written or read
	godot::String get_problem() const { return _problem; } // of the first one that was not

private:
	godot::String path_of(const GrassField &p_field) const;
	bool note(const GrassField &p_field, const PictureProblem &p_problem);
	void sew(const GrassField &p_from, const GrassField &p_to);

	GrassMap::Channel _channel;
	godot::String _path;
	const GrassWorld *_world;
	std::vector<const GrassField *> _fields;
	godot::String _problem;
};

} // namespace grass

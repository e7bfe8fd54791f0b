// SPDX-License-Identifier: MIT
// The channels of a GrassMap as pictures: images for scripts, PNG and EXR for painting programs. A region without an area: what was painted
// in the channel.
#pragma once

#include "resources/grass_map.h"

#include <godot_cpp/classes/image.hpp>

namespace grass {

// What is wrong with a picture or with the region that it is for.
struct PictureProblem {
	godot::Error error = godot::OK;
	godot::String text; // a sentence that says what to do
};

// Return a channel's texels as an image, and write an image's into it.
godot::Ref<godot::Image> get_channel_image(
		const GrassMap &p_map, GrassMap::Channel p_channel, const godot::Rect2 &p_region, bool p_is_float);
bool set_channel_image(GrassMap &r_map, GrassMap::Channel p_channel, const godot::Ref<godot::Image> &p_image, const godot::Rect2 &p_region);
// Do the same for files, and return an Error.
int64_t save_channel_image(const GrassMap &p_map, GrassMap::Channel p_channel, const godot::String &p_path, const godot::Rect2 &p_region);
int64_t load_channel_image(GrassMap &r_map, GrassMap::Channel p_channel, const godot::String &p_path, const godot::Rect2 &p_region);
// Do the same without a message, and return what is wrong.
PictureProblem write_picture(const GrassMap &p_map, GrassMap::Channel p_channel, const godot::String &p_path, const godot::Rect2 &p_region);
PictureProblem read_picture(GrassMap &r_map, GrassMap::Channel p_channel, const godot::String &p_path, const godot::Rect2 &p_region);

} // namespace grass

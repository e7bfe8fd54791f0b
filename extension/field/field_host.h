// SPDX-License-Identifier: MIT
// What the parts of a GrassField need of their node.
#pragma once

#include "resources/grass_map.h"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>

namespace grass {

class FieldHost {
public:
	virtual ~FieldHost() = default;

	virtual godot::GeometryInstance3D &node() = 0;
	virtual godot::Transform3D field_transform() const = 0; // global, without scale
	// Returns the transform with which this frame draws the field: between two ticks if the engine interpolates physics. In a tick it
	// equals field_transform().
	virtual godot::Transform3D drawn_transform() = 0;
	// Makes the field if there is none yet. Returns false if a script that ran meanwhile freed it: then nothing of it may be used.
	[[nodiscard]] virtual bool stand() = 0;
	// Reads the parts of the wanted field that scripts provide: ground, fill, meshes. Returns false if one of them freed the field.
	[[nodiscard]] virtual bool read_scene() = 0;
	virtual void stir() = 0; // must be called after any change that a tick or a frame has to follow
	virtual void request_rebuild() = 0; // makes the field again, as the properties describe it
	virtual void warn(const godot::String &p_warning) const = 0; // in the console
	virtual void report_warnings() = 0; // new ones, once each
	virtual void show_warnings() = 0; // beside the node in the editor
	virtual void make_map() = 0; // a new one, with grass everywhere
	// Returns the map that a game changes. A field without a map gets one on which grass grows everywhere, as it did before. Returns null
	// and reports an error that names p_method if the field is outside of the tree. Also returns null if a script that ran meanwhile freed
	// the field.
	virtual GrassMap *need_map(const char *p_method) = 0;
	virtual godot::String label() const = 0; // of the node, for messages
	// Returns p_text with the node's name before it, for an error; the first time also with what a bug report needs.
	virtual godot::String message(const godot::String &p_text) const = 0;
};

} // namespace grass

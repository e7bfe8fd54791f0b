// SPDX-License-Identifier: MIT
// What the parts of a GrassField need of their node.
#pragma once

#include "resources/grass_map.h"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>

namespace grass {

class FieldHost {
public:
	virtual ~FieldHost() = default;

	virtual const godot::Node3D &as_node() const = 0;
	virtual godot::Transform3D field_transform() const = 0; // global, without scale
	// The same where this frame draws it: between two ticks, where the engine interpolates physics. In a tick as field_transform().
	virtual godot::Transform3D drawn_transform() = 0;
	// Makes the field, if it waits to be made. False: a script that ran meanwhile freed the field, so touch nothing of it.
	[[nodiscard]] virtual bool build() = 0;
	// The map that a game changes: a field that has none gets one on which grass stands everywhere, as it did. Null, with an error that
	// names p_method, outside of the tree; null, too, where a script that ran meanwhile freed the field.
	virtual GrassMap *need_map(const char *p_method) = 0;
	virtual godot::String label() const = 0; // of the node, for messages
	// Returns p_text with the node's name before it, for an error; the first time also with what a bug report needs.
	virtual godot::String message(const godot::String &p_text) const = 0;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// How messages name the object they are about: by its class, and a node's path or a resource's file, so that the user finds it.
#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/string.hpp>

namespace grass {

godot::String label_of(const godot::Node &p_node);
// Returns the label of a resource. One inside a scene has the scene's file; one without a file has its name, if it has one.
godot::String label_of(const godot::Resource &p_resource);

} // namespace grass

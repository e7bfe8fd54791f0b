// SPDX-License-Identifier: MIT
// How messages name whom they are of: by its class, and a node's path or a resource's file, so that the user finds it.
#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/string.hpp>

namespace grass {

godot::String label_of(const godot::Node &p_node);
// One within a scene has the scene's file; one that is in no file has its name, if it has one.
godot::String label_of(const godot::Resource &p_resource);

} // namespace grass

// SPDX-License-Identifier: MIT
// Which nodes belong to the scene of a plant (GrassSpecies.plant_scene), of whatever field.
#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/core/object.hpp>

namespace grass {

// The group of the nodes below which fields keep these scenes.
inline constexpr const char *PLANT_GROUP = "_grass_plants";

// Returns whether p_object is a node in the scene of a plant, while that is in the tree.
inline bool is_in_plant(const godot::Object *p_object) {
	const godot::Node *node = godot::Object::cast_to<godot::Node>(p_object);
	while (node != nullptr && !node->is_in_group(PLANT_GROUP)) {
		node = node->get_parent();
	}
	return node != nullptr;
}

} // namespace grass

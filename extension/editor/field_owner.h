// SPDX-License-Identifier: MIT
// Whether the edited scene saves what the editor changes in a field: the field or its map may be part of another scene, or of another
// field.
#pragma once

#include "nodes/grass_field.h"

#include <optional>
#include <vector>

namespace grass {

// Returns whether a resource is a file of its own, which is saved by itself and may be shared.
bool has_own_file(const godot::Resource &p_resource);

// Returns the file that a resource is a part of if it is not the scene at p_root: changes are not saved. Empty: they are.
godot::String find_foreign_file(const godot::Ref<godot::Resource> &p_resource, const godot::Node &p_root);

// Returns whether the scene at p_root saves a node's properties: it is the scene's own, or in an instance with Editable Children.
bool is_saved_by(const godot::Node &p_root, const godot::Node &p_node);

// Why changes of a field would be lost.
struct ForeignField {
	godot::String file; // that has the field or its map; may be empty
	bool has_own_properties; // the edited scene saves which map the field has
};

// Returns nothing if the edited scene saves changes of the field's map, or with p_of_map false of its properties.
std::optional<ForeignField> find_foreign(const GrassField &p_field, bool p_of_map = true);

// Returns other fields in the edited scene with the same map.
std::vector<const GrassField *> find_sharing(const GrassField &p_field);

// Returns a copy that is a part of the edited scene; null of null.
godot::Ref<godot::Resource> own_copy(const godot::Ref<godot::Resource> &p_resource);

// Returns a copy of a resource that is a part of some scene. Files, such as presets, stay shared.
godot::Ref<godot::Resource> own_if_inside(const godot::Ref<godot::Resource> &p_resource);

} // namespace grass

// SPDX-License-Identifier: MIT
// Lines that the editor draws for a node that would be invisible otherwise.
#pragma once

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/standard_material3d.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <functional>

namespace grass {

class EditorPicture {
public:
	~EditorPicture() { free(); }

	// Shows what p_make returns at p_node, which must be in a world; null: nothing. Only in the editor: in a game p_make is not called.
	void show(const godot::Node3D &p_node, const std::function<godot::Ref<godot::ArrayMesh>()> &p_make, const godot::Color &p_color);
	void follow(const godot::Node3D &p_node); // follows its place and visibility
	void free();

private:
	godot::Ref<godot::ArrayMesh> _mesh;
	godot::Ref<godot::StandardMaterial3D> _material; // of _mesh
	godot::RID _instance; // of both
};

} // namespace grass

// SPDX-License-Identifier: MIT
// Lines that the editor draws for a node that would be invisible otherwise.
#pragma once

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/standard_material3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <cstdint>
#include <functional>
#include <set>
#include <vector>

namespace grass {

class EditorPicture {
public:
	~EditorPicture() { free(); }

	// Shows what p_make returns at p_node, which must be in a world; null: nothing. Only in the editor: in a game p_make is not called.
	void show(const godot::Node3D &p_node, const std::function<godot::Ref<godot::ArrayMesh>()> &p_make, const godot::Color &p_color);
	void follow(const godot::Node3D &p_node); // follows its place and visibility
	void free();

	// Returns the mesh of lines between each pair of points.
	static godot::Ref<godot::ArrayMesh> mesh_of(const godot::PackedVector3Array &p_lines);

private:
	godot::Ref<godot::ArrayMesh> _mesh;
	godot::Ref<godot::StandardMaterial3D> _material; // of _mesh
	godot::RID _instance; // of both
};

// The nodes of one class in the tree, each with its picture, and how often any of them changed. They enter, leave and change on the main
// thread.
class PicturedNodes {
public:
	// Must be called by their _notification(). Returns true if p_node entered the tree, so that it is to be drawn.
	[[nodiscard]] bool notify(godot::Node3D &p_node, int p_what, EditorPicture &r_picture);
	// Shows the picture if p_node is in the tree, see EditorPicture::show().
	void show(godot::Node3D &p_node, const std::function<godot::Ref<godot::ArrayMesh>()> &p_make, const godot::Color &p_color,
			EditorPicture &r_picture) const;
	// Counts a change, and shows the node as it is now.
	void change(godot::Node3D &p_node, const std::function<godot::Ref<godot::ArrayMesh>()> &p_make, const godot::Color &p_color,
			EditorPicture &r_picture);
	// Returns a number that changes whenever one of them is added, removed, moved or changed.
	uint64_t get_revision() const { return _revision; }
	bool is_empty() const { return _nodes.empty(); }
	// Returns them in the order of their creation.
	template <typename T> std::vector<T *> get_all() const {
		std::vector<T *> all;
		for (const uint64_t id : _nodes) {
			all.push_back(godot::Object::cast_to<T>(godot::ObjectDB::get_instance(id)));
		}
		return all;
	}

private:
	std::set<uint64_t> _nodes; // instance ids
	uint64_t _revision = 0;
};

} // namespace grass

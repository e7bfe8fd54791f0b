// SPDX-License-Identifier: MIT
// One MultiMesh in the renderer's scene: it draws a field or casts its shadows (GPU backend), or is one of the levels of detail of either
// (CPU backend).
#pragma once

#include "draw/blade_mesh.h"
#include "draw/node_follower.h"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/rid.hpp>

namespace grass {

// The purpose of an instance: the picture shows all visible blades; shadows need far fewer. Plants with a mesh cast their own shadows.
enum class Role { PICTURE, SHADOWS, BOTH };

// Who writes the instances: the CPU; a compute pass, into the MultiMesh's buffer and the commands of its surfaces; or a pass that lists
// them in a texture of its own and writes only the commands (draw/drawn_tile.gdshaderinc).
enum class Written { BY_CPU, BY_GPU, LISTED };

class FieldInstance {
public:
	FieldInstance() = default;
	FieldInstance(const FieldInstance &) = delete;
	FieldInstance &operator=(const FieldInstance &) = delete;
	~FieldInstance() { free(); }

	// Creates the instance. p_material: of all surfaces; it must live as long. Null: the mesh has materials of its own.
	void create(const SharedMesh &p_mesh, const godot::Ref<godot::ShaderMaterial> &p_material, int p_capacity, Written p_written,
			const godot::AABB &p_bounds, Role p_role);
	// Draws another mesh. A pass must write the commands of its surfaces again.
	void set_mesh(const SharedMesh &p_mesh);
	// Sets whether there is anything to draw in this frame, in which follow() was called; without a call there is.
	void need(bool p_is_needed);
	// Makes room for more instances if the CPU writes them. Their contents are lost.
	void reserve(int p_capacity);
	// Follows the node's transform, world, visibility, layers and shadows. Must be called when any of them may have changed. p_is_flipped:
	// y is flipped over, see Backend::show_motion().
	void follow(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform, bool p_is_flipped = false);
	void set_bounds(const godot::AABB &p_bounds);
	void set_instances(const godot::PackedFloat32Array &p_instances, int p_count);
	void free();

	godot::RID multimesh() const { return _multimesh; }
	int capacity() const { return _capacity; }
	int64_t get_updates() const { return _follower.get_updates(); } // changes of the node that were passed to the renderer
	bool is_created() const { return _multimesh.is_valid(); }

private:
	SharedMesh _mesh;
	godot::RID _multimesh, _instance;
	int _capacity = 0;
	Written _written = Written::BY_CPU;
	Role _role = Role::PICTURE;
	bool _is_needed = true, _is_unwanted = false; // by what is to draw; by the node's shadows
	godot::GeometryInstance3D::ShadowCastingSetting _casting = godot::GeometryInstance3D::SHADOW_CASTING_SETTING_ON; // of Role::BOTH
	NodeFollower _follower;
};

} // namespace grass

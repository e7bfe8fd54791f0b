// SPDX-License-Identifier: MIT
#include "draw/field_instance.h"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/world3d.hpp>

using namespace godot;

namespace grass {

void FieldInstance::create(const Ref<ArrayMesh> &p_mesh, int p_capacity, bool p_indirect, const AABB &p_bounds) {
	free();
	RenderingServer *server = RenderingServer::get_singleton();
	_mesh = p_mesh;
	_capacity = p_capacity;
	_indirect = p_indirect;
	_multimesh = server->multimesh_create();
	// Data before mesh: the engine makes the command buffer in set_mesh, from the surfaces that it has then.
	server->multimesh_allocate_data(_multimesh, p_capacity, RenderingServer::MULTIMESH_TRANSFORM_3D, true, true, p_indirect);
	server->multimesh_set_mesh(_multimesh, _mesh->get_rid());
	server->multimesh_set_custom_aabb(_multimesh, p_bounds);
	if (!p_indirect) {
		server->multimesh_set_visible_instances(_multimesh, 0);
	}
	_instance = server->instance_create();
	server->instance_set_base(_instance, _multimesh);
}

void FieldInstance::follow(GeometryInstance3D *p_node, const Transform3D &p_transform) {
	if (!is_created()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	const bool in_world = p_node->is_inside_tree() && p_node->get_world_3d().is_valid();
	server->instance_set_scenario(_instance, in_world ? p_node->get_world_3d()->get_scenario() : RID());
	server->instance_set_transform(_instance, p_transform);
	server->instance_set_visible(_instance, in_world && p_node->is_visible_in_tree());
	server->instance_set_layer_mask(_instance, p_node->get_layer_mask());
	server->instance_geometry_set_cast_shadows_setting(_instance, RenderingServer::ShadowCastingSetting(p_node->get_cast_shadows_setting()));
	server->instance_geometry_set_transparency(_instance, p_node->get_transparency());
	server->instance_attach_object_instance_id(_instance, p_node->get_instance_id());
}

void FieldInstance::set_instances(const PackedFloat32Array &p_instances, int p_count) {
	RenderingServer *server = RenderingServer::get_singleton();
	if (p_count > 0) {
		server->multimesh_set_buffer(_multimesh, p_instances);
	}
	server->multimesh_set_visible_instances(_multimesh, p_count);
}

void FieldInstance::free() {
	if (!is_created()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	server->free_rid(_instance);
	server->free_rid(_multimesh);
	_instance = _multimesh = RID();
	_mesh.unref();
}

} // namespace grass

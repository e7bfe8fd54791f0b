// SPDX-License-Identifier: MIT
#include "draw/field_instance.h"

#include <godot_cpp/classes/rendering_server.hpp>

using namespace godot;

namespace grass {

void FieldInstance::create(const SharedMesh &p_mesh, const Ref<ShaderMaterial> &p_material, int p_capacity, Written p_written,
		const AABB &p_bounds, Role p_role) {
	free();
	RenderingServer *server = RenderingServer::get_singleton();
	_mesh = p_mesh;
	_written = p_written;
	_multimesh = server->multimesh_create();
	// Set the data before the mesh: in set_mesh the engine makes the command buffer from the surfaces that it has at that time.
	reserve(p_capacity);
	server->multimesh_set_mesh(_multimesh, (*_mesh)->get_rid());
	server->multimesh_set_custom_aabb(_multimesh, p_bounds);
	if (p_written == Written::BY_CPU) {
		server->multimesh_set_visible_instances(_multimesh, 0);
	}
	_instance = server->instance_create();
	server->instance_set_base(_instance, _multimesh);
	if (p_material.is_valid()) {
		server->instance_geometry_set_material_override(_instance, p_material->get_rid());
	}
	server->instance_geometry_set_cast_shadows_setting(_instance,
			p_role == Role::PICTURE        ? RenderingServer::SHADOW_CASTING_SETTING_OFF
					: p_role == Role::BOTH ? RenderingServer::SHADOW_CASTING_SETTING_ON
										   : RenderingServer::SHADOW_CASTING_SETTING_SHADOWS_ONLY);
	_casting = GeometryInstance3D::SHADOW_CASTING_SETTING_ON;
	_role = p_role;
	_is_needed = true;
	_follower.reset();
}

void FieldInstance::set_mesh(const SharedMesh &p_mesh) {
	if (is_created() && _mesh != p_mesh) {
		RenderingServer::get_singleton()->multimesh_set_mesh(_multimesh, (*p_mesh)->get_rid());
		_mesh = p_mesh; // releases the previous one
	}
}

void FieldInstance::need(bool p_is_needed) {
	if (is_created() && _is_needed != p_is_needed) {
		_is_needed = p_is_needed;
		_follower.show(_instance, _is_needed && !_is_unwanted);
	}
}

void FieldInstance::reserve(int p_capacity) {
	_capacity = p_capacity;
	const bool is_listed = _written == Written::LISTED; // its transforms are not used; with two rows they take less memory
	RenderingServer::get_singleton()->multimesh_allocate_data(_multimesh, p_capacity,
			is_listed ? RenderingServer::MULTIMESH_TRANSFORM_2D : RenderingServer::MULTIMESH_TRANSFORM_3D, !is_listed, !is_listed,
			_written != Written::BY_CPU);
}

void FieldInstance::follow(GeometryInstance3D *p_node, const Transform3D &p_transform, bool p_is_flipped) {
	if (!is_created()) {
		return;
	}
	const GeometryInstance3D::ShadowCastingSetting setting = p_node->get_cast_shadows_setting();
	if (_role == Role::BOTH && setting != _casting) {
		_casting = setting;
		RenderingServer::get_singleton()->instance_geometry_set_cast_shadows_setting(
				_instance, RenderingServer::ShadowCastingSetting(int(setting)));
	}
	_is_unwanted = _role == Role::BOTH ? false
			: _role == Role::PICTURE   ? setting == GeometryInstance3D::SHADOW_CASTING_SETTING_SHADOWS_ONLY
									   : setting == GeometryInstance3D::SHADOW_CASTING_SETTING_OFF;
	Transform3D transform = p_transform;
	if (p_is_flipped) {
		transform.basis.scale_local(Vector3(1, -1, 1));
	}
	_follower.follow(_instance, p_node, transform, _is_needed && !_is_unwanted);
}

void FieldInstance::set_bounds(const AABB &p_bounds) {
	if (is_created()) {
		RenderingServer::get_singleton()->multimesh_set_custom_aabb(_multimesh, p_bounds);
	}
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
	_mesh.reset();
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "shared/editor_picture.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/world3d.hpp>

using namespace godot;

namespace grass {

void EditorPicture::show(const Node3D &p_node, const std::function<Ref<ArrayMesh>()> &p_make, const Color &p_color) {
	if (!Engine::get_singleton()->is_editor_hint()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	_mesh = p_make();
	if (!_instance.is_valid()) {
		_material.instantiate();
		_material->set_shading_mode(BaseMaterial3D::SHADING_MODE_UNSHADED);
		_material->set_albedo(p_color);
		_instance = server->instance_create();
		server->instance_set_scenario(_instance, p_node.get_world_3d()->get_scenario());
		server->instance_geometry_set_cast_shadows_setting(_instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
		server->instance_geometry_set_material_override(_instance, _material->get_rid());
	}
	server->instance_set_base(_instance, _mesh.is_valid() ? _mesh->get_rid() : RID());
	follow(p_node);
}

void EditorPicture::follow(const Node3D &p_node) {
	if (_instance.is_valid()) {
		RenderingServer::get_singleton()->instance_set_transform(_instance, p_node.get_global_transform());
		RenderingServer::get_singleton()->instance_set_visible(_instance, p_node.is_visible_in_tree());
	}
}

void EditorPicture::free() {
	if (_instance.is_valid()) {
		RenderingServer::get_singleton()->free_rid(_instance);
		_instance = RID();
	}
	_mesh.unref();
	_material.unref();
}

Ref<ArrayMesh> EditorPicture::mesh_of(const PackedVector3Array &p_lines) {
	Ref<ArrayMesh> mesh;
	mesh.instantiate();
	if (!p_lines.is_empty()) {
		Array arrays;
		arrays.resize(Mesh::ARRAY_MAX);
		arrays[Mesh::ARRAY_VERTEX] = p_lines;
		mesh->add_surface_from_arrays(Mesh::PRIMITIVE_LINES, arrays);
	}
	return mesh;
}

void PicturedNodes::show(
		Node3D &p_node, const std::function<Ref<ArrayMesh>()> &p_make, const Color &p_color, EditorPicture &r_picture) const {
	if (_nodes.contains(p_node.get_instance_id())) {
		r_picture.show(p_node, p_make, p_color);
	}
}

void PicturedNodes::change(Node3D &p_node, const std::function<Ref<ArrayMesh>()> &p_make, const Color &p_color, EditorPicture &r_picture) {
	_revision++;
	show(p_node, p_make, p_color, r_picture);
	p_node.update_configuration_warnings();
}

bool PicturedNodes::notify(Node3D &p_node, int p_what, EditorPicture &r_picture) {
	switch (p_what) {
		case Node3D::NOTIFICATION_ENTER_WORLD:
			_nodes.insert(p_node.get_instance_id());
			p_node.set_notify_transform(true);
			return true;
		case Node3D::NOTIFICATION_EXIT_WORLD:
			_nodes.erase(p_node.get_instance_id());
			_revision++;
			r_picture.free();
			break;
		case Node3D::NOTIFICATION_TRANSFORM_CHANGED:
			_revision++;
			r_picture.follow(p_node);
			break;
		case Node3D::NOTIFICATION_VISIBILITY_CHANGED:
			r_picture.follow(p_node);
			break;
	}
	return false;
}

} // namespace grass

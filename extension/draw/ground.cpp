// SPDX-License-Identifier: MIT
#include "draw/ground.h"

#include "draw/shared_shader.h"
#include "draw/surface_hook.h"
#include "render_shaders.gen.h"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

using namespace godot;

namespace grass {

namespace {
constexpr real_t LIFT = 0.005f; // metres above the user's floor; less flickers with it, more shows at the field's edge

int ground_features(int p_features) {
	return p_features & ~SHADER_CARDS; // flowers are a colour there
}
} // namespace

bool Ground::prepare(int p_features) {
	return prepare_shader(shader::GROUND_GDSHADER, ground_features(p_features));
}

void Ground::create(const TileGrid &p_grid, int p_features) {
	free();
	const real_t x = real_t(0.5 * p_grid.get_size_x()), z = real_t(0.5 * p_grid.get_size_z());
	PackedVector3Array vertices, normals;
	for (const Vector3 &corner : { Vector3(-x, LIFT, -z), Vector3(x, LIFT, -z), Vector3(x, LIFT, z), Vector3(-x, LIFT, z) }) {
		vertices.push_back(corner);
		normals.push_back(Vector3(0, 1, 0));
	}
	PackedInt32Array indices;
	for (const int32_t index : { 0, 1, 2, 0, 2, 3 }) {
		indices.push_back(index);
	}
	Array arrays;
	arrays.resize(Mesh::ARRAY_MAX);
	arrays[Mesh::ARRAY_VERTEX] = vertices;
	arrays[Mesh::ARRAY_NORMAL] = normals;
	arrays[Mesh::ARRAY_INDEX] = indices;
	_material.instantiate();
	_features = ground_features(p_features);
	_material->set_shader(shared_shader(shader::GROUND_GDSHADER, _features));
	_material->set_shader_parameter("size", Vector2(2 * x, 2 * z));
	_material->set_render_priority(Material::RENDER_PRIORITY_MIN); // its edge is transparent: water and smoke come after it
	_mesh.instantiate();
	_mesh->add_surface_from_arrays(Mesh::PRIMITIVE_TRIANGLES, arrays);
	_mesh->surface_set_material(0, _material);
	RenderingServer *server = RenderingServer::get_singleton();
	_instance = server->instance_create();
	server->instance_set_base(_instance, _mesh->get_rid());
	_follower.reset();
	server->instance_geometry_set_cast_shadows_setting(_instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
}

void Ground::follow(GeometryInstance3D *p_node, const Transform3D &p_transform, bool p_shown) {
	if (_instance.is_valid()) {
		_follower.follow(_instance, p_node, p_transform, p_shown);
	}
}

void Ground::set_uniform(const StringName &p_name, const Variant &p_value) {
	if (_material.is_valid()) {
		_material->set_shader_parameter(p_name, p_value);
	}
}

bool Ground::set_hook(const String &p_text) {
	if (_material.is_null()) {
		return true;
	}
	const Ref<Shader> shader = shared_shader(shader::GROUND_GDSHADER, _features, p_text);
	_material->set_shader(shader);
	return is_compiled(shader, p_text);
}

void Ground::free() {
	if (_instance.is_valid()) {
		RenderingServer::get_singleton()->free_rid(_instance);
	}
	_instance = RID();
	_mesh.unref();
	_material.unref();
}

} // namespace grass

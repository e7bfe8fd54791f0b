// SPDX-License-Identifier: MIT
#include "draw/shader_job.h"

#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <mutex>

using namespace godot;

namespace grass {

namespace {

std::mutex making; // held by the worker that is making a shader

PackedByteArray zeros(int64_t p_bytes) {
	PackedByteArray bytes;
	bytes.resize(p_bytes);
	bytes.fill(0);
	return bytes;
}

// Returns a degenerate triangle. Only its format counts, which must be that of the later meshes.
Dictionary make_surface(VertexKind p_vertices) {
	constexpr int64_t VERSION = int64_t(RenderingServer::ARRAY_FLAG_FORMAT_CURRENT_VERSION), INDEX = Mesh::ARRAY_FORMAT_INDEX;
	constexpr int64_t GROUND = Mesh::ARRAY_FORMAT_VERTEX | Mesh::ARRAY_FORMAT_NORMAL | Mesh::ARRAY_FORMAT_TANGENT;
	constexpr int64_t PLANT = GROUND | Mesh::ARRAY_FORMAT_TEX_UV | Mesh::ARRAY_FORMAT_CUSTOM0 |
			(int64_t(Mesh::ARRAY_CUSTOM_RGB_FLOAT) << Mesh::ARRAY_FORMAT_CUSTOM0_SHIFT);
	const bool has_vertices = p_vertices != VertexKind::BLADE;
	Dictionary surface;
	surface["primitive"] = RenderingServer::PRIMITIVE_TRIANGLES;
	surface["format"] = VERSION | INDEX |
			(p_vertices == VertexKind::PLANT                   ? PLANT
							: p_vertices == VertexKind::GROUND ? GROUND
															   : int64_t(Mesh::ARRAY_FLAG_USES_EMPTY_VERTEX_ARRAY));
	surface["vertex_count"] = has_vertices ? 3 : 0;
	surface["vertex_data"] = zeros(has_vertices ? 3 * (12 + 4 + 4) : 0); // position, normal, tangent
	if (p_vertices == VertexKind::PLANT) {
		surface["attribute_data"] = zeros(3 * (8 + 12)); // UV, three numbers
	}
	surface["index_count"] = 3;
	surface["index_data"] = zeros(3 * (has_vertices ? 2 : 4));
	surface["aabb"] = AABB(Vector3(), Vector3(1, 1, 1));
	return surface;
}

} // namespace

ShaderJob::ShaderJob(const ShaderText &p_text) :
		_code(make_shader_code(p_text.code, p_text.look)), _surface(make_surface(p_text.vertices)) {}

ShaderJob::~ShaderJob() {
	if (_mesh.is_valid()) {
		RenderingServer::get_singleton()->free_rid(_mesh);
	}
}

// If a thread other than the renderer's creates a mesh, the call returns when all pipelines of its materials are ready. The engine's
// loaders wait for those of a scene in this way.
void ShaderJob::work() {
	{
		std::lock_guard lock(making);
		_shader.instantiate();
		_shader->set_code(_code);
		_material.instantiate();
		_material->set_shader(_shader);
		_surface["material"] = _material->get_rid(); // compiles the shader
	}
	TypedArray<Dictionary> surfaces;
	surfaces.push_back(_surface);
	_mesh = RenderingServer::get_singleton()->mesh_create_from_surfaces(surfaces);
	_is_done = true;
}

void ShaderJob::wait_for_shaders() {
	std::lock_guard lock(making);
}

} // namespace grass

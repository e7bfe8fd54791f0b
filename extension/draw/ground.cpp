// SPDX-License-Identifier: MIT
#include "draw/ground.h"

#include "render_shaders.gen.h"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

using namespace godot;

namespace grass {

namespace {
constexpr real_t LIFT = 0.005f; // metres above the user's floor; lower flickers with the floor, higher shows at the field's edge

// The same on hills, metres for each metre of a cell's side, since the ground curves between a cell's corners.
constexpr double LIFT_OF_CELLS = 0.03;
// Cells of the sheet on hills: their size in metres, equal to the spacing of the map's heights, and their largest number along a side.
// More: vertices that make no visible difference.
constexpr double CELL = GRASS_CHUNK_SIZE / GRASS_COARSE_TEXELS;
constexpr int MOST_CELLS = 256;
constexpr double CLOSE = 0.01; // metres; closer lines are one

// How deep the sheet's rim hangs down on hills, metres, and metres more for each metre of a cell's side. A field beside it has other cells,
// whose edge runs above and below its own. Less: one sees through between them; more: a rim in the air is seen where the ground ends.
constexpr double RIM = 0.1, RIM_OF_CELLS = 0.1;

// Returns where the sheet's cells begin and end along an axis, metres from the field's middle: where heights lie, if they have a grid of
// their own.
std::vector<double> lines_along(double p_metres, bool p_has_grid, double p_offset) {
	const int cells = std::clamp(int(std::ceil(p_metres / CELL)), 1, MOST_CELLS);
	const double half = 0.5 * p_metres, first = std::ceil(-half - p_offset - 0.5) + 0.5 + p_offset;
	std::vector<double> lines{ -half };
	if (p_has_grid && p_metres <= MOST_CELLS * CELL) {
		for (double line = first; line < half - CLOSE; line += CELL) {
			if (line > -half + CLOSE) {
				lines.push_back(line);
			}
		}
	} else {
		for (int n = 1; n < cells; n++) {
			lines.push_back(p_metres * n / cells - half);
		}
	}
	lines.push_back(half);
	return lines;
}
} // namespace

ShaderText Ground::text(const Look &p_look) {
	return { shader::GROUND_GDSHADER, VertexKind::GROUND, { p_look.features & ~SHADER_CARDS, p_look.hook } }; // flowers are just a colour
}

void Ground::create(const TileGrid &p_grid, const Look &p_look) {
	free();
	_grid = p_grid;
	_low = _high = 0.0f;
	_has_ledges = false;
	_heights = GroundGrid();
	_material.instantiate();
	set_look(p_look);
	_material->set_shader_parameter("size", Vector2(real_t(p_grid.get_size_x()), real_t(p_grid.get_size_z())));
	_material->set_render_priority(Material::RENDER_PRIORITY_MIN); // its edge is transparent: draw water and smoke after it
	RenderingServer *server = RenderingServer::get_singleton();
	_instance = server->instance_create();
	make_mesh();
	_follower.reset();
	server->instance_geometry_set_cast_shadows_setting(_instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
}

Ref<ArrayMesh> Ground::make_sheet(double p_x, double p_z, Sheet p_sheet, const GroundGrid &p_heights) {
	const bool is_flat = p_sheet == Sheet::FLAT, is_split = p_sheet == Sheet::LEDGES, has_grid = !(p_heights == GroundGrid());
	const Eigen::Vector2d offset = p_heights.offset();
	std::vector<double> along_x = is_flat ? std::vector{ -0.5 * p_x, 0.5 * p_x } : lines_along(p_x, has_grid, offset.x()),
						along_z = is_flat ? std::vector{ -0.5 * p_z, 0.5 * p_z } : lines_along(p_z, has_grid, offset.y());
	const double cell = std::max({ has_grid ? CELL : 0.0, p_x / double(along_x.size() - 1), p_z / double(along_z.size() - 1) });
	const double lift = is_flat ? LIFT : LIFT_OF_CELLS * cell;
	const bool has_rim = p_sheet == Sheet::HILLS;
	if (has_rim) { // its outer line lies below the edge
		for (std::vector<double> *lines : { &along_x, &along_z }) {
			lines->insert(lines->begin(), lines->front());
			lines->push_back(lines->back());
		}
	}
	const int columns = int(along_x.size()) - 1, rows = int(along_z.size()) - 1;
	const int64_t cells = int64_t(columns) * rows;
	PackedVector3Array vertices, normals;
	PackedVector2Array middles; // of the cells
	PackedInt32Array indices;
	vertices.resize(is_split ? 4 * cells : int64_t(columns + 1) * (rows + 1));
	normals.resize(vertices.size());
	normals.fill(Vector3(0, 1, 0));
	indices.resize(6 * cells);
	Vector3 *vertex = vertices.ptrw();
	if (is_split) {
		middles.resize(vertices.size());
	}
	Vector2 *middle = middles.ptrw();
	for (int j = 0; j < rows + (is_split ? 0 : 1); j++) {
		for (int i = 0; i < columns + (is_split ? 0 : 1); i++) {
			const bool is_rim = has_rim && (i == 0 || i == columns || j == 0 || j == rows);
			const double above = is_rim ? lift - RIM - RIM_OF_CELLS * cell : lift;
			for (int corner = 0; corner < (is_split ? 4 : 1); corner++) {
				*vertex++ = Vector3(real_t(along_x[size_t(i + (corner & 1))]), real_t(above), real_t(along_z[size_t(j + (corner >> 1))]));
				if (is_split) {
					*middle++ = Vector2(real_t(0.5 * (along_x[size_t(i)] + along_x[size_t(i) + 1])),
							real_t(0.5 * (along_z[size_t(j)] + along_z[size_t(j) + 1])));
				}
			}
		}
	}
	const bool is_beside = p_heights.split == GroundSplit::BESIDE;
	int32_t *index = indices.ptrw();
	for (int j = 0; j < rows; j++) {
		for (int i = 0; i < columns; i++) {
			const int32_t first = is_split ? 4 * (j * columns + i) : j * (columns + 1) + i,
						  next = is_split ? first + 2 : first + columns + 1;
			const int32_t second = is_beside ? next : next + 1, third = is_beside ? first + 1 : first;
			for (const int32_t corner : { first, first + 1, second, third, next + 1, next }) {
				*index++ = corner;
			}
		}
	}
	Array arrays;
	arrays.resize(Mesh::ARRAY_MAX);
	arrays[Mesh::ARRAY_VERTEX] = vertices;
	arrays[Mesh::ARRAY_NORMAL] = normals;
	arrays[Mesh::ARRAY_INDEX] = indices;
	if (is_split) {
		arrays[Mesh::ARRAY_TEX_UV] = middles;
	}
	Ref<ArrayMesh> mesh;
	mesh.instantiate();
	mesh->add_surface_from_arrays(Mesh::PRIMITIVE_TRIANGLES, arrays);
	return mesh;
}

// Makes the sheet's mesh, or shares another ground's: a sheet on hills has a hundred thousand triangles, and all plots of a world have the
// same size.
void Ground::make_mesh() {
	static std::map<std::tuple<double, double, Sheet, uint32_t>, std::weak_ptr<Ref<ArrayMesh>>> sheets;
	const double x = _grid.get_size_x(), z = _grid.get_size_z();
	const Sheet sheet = find_sheet();
	std::erase_if(sheets, [](const auto &p_entry) { return p_entry.second.expired(); });
	std::weak_ptr<Ref<ArrayMesh>> &known = sheets[{ x, z, sheet, pack_ground_grid(_heights) }];
	std::shared_ptr<Ref<ArrayMesh>> mesh = known.lock();
	if (!mesh) {
		mesh = std::make_shared<Ref<ArrayMesh>>(make_sheet(x, z, sheet, _heights));
		known = mesh;
	}
	RenderingServer::get_singleton()->instance_set_base(_instance, (*mesh)->get_rid());
	RenderingServer::get_singleton()->instance_geometry_set_material_override(_instance, _material->get_rid());
	_mesh = mesh; // releases the previous one
	_material->set_shader_parameter("is_split", sheet == Sheet::LEDGES);
}

void Ground::set_heights(float p_low, float p_high, bool p_has_ledges, const GroundGrid &p_heights) {
	const bool is_same = p_low == _low && p_high == _high && p_has_ledges == _has_ledges && p_heights == _heights;
	if (!_instance.is_valid() || is_same) {
		return;
	}
	const Sheet before = find_sheet();
	_low = p_low;
	_high = p_high;
	_has_ledges = p_has_ledges;
	const bool lie_elsewhere = !(std::exchange(_heights, p_heights) == p_heights);
	if (before != find_sheet() || lie_elsewhere) {
		make_mesh();
	}
	const real_t x = real_t(_grid.get_size_x()), z = real_t(_grid.get_size_z());
	RenderingServer::get_singleton()->instance_set_custom_aabb(
			_instance, AABB(Vector3(real_t(-0.5) * x, _low, real_t(-0.5) * z), Vector3(x, _high - _low + 1, z)));
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

void Ground::set_look(const Look &p_look) {
	_material->set_shader(shared_shader(text(p_look)));
}

void Ground::free() {
	if (_instance.is_valid()) {
		RenderingServer::get_singleton()->free_rid(_instance);
	}
	_instance = RID();
	_mesh.reset();
	_material.unref();
}

} // namespace grass

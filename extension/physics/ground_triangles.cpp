// SPDX-License-Identifier: MIT
#include "physics/ground_triangles.h"

#include "core/map/grid_finder.h"
#include "shared/convert.h"

#include <godot_cpp/classes/concave_polygon_shape3d.hpp>
#include <godot_cpp/classes/height_map_shape3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/variant/dictionary.hpp>

using namespace godot;

namespace grass {

namespace {

// Triangles that are looked at for a grid, in stretches of neighbours. More: a large terrain takes longer to bake.
constexpr int64_t STRETCHES = 64, IN_STRETCH = 64;

} // namespace

GroundTriangles::GroundTriangles(const Ref<Shape3D> &p_shape) {
	if (const HeightMapShape3D *map = Object::cast_to<HeightMapShape3D>(p_shape.ptr())) {
		set_map(map->get_map_width(), map->get_map_depth(), map->get_map_data());
	} else if (const ConcavePolygonShape3D *faces = Object::cast_to<ConcavePolygonShape3D>(p_shape.ptr())) {
		_faces = faces->get_faces();
	}
}

GroundTriangles::GroundTriangles(const RID &p_shape) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const PhysicsServer3D::ShapeType type = server->shape_get_type(p_shape);
	if (type == PhysicsServer3D::SHAPE_HEIGHTMAP) {
		const Dictionary data = server->shape_get_data(p_shape);
		set_map(data["width"], data["depth"], data["heights"]);
	} else if (type == PhysicsServer3D::SHAPE_CONCAVE_POLYGON) {
		const Dictionary data = server->shape_get_data(p_shape);
		_faces = data["faces"];
	}
}

void GroundTriangles::set_map(int p_width, int p_depth, const PackedRealArray &p_heights) {
	if (p_width > 0 && p_depth > 0 && p_heights.size() >= int64_t(p_width) * p_depth) {
		_width = p_width;
		_depth = p_depth;
		_heights = p_heights;
	}
}

Eigen::Vector3d GroundTriangles::corner(int64_t p_i, int64_t p_j) const {
	return { double(p_i) - 0.5 * (_width - 1), double(_heights[p_j * _width + p_i]), double(p_j) - 0.5 * (_depth - 1) };
}

void GroundTriangles::visit(const Eigen::Affine3d &p_to_field, int64_t p_first, int64_t p_end, const Visit &p_visit) const {
	for (int64_t n = p_first; n < p_end; n++) {
		if (_width == 0) {
			p_visit(p_to_field * to_eigen(_faces[3 * n]), p_to_field * to_eigen(_faces[3 * n + 1]),
					p_to_field * to_eigen(_faces[3 * n + 2]));
			continue;
		}
		const int64_t cell = n / 2, i = cell % (_width - 1), j = cell / (_width - 1), far = n % 2;
		p_visit(p_to_field * (far == 0 ? corner(i, j) : corner(i + 1, j + 1)), p_to_field * corner(i, j + 1),
				p_to_field * corner(i + 1, j));
	}
}

std::optional<GroundGrid> GroundTriangles::find_grid(const Eigen::Affine3d &p_to_field) const {
	GridFinder finder;
	const int64_t step = std::max(count() / STRETCHES, IN_STRETCH);
	for (int64_t first = 0; first < count(); first += step) {
		visit(p_to_field, first, std::min(first + IN_STRETCH, count()),
				[&](const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b, const Eigen::Vector3d &p_c) { finder.add(p_a, p_b, p_c); });
	}
	return finder.find();
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "physics/ground_sheet.h"

#include "shared/convert.h"

#include <godot_cpp/classes/concave_polygon_shape3d.hpp>
#include <godot_cpp/classes/height_map_shape3d.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

using namespace godot;

namespace grass {

namespace {

// A NaN among the heights is a hole.
void add_height_map(HeightSheet &r_sheet, const HeightMapShape3D &p_shape, const Eigen::Affine3d &p_to_field) {
	const int width = p_shape.get_map_width(), depth = p_shape.get_map_depth();
	const PackedRealArray heights = p_shape.get_map_data();
	if (heights.size() < int64_t(width) * depth) {
		return;
	}
	const auto corner = [&](int p_i, int p_j) -> Eigen::Vector3d {
		return p_to_field * Eigen::Vector3d(p_i - 0.5 * (width - 1), double(heights[int64_t(p_j) * width + p_i]), p_j - 0.5 * (depth - 1));
	};
	for (int j = 0; j + 1 < depth; j++) {
		for (int i = 0; i + 1 < width; i++) {
			r_sheet.add(corner(i, j), corner(i, j + 1), corner(i + 1, j));
			r_sheet.add(corner(i + 1, j), corner(i, j + 1), corner(i + 1, j + 1));
		}
	}
}

void add_faces(HeightSheet &r_sheet, const PackedVector3Array &p_faces, const Eigen::Affine3d &p_to_field) {
	for (int64_t i = 0; i + 2 < p_faces.size(); i += 3) {
		r_sheet.add(p_to_field * to_eigen(p_faces[i]), p_to_field * to_eigen(p_faces[i + 1]), p_to_field * to_eigen(p_faces[i + 2]));
	}
}

} // namespace

bool is_ground_shape(const Ref<Shape3D> &p_shape) {
	return Object::cast_to<HeightMapShape3D>(p_shape.ptr()) != nullptr || Object::cast_to<ConcavePolygonShape3D>(p_shape.ptr()) != nullptr;
}

void add_ground_shape(HeightSheet &r_sheet, const Ref<Shape3D> &p_shape, const Eigen::Affine3d &p_to_field) {
	if (const HeightMapShape3D *height_map = Object::cast_to<HeightMapShape3D>(p_shape.ptr())) {
		add_height_map(r_sheet, *height_map, p_to_field);
	} else if (const ConcavePolygonShape3D *faces = Object::cast_to<ConcavePolygonShape3D>(p_shape.ptr())) {
		add_faces(r_sheet, faces->get_faces(), p_to_field);
	}
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "physics/ground_sheet.h"

#include "core/map/map_channels.h"
#include "shared/convert.h"

#include <godot_cpp/classes/concave_polygon_shape3d.hpp>
#include <godot_cpp/classes/height_map_shape3d.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <limits>

using namespace godot;

namespace grass {

namespace {

struct HeightMap {
	int width, depth;
	PackedRealArray heights; // a NaN is a hole

	explicit HeightMap(const HeightMapShape3D &p_shape) :
			width(p_shape.get_map_width()), depth(p_shape.get_map_depth()), heights(p_shape.get_map_data()) {
		if (heights.size() < int64_t(width) * depth) {
			width = depth = 0;
		}
	}
	Eigen::Vector3d corner(int p_i, int p_j) const {
		return { p_i - 0.5 * (width - 1), double(heights[int64_t(p_j) * width + p_i]), p_j - 0.5 * (depth - 1) };
	}
};

void add_height_map(HeightSheet &r_sheet, const HeightMap &p_map, const Eigen::Affine3d &p_to_field) {
	const auto corner = [&](int p_i, int p_j) -> Eigen::Vector3d { return p_to_field * p_map.corner(p_i, p_j); };
	for (int j = 0; j + 1 < p_map.depth; j++) {
		for (int i = 0; i + 1 < p_map.width; i++) {
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

MapRegion ground_shape_bounds(const Ref<Shape3D> &p_shape, const Eigen::Affine3d &p_to_field) {
	constexpr double FAR = std::numeric_limits<double>::infinity();
	MapRegion bounds{ Eigen::Vector2d::Constant(FAR), Eigen::Vector2d::Constant(-FAR) };
	const auto add = [&](const Eigen::Vector3d &p_corner) {
		const Eigen::Vector3d at = p_to_field * p_corner;
		if (at.allFinite()) {
			bounds.min = bounds.min.cwiseMin(Eigen::Vector2d(at.x(), at.z()));
			bounds.max = bounds.max.cwiseMax(Eigen::Vector2d(at.x(), at.z()));
		}
	};
	if (const HeightMapShape3D *map = Object::cast_to<HeightMapShape3D>(p_shape.ptr())) {
		const HeightMap heights(*map);
		for (int n = 0; n < heights.width * heights.depth; n++) {
			add(heights.corner(n % heights.width, n / heights.width));
		}
	} else if (const ConcavePolygonShape3D *faces = Object::cast_to<ConcavePolygonShape3D>(p_shape.ptr())) {
		const PackedVector3Array corners = faces->get_faces();
		for (int64_t i = 0; i < corners.size(); i++) {
			add(to_eigen(corners[i]));
		}
	}
	return bounds.min.x() <= bounds.max.x() ? bounds.grown(info_of(MAP_GROUND).texel_size()) : bounds;
}

void add_ground_shape(HeightSheet &r_sheet, const Ref<Shape3D> &p_shape, const Eigen::Affine3d &p_to_field) {
	if (const HeightMapShape3D *height_map = Object::cast_to<HeightMapShape3D>(p_shape.ptr())) {
		add_height_map(r_sheet, HeightMap(*height_map), p_to_field);
	} else if (const ConcavePolygonShape3D *faces = Object::cast_to<ConcavePolygonShape3D>(p_shape.ptr())) {
		add_faces(r_sheet, faces->get_faces(), p_to_field);
	}
}

} // namespace grass

// SPDX-License-Identifier: MIT
// GrassField's ground: reads the shape of what the grass stands on into the map.
#include "nodes/grass_field.h"

#include "convert.h"
#include "core/map/height_sheet.h"
#include "nodes/ground_rays.h"
#include "nodes/main_thread.h"

#include <godot_cpp/classes/concave_polygon_shape3d.hpp>
#include <godot_cpp/classes/height_map_shape3d.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <cmath>

using namespace godot;

namespace grass {

namespace {

constexpr double BORDER = info_of(MAP_GROUND).texel_size(); // what the field's last blades blend with

// A NaN among the heights is a hole.
void add_height_map(HeightSheet &r_sheet, const HeightMapShape3D &p_shape, const Eigen::Affine3d &p_to_field) {
	const int width = p_shape.get_map_width(), depth = p_shape.get_map_depth();
	const PackedFloat32Array heights = p_shape.get_map_data();
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

MapRegion GrassField::bake_region(const Rect2 &p_region) const {
	if (!p_region.has_area()) {
		const Eigen::Vector2d half = 0.5 * to_eigen(_size);
		return MapRegion{ -half, half }.grown(BORDER);
	}
	return { to_eigen(p_region.position), to_eigen(p_region.get_end()) };
}

int64_t GrassField::lay_ground_by(const MapRegion &p_region, const HeightAt &p_height) {
	GrassMap *map = find_map("bake_ground");
	if (map == nullptr) {
		return 0;
	}
	int64_t found = 0;
	map->change([&](PaintMap &r_map) {
		return lay_ground(r_map, p_region, [&](const Eigen::Vector2d &p_place) {
			const double height = p_height(p_place);
			found += std::isfinite(height) ? 1 : 0;
			return height;
		});
	});
	return found;
}

int64_t GrassField::bake_ground(const Rect2 &p_region, int64_t p_mask) {
	GRASS_MAIN_THREAD_ONLY_V(0);
	ERR_FAIL_COND_V_MSG(!p_region.is_finite(), 0, message("bake_ground() needs a region of finite numbers, or an empty one."));
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), 0, message("add the node to the scene tree before baking its ground."));
	GroundRays rays(get_world_3d(), field_transform(), p_mask);
	ERR_FAIL_COND_V_MSG(!rays.is_usable(), 0,
			message("the physics cannot be asked now. Where it runs on a thread of its own, call bake_ground() in _physics_process()."));
	return lay_ground_by(bake_region(p_region),
			[&](const Eigen::Vector2d &p_place) { return rays.height_at(p_place, -GroundRays::REACH, GroundRays::REACH); });
}

int64_t GrassField::bake_ground_from(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	GRASS_MAIN_THREAD_ONLY_V(0);
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), 0, message("add the node to the scene tree before baking its ground."));
	ERR_FAIL_COND_V_MSG(!p_transform.is_finite(), 0, message("bake_ground_from() needs a transform of finite numbers."));
	const HeightMapShape3D *height_map = Object::cast_to<HeightMapShape3D>(p_shape.ptr());
	const ConcavePolygonShape3D *faces = Object::cast_to<ConcavePolygonShape3D>(p_shape.ptr());
	ERR_FAIL_COND_V_MSG(height_map == nullptr && faces == nullptr, 0,
			message("bake_ground_from() reads a HeightMapShape3D or a ConcavePolygonShape3D. For other ground, use bake_ground()."));
	const MapRegion region = bake_region(Rect2());
	HeightSheet sheet(region);
	const Eigen::Affine3d to_field = to_eigen(field_transform()).inverse(Eigen::Isometry) * to_eigen(p_transform);
	if (height_map != nullptr) {
		add_height_map(sheet, *height_map, to_field);
	} else {
		add_faces(sheet, faces->get_faces(), to_field);
	}
	return lay_ground_by(region, [&](const Eigen::Vector2d &p_place) { return sheet.at(p_place); });
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "physics/ground_sheet.h"

#include "core/map/map_channels.h"

#include <godot_cpp/classes/concave_polygon_shape3d.hpp>
#include <godot_cpp/classes/height_map_shape3d.hpp>

#include <limits>

using namespace godot;

namespace grass {

bool is_ground_shape(const Ref<Shape3D> &p_shape) {
	return Object::cast_to<HeightMapShape3D>(p_shape.ptr()) != nullptr || Object::cast_to<ConcavePolygonShape3D>(p_shape.ptr()) != nullptr;
}

MapRegion ground_bounds(const GroundTriangles &p_ground, const Eigen::Affine3d &p_to_field) {
	constexpr double FAR = std::numeric_limits<double>::infinity();
	MapRegion bounds{ Eigen::Vector2d::Constant(FAR), Eigen::Vector2d::Constant(-FAR) };
	const auto add = [&](const Eigen::Vector3d &p_at) {
		if (p_at.allFinite()) {
			bounds.min = bounds.min.cwiseMin(Eigen::Vector2d(p_at.x(), p_at.z()));
			bounds.max = bounds.max.cwiseMax(Eigen::Vector2d(p_at.x(), p_at.z()));
		}
	};
	p_ground.visit(
			p_to_field, 0, p_ground.count(), [&](const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b, const Eigen::Vector3d &p_c) {
				add(p_a);
				add(p_b);
				add(p_c);
			});
	return bounds.min.x() <= bounds.max.x() ? bounds.grown(info_of(MAP_GROUND).texel_size()) : bounds;
}

void add_ground(HeightSheet &r_sheet, const GroundTriangles &p_ground, const Eigen::Affine3d &p_to_field) {
	p_ground.visit(p_to_field, 0, p_ground.count(),
			[&](const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b, const Eigen::Vector3d &p_c) { r_sheet.add(p_a, p_b, p_c); });
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "editor/ground_picker.h"

#include "physics/ground_rays.h"
#include "shared/convert.h"

#include <godot_cpp/classes/sub_viewport_container.hpp>
#include <godot_cpp/classes/viewport.hpp>

#include <cmath>
#include <limits>

using namespace godot;

namespace grass {

namespace {

// Returns the scale for views at half resolution, which draw fewer pixels than the mouse moves over.
real_t shrink_of(const Camera3D *p_camera) {
	const SubViewportContainer *container = Object::cast_to<SubViewportContainer>(p_camera->get_viewport()->get_parent());
	return container == nullptr ? real_t(1) : real_t(container->get_stretch_shrink());
}

GroundRays rays_in(const PaintedFields &p_painted) {
	GroundRays rays(p_painted.chosen->get_world_3d(), to_godot(Eigen::Affine3d(p_painted.space)));
	rays.stand(*p_painted.chosen);
	return rays;
}

} // namespace

std::optional<GroundPoint> pick_ground(const PaintedFields &p_painted, const Camera3D *p_camera, const Vector2 &p_mouse, double p_margin) {
	const Vector2 pixel = p_mouse / shrink_of(p_camera);
	const Eigen::Isometry3d to_space = p_painted.space.inverse();
	const Eigen::Vector3d eye = to_eigen(p_camera->project_ray_origin(pixel)), way = to_eigen(p_camera->project_ray_normal(pixel));
	const auto is_within = [&](const GrassField &p_field, const Eigen::Vector3d &p_local) {
		const Eigen::Array2d limit = 0.5 * to_eigen(p_field.get_size()).array() + p_margin;
		return p_local.allFinite() && std::abs(p_local.x()) <= limit.x() && std::abs(p_local.z()) <= limit.y();
	};

	GroundRays rays = rays_in(p_painted);
	if (const auto hit = rays.cast(to_space * eye, to_space * Eigen::Vector3d(eye + double(p_camera->get_far()) * way))) {
		for (const GrassField *field : p_painted.fields) {
			if (is_within(*field, to_field_of(*field) * p_painted.space * *hit)) {
				return GroundPoint{ *hit, true };
			}
		}
	}
	double nearest = std::numeric_limits<double>::infinity(); // along the ray, to the plane y = 0 of a field
	for (const GrassField *field : p_painted.fields) {
		const Eigen::Isometry3d to_field = to_field_of(*field);
		const double distance = -(to_field * eye).y() / (to_field.linear() * way).y();
		if (distance > 0.0 && distance < nearest && is_within(*field, to_field * Eigen::Vector3d(eye + distance * way))) {
			nearest = distance;
		}
	}
	if (!std::isfinite(nearest)) {
		return {};
	}
	return GroundPoint{ to_space * Eigen::Vector3d(eye + nearest * way), false };
}

std::vector<Eigen::Vector3d> drape(
		const PaintedFields &p_painted, const GroundPoint &p_centre, std::span<const Eigen::Vector2d> p_places, double p_radius) {
	GroundRays rays = rays_in(p_painted);
	const double level = p_centre.position.y(), span = search_height(p_radius);
	std::vector<Eigen::Vector3d> points;
	for (const Eigen::Vector2d &place : p_places) {
		const double height = p_centre.on_body ? rays.height_at(place, level - span, level + span) : level;
		points.push_back({ place.x(), std::isfinite(height) ? height : level, place.y() });
	}
	return points;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "editor/ground_picker.h"

#include "convert.h"
#include "nodes/ground_rays.h"

#include <godot_cpp/classes/sub_viewport_container.hpp>
#include <godot_cpp/classes/viewport.hpp>

#include <cmath>

using namespace godot;

namespace grass {

namespace {

// Half-resolution views draw fewer pixels than the mouse moves over.
real_t shrink_of(const Camera3D *p_camera) {
	const SubViewportContainer *container = Object::cast_to<SubViewportContainer>(p_camera->get_viewport()->get_parent());
	return container == nullptr ? real_t(1) : real_t(container->get_stretch_shrink());
}

} // namespace

std::optional<GroundPoint> pick_ground(const GrassField *p_field, const Camera3D *p_camera, const Vector2 &p_mouse, double p_margin) {
	const Vector2 pixel = p_mouse / shrink_of(p_camera);
	const Eigen::Isometry3d to_field(to_eigen(p_field->field_transform()).inverse(Eigen::Isometry).matrix());
	const Eigen::Vector3d eye = to_field * to_eigen(p_camera->project_ray_origin(pixel));
	const Eigen::Vector3d way = to_field.linear() * to_eigen(p_camera->project_ray_normal(pixel));
	const Eigen::Array2d limit = 0.5 * to_eigen(p_field->get_size()).array() + p_margin;
	const auto within = [&](const GroundPoint &p_point) { return (p_point.place().array().abs() <= limit).all(); };

	GroundRays rays(p_field->get_world_3d(), p_field->field_transform());
	if (const auto hit = rays.cast(eye, eye + double(p_camera->get_far()) * way)) {
		const GroundPoint point{ *hit, true };
		if (within(point)) {
			return point;
		}
	}
	const double distance = -eye.y() / way.y(); // along the ray, to y = 0
	const GroundPoint point{ eye + distance * way, false };
	if (!(distance > 0.0) || !point.position.allFinite() || !within(point)) {
		return {};
	}
	return point;
}

std::vector<Eigen::Vector3d> drape(
		const GrassField *p_field, const GroundPoint &p_centre, std::span<const Eigen::Vector2d> p_places, double p_radius) {
	GroundRays rays(p_field->get_world_3d(), p_field->field_transform());
	const double level = p_centre.position.y(), span = search_height(p_radius);
	std::vector<Eigen::Vector3d> points;
	for (const Eigen::Vector2d &place : p_places) {
		const double height = p_centre.on_body ? rays.height_at(place, level - span, level + span) : level;
		points.push_back({ place.x(), std::isfinite(height) ? height : level, place.y() });
	}
	return points;
}

} // namespace grass

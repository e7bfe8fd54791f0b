// SPDX-License-Identifier: MIT
#include "editor/ground_picker.h"

#include "physics/ground_rays.h"
#include "shared/convert.h"

#include <godot_cpp/classes/sub_viewport_container.hpp>
#include <godot_cpp/classes/viewport.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace godot;

namespace grass {

namespace {

constexpr int MOST_PASSED = 64; // faces of bodies between the eye and the ground
constexpr double BEHIND = 0.001; // metres behind a face that was passed

// Returns the scale for views at half resolution, which draw fewer pixels than the mouse moves over.
real_t shrink_of(const Camera3D *p_camera) {
	const SubViewportContainer *container = Object::cast_to<SubViewportContainer>(p_camera->get_viewport()->get_parent());
	return container == nullptr ? real_t(1) : real_t(container->get_stretch_shrink());
}

GroundRays rays_in(const PaintedFields &p_painted) {
	GroundRays rays(p_painted.chosen->get_world_3d(), to_godot(Eigen::Affine3d(p_painted.space)));
	rays.stand(*p_painted.chosen);
	FieldGround ground = p_painted.fields[0]->get_parts().settings.get_ground_band();
	for (const GrassField *field : p_painted.fields) {
		ground = field->get_parts().settings.get_ground_band().joined(ground);
	}
	rays.keep_within(ground);
	return rays;
}

bool is_ground_here(const PaintedFields &p_painted, const Eigen::Vector3d &p_place, double p_margin) {
	return std::ranges::any_of(p_painted.fields,
			[&](const GrassField *p_field) { return is_ground_of(*p_field, to_field_of(*p_field) * p_painted.space * p_place, p_margin); });
}

// Returns whether a place is on the field's plane, but for rounding.
bool is_on_plane(const GrassField &p_field, const Eigen::Vector3d &p_place, double p_margin) {
	return is_ground_of(p_field, { p_place.x(), 0.0, p_place.z() }, p_margin);
}

// Returns where the ray first hits ground of a field. A body is passed only if some field has a band: what is beyond it, such as the roof
// of a cave, does not hide its ground. p_from, p_way: in PaintedFields::space.
std::optional<Eigen::Vector3d> hit_ground(
		const PaintedFields &p_painted, const Eigen::Vector3d &p_from, const Eigen::Vector3d &p_way, double p_far, double p_margin) {
	GroundRays rays = rays_in(p_painted);
	const bool has_bands = std::ranges::any_of(
			p_painted.fields, [](const GrassField *p_field) { return !p_field->get_parts().settings.get_ground_band().is_whole(); });
	double from = 0.0;
	for (int i = 0; i < (has_bands ? MOST_PASSED : 1); i++) {
		const auto hit = rays.cast(p_from + from * p_way, p_from + p_far * p_way);
		if (!hit || is_ground_here(p_painted, *hit, p_margin)) {
			return hit;
		}
		from = (*hit - p_from).norm() + BEHIND;
	}
	return {};
}

} // namespace

std::optional<GroundPoint> pick_ground(const PaintedFields &p_painted, const Camera3D *p_camera, const Vector2 &p_mouse, double p_margin) {
	const Vector2 pixel = p_mouse / shrink_of(p_camera);
	const Eigen::Isometry3d to_space = p_painted.space.inverse();
	const Eigen::Vector3d eye = to_eigen(p_camera->project_ray_origin(pixel)), way = to_eigen(p_camera->project_ray_normal(pixel));
	if (const auto hit = hit_ground(p_painted, to_space * eye, to_space.linear() * way, double(p_camera->get_far()), p_margin)) {
		return GroundPoint{ *hit, true };
	}
	double nearest = std::numeric_limits<double>::infinity(); // along the ray, to the plane y = 0 of a field
	for (const GrassField *field : p_painted.fields) {
		const Eigen::Isometry3d to_field = to_field_of(*field);
		const double distance = -(to_field * eye).y() / (to_field.linear() * way).y();
		if (distance > 0.0 && distance < nearest && is_on_plane(*field, to_field * Eigen::Vector3d(eye + distance * way), p_margin)) {
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

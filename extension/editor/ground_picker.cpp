// SPDX-License-Identifier: MIT
#include "editor/ground_picker.h"

#include "convert.h"

#include <godot_cpp/classes/character_body3d.hpp>
#include <godot_cpp/classes/physics_direct_space_state3d.hpp>
#include <godot_cpp/classes/physics_ray_query_parameters3d.hpp>
#include <godot_cpp/classes/rigid_body3d.hpp>
#include <godot_cpp/classes/sub_viewport_container.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

constexpr int MAX_BODIES = 16; // that move about, one behind the other on a ray

// The first body on the way that is ground.
std::optional<Vector3> cast(const GrassField *p_field, const Vector3 &p_from, const Vector3 &p_to) {
	PhysicsDirectSpaceState3D *space = p_field->get_world_3d()->get_direct_space_state();
	if (space == nullptr || !p_from.is_finite() || !p_to.is_finite()) {
		return {};
	}
	const Ref<PhysicsRayQueryParameters3D> query = PhysicsRayQueryParameters3D::create(p_from, p_to);
	TypedArray<RID> passed;
	for (int i = 0; i < MAX_BODIES; i++) {
		const Dictionary hit = space->intersect_ray(query);
		if (hit.is_empty()) {
			return {};
		}
		Object *body = hit["collider"];
		if (!Object::cast_to<RigidBody3D>(body) && !Object::cast_to<CharacterBody3D>(body)) {
			return Vector3(hit["position"]);
		}
		passed.push_back(hit["rid"]);
		query->set_exclude(passed);
	}
	return {};
}

// Half-resolution views draw fewer pixels than the mouse moves over.
real_t shrink_of(const Camera3D *p_camera) {
	const SubViewportContainer *container = Object::cast_to<SubViewportContainer>(p_camera->get_viewport()->get_parent());
	return container == nullptr ? real_t(1) : real_t(container->get_stretch_shrink());
}

} // namespace

std::optional<GroundPoint> pick_ground(const GrassField *p_field, const Camera3D *p_camera, const Vector2 &p_mouse, double p_margin) {
	const Vector2 pixel = p_mouse / shrink_of(p_camera);
	const Vector3 from = p_camera->project_ray_origin(pixel), direction = p_camera->project_ray_normal(pixel);
	const Eigen::Isometry3d field(to_eigen(p_field->field_transform()).matrix());
	const Eigen::Array2d limit = 0.5 * to_eigen(p_field->get_size()).array() + p_margin;
	const auto within = [&](const GroundPoint &p_point) { return (p_point.place().array().abs() <= limit).all(); };

	if (const auto hit = cast(p_field, from, from + direction * real_t(p_camera->get_far()))) {
		const GroundPoint point{ field.inverse() * to_eigen(*hit), true };
		if (within(point)) {
			return point;
		}
	}
	const Eigen::Vector3d eye = field.inverse() * to_eigen(from), way = field.linear().transpose() * to_eigen(direction);
	const double distance = -eye.y() / way.y(); // along the ray, to y = 0
	const GroundPoint point{ eye + distance * way, false };
	if (!(distance > 0.0) || !point.position.allFinite() || !within(point)) {
		return {};
	}
	return point;
}

std::vector<Eigen::Vector3d> drape(
		const GrassField *p_field, const GroundPoint &p_centre, std::span<const Eigen::Vector2d> p_places, double p_radius) {
	const Eigen::Isometry3d field(to_eigen(p_field->field_transform()).matrix());
	const double reach = 2.0 * p_radius + 1.0; // metres up and down: the ground may be as steep as 60 degrees
	std::vector<Eigen::Vector3d> points;
	for (const Eigen::Vector2d &place : p_places) {
		Eigen::Vector3d point(place.x(), p_centre.position.y(), place.y());
		if (p_centre.on_body) {
			const Eigen::Vector3d up(0.0, reach, 0.0);
			if (const auto hit = cast(
						p_field, to_godot(Eigen::Vector3d(field * (point + up))), to_godot(Eigen::Vector3d(field * (point - up))))) {
				point = field.inverse() * to_eigen(*hit);
			}
		}
		points.push_back(point);
	}
	return points;
}

} // namespace grass

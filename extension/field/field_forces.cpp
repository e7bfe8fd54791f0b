// SPDX-License-Identifier: MIT
#include "field/field_forces.h"

#include "resources/grass_force_3d.h"
#include "shared/convert.h"
#include "shared/params.h"

#include <godot_cpp/classes/world3d.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

void FieldForces::blast(const Vector3 &p_place, double p_speed, double p_radius, double p_duration) {
	_host.stir();
	ERR_FAIL_COND_MSG(!p_place.is_finite(), _host.message("blast() needs a finite position."));
	Force force;
	force.place = to_eigen(p_place);
	add_push(force, p_speed, p_radius, p_duration);
}

void FieldForces::push(const Vector3 &p_place, const Vector3 &p_velocity, double p_radius, double p_duration) {
	_host.stir();
	ERR_FAIL_COND_MSG(
			!p_place.is_finite() || !p_velocity.is_finite(), _host.message("push() needs a finite position and a finite velocity."));
	Force force;
	force.kind = ForceKind::WIND;
	force.place = to_eigen(p_place);
	force.direction = to_eigen(p_velocity);
	add_push(force, p_velocity.length(), p_radius, p_duration);
}

void FieldForces::add_push(Force &r_force, double p_speed, double p_radius, double p_duration) {
	r_force.speed = checked(FORCE_SPEED, p_speed, _host.label());
	r_force.radius = checked(FORCE_RADIUS, p_radius, _host.label());
	r_force.duration = checked(FORCE_DURATION, p_duration, _host.label());
	r_force.sanitise();
	_pushes.push_back(r_force);
}

void FieldForces::pass(double p_delta) {
	_areas.pass(p_delta);
	for (Force &push : _pushes) {
		push.age += p_delta;
	}
	std::erase_if(_pushes, [](const Force &p_push) { return p_push.is_over(); });
}

void FieldForces::add(const Force &p_force, const Transform3D &p_to_field, const Vector2 &p_size) {
	Force force = p_force;
	force.place = to_eigen(p_to_field.xform(to_godot(p_force.place)));
	force.direction = to_eigen(p_to_field.basis.xform(to_godot(p_force.direction)));
	force.sanitise();
	const bool reaches =
			std::abs(force.place.x()) < 0.5 * p_size.x + force.radius && std::abs(force.place.z()) < 0.5 * p_size.y + force.radius;
	if (reaches && force.speed_now() != 0.0) {
		_forces.push_back(force);
	}
}

void FieldForces::gather(const Vector2 &p_size) {
	_forces.clear();
	_left_out = 0;
	if (_pushes.empty() && _areas.is_empty() && !GrassForce3D::is_any_in_tree()) {
		return;
	}
	const Transform3D to_field = _host.drawn_transform().affine_inverse();
	for (const Force &push : _pushes) {
		add(push, to_field, p_size);
	}
	for (const Force &wind : _areas.get_forces()) {
		add(wind, to_field, p_size);
	}
	const Ref<World3D> world = _host.node().get_world_3d();
	for (GrassForce3D *node : GrassForce3D::get_blowing()) {
		if (node->get_world_3d() == world) {
			add(node->get_force(), to_field, p_size);
		}
	}
	if (_forces.size() > GRASS_MAX_FORCES) {
		std::ranges::stable_sort(
				_forces, std::greater(), [](const Force &p_force) { return std::abs(p_force.speed_now()) * p_force.radius; });
		_left_out = int(_forces.size()) - GRASS_MAX_FORCES;
		_forces.resize(GRASS_MAX_FORCES);
	}
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "resources/grass_force_3d.h"

#include "shared/bind_property.h"
#include "shared/convert.h"
#include "shared/main_thread.h"
#include "shared/params.h"
#include "shared/property_value.h"

#include <godot_cpp/classes/sphere_shape3d.hpp>

using namespace godot;

namespace grass {

namespace {

const Color FORCE_COLOR(0.55f, 0.85f, 0.95f);

} // namespace

std::vector<GrassForce3D *> GrassForce3D::get_blowing() {
	std::vector<GrassForce3D *> blowing = _nodes.get_all<GrassForce3D>();
	std::erase_if(blowing, [](const GrassForce3D *p_force) { return !p_force->is_blowing(); });
	return blowing;
}

Force GrassForce3D::get_force() {
	Force force = _force;
	const Transform3D transform = get_global_transform_interpolated();
	force.place = to_eigen(transform.origin);
	force.direction = to_eigen(-transform.basis.get_column(2));
	force.duration = force.kind == ForceKind::BLAST ? _duration : 0.0;
	force.sanitise();
	return force;
}

void GrassForce3D::set_kind(Kind p_kind) {
	ERR_FAIL_INDEX_MSG(int64_t(p_kind), int64_t(KIND_WIND) + 1, label() + String(": `kind` must be one of the constants KIND_*."));
	if (!replace(_force.kind, ForceKind(p_kind))) {
		return;
	}
	_force.age = 0.0;
	_is_fired = false;
	update_configuration_warnings();
	notify_property_list_changed(); // last, since a listener may free the node
}

void GrassForce3D::set_speed(double p_speed) {
	_force.speed = checked(FORCE_SPEED, p_speed, label());
}

void GrassForce3D::set_radius(double p_radius) {
	if (replace(_force.radius, checked(FORCE_RADIUS, p_radius, label()))) {
		update_picture();
	}
}

void GrassForce3D::set_duration(double p_duration) {
	_duration = checked(FORCE_DURATION, p_duration, label());
}

void GrassForce3D::set_turbulence(double p_turbulence) {
	_force.turbulence = checked(FORCE_TURBULENCE, p_turbulence, label());
}

void GrassForce3D::set_enabled(bool p_enabled) {
	_force.age = p_enabled && !_enabled ? 0.0 : _force.age;
	_enabled = p_enabled;
	update_configuration_warnings();
}

void GrassForce3D::fire() {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_COND_MSG(!is_inside_tree(), label() + String(": add the node to the scene tree before fire()."));
	ERR_FAIL_COND_MSG(_force.kind != ForceKind::BLAST, label() + String(": fire() is for `kind` Blast. Other kinds blow while `enabled`."));
	_force.age = 0.0;
	_is_fired = _enabled;
}

bool GrassForce3D::is_blowing() const {
	return _enabled && is_inside_tree() && is_visible_in_tree() && (_force.kind != ForceKind::BLAST || _is_fired);
}

PackedStringArray GrassForce3D::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (_force.kind == ForceKind::BLAST && _enabled) {
		warnings.push_back("A blast blows once, when a script calls fire(). The other kinds blow all the time.");
	}
	return warnings;
}

void GrassForce3D::_notification(int p_what) {
	if (_nodes.notify(*this, p_what, _picture)) {
		_force.age = 0.0;
		set_physics_process_internal(true);
		update_picture();
	} else if (p_what == NOTIFICATION_EXIT_WORLD) {
		set_physics_process_internal(false);
		_is_fired = false;
	} else if (p_what == NOTIFICATION_INTERNAL_PHYSICS_PROCESS) {
		_force.age += get_physics_process_delta_time();
		_is_fired = _is_fired && _force.age < _duration;
	}
}

void GrassForce3D::update_picture() {
	const auto make = [this] {
		Ref<SphereShape3D> sphere;
		sphere.instantiate();
		sphere->set_radius(real_t(_force.radius));
		return sphere->get_debug_mesh();
	};
	_nodes.show(*this, make, FORCE_COLOR, _picture);
}

void GrassForce3D::_validate_property(PropertyInfo &p_property) const {
	const bool is_blast = _force.kind == ForceKind::BLAST;
	if ((p_property.name == StringName("duration") && !is_blast) || (p_property.name == StringName("turbulence") && is_blast)) {
		p_property.usage = PROPERTY_USAGE_STORAGE;
	}
}

void GrassForce3D::_bind_methods() {
	GRASS_BIND_PROPERTY(GrassForce3D, PropertyInfo(Variant::BOOL, "enabled"), set_enabled, is_enabled);
	GRASS_BIND_PROPERTY(
			GrassForce3D, PropertyInfo(Variant::INT, "kind", PROPERTY_HINT_ENUM, "Blast,Downwash,Vortex,Wind"), set_kind, get_kind);
	GRASS_BIND_PROPERTY(GrassForce3D, property_of(FORCE_SPEED), set_speed, get_speed);
	GRASS_BIND_PROPERTY(GrassForce3D, property_of(FORCE_RADIUS), set_radius, get_radius);
	GRASS_BIND_PROPERTY(GrassForce3D, property_of(FORCE_DURATION), set_duration, get_duration);
	GRASS_BIND_PROPERTY(GrassForce3D, property_of(FORCE_TURBULENCE), set_turbulence, get_turbulence);
	ClassDB::bind_method(D_METHOD("fire"), &GrassForce3D::fire);
	ClassDB::bind_method(D_METHOD("is_blowing"), &GrassForce3D::is_blowing);
	BIND_ENUM_CONSTANT(KIND_BLAST);
	BIND_ENUM_CONSTANT(KIND_DOWNWASH);
	BIND_ENUM_CONSTANT(KIND_VORTEX);
	BIND_ENUM_CONSTANT(KIND_WIND);
}

} // namespace grass

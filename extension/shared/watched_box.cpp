// SPDX-License-Identifier: MIT
#include "shared/watched_box.h"

#include <godot_cpp/classes/physics_server3d.hpp>

using namespace godot;

namespace grass {

void WatchedBox::start(const RID &p_space, uint32_t p_mask, const Callable &p_changed, const Callable &p_area_changed) {
	stop();
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	_shape = server->box_shape_create();
	_area = server->area_create();
	server->area_add_shape(_area, _shape);
	server->area_set_collision_layer(_area, 0);
	server->area_set_collision_mask(_area, p_mask);
	server->area_set_monitorable(_area, false);
	server->area_set_monitor_callback(_area, p_changed);
	if (p_area_changed.is_valid()) {
		server->area_set_area_monitor_callback(_area, p_area_changed);
	}
	server->area_set_space(_area, p_space);
}

void WatchedBox::stop() {
	if (is_watching()) {
		PhysicsServer3D::get_singleton()->free_rid(_area);
		PhysicsServer3D::get_singleton()->free_rid(_shape);
	}
	*this = WatchedBox();
}

void WatchedBox::place(const Transform3D &p_transform, const Vector3 &p_half_extents) {
	if (!is_watching()) {
		return;
	}
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	if (_half_extents != p_half_extents) {
		_half_extents = p_half_extents;
		server->shape_set_data(_shape, p_half_extents);
	}
	if (_transform != p_transform) {
		_transform = p_transform;
		server->area_set_transform(_area, p_transform);
	}
}

void WatchedBox::set_mask(uint32_t p_mask) {
	if (is_watching()) {
		PhysicsServer3D::get_singleton()->area_set_collision_mask(_area, p_mask);
	}
}

} // namespace grass

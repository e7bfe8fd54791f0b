// SPDX-License-Identifier: MIT
#include "shared/shared_area.h"

#include "shared/convert.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Boxes in an area. More: one that comes or goes makes the server find all bodies in more of them anew.
constexpr int BOXES_MAX = 64;
// An area covers at most so many times the volume of its boxes. More: the server tests bodies between the boxes, in every tick. Less:
// neighbours share fewer areas.
constexpr double MOST_SPREAD = 2.0;

std::vector<uint64_t> areas; // instance ids, in the order in which they were made

} // namespace

Eigen::AlignedBox3d box_around(const Transform3D &p_transform, const Vector3 &p_half_extents) {
	const Eigen::Affine3d place = to_eigen(p_transform);
	const Eigen::Vector3d half = place.linear().cwiseAbs() * to_eigen(p_half_extents);
	return { Eigen::Vector3d(place.translation() - half), Eigen::Vector3d(place.translation() + half) };
}

SharedArea::~SharedArea() {
	std::erase(areas, _id);
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	if (_area.is_valid()) {
		server->free_rid(_area);
	}
	for (const Box &box : _boxes) {
		server->free_rid(box.shape);
	}
}

int64_t SharedArea::get_count() {
	return int64_t(areas.size());
}

Ref<SharedArea> SharedArea::find(const Kind &p_kind, const Transform3D &p_transform, const Vector3 &p_half_extents) {
	const Eigen::AlignedBox3d box = box_around(p_transform, p_half_extents);
	for (const uint64_t id : areas) {
		SharedArea *area = Object::cast_to<SharedArea>(ObjectDB::get_instance(id));
		if (area != nullptr && p_kind.sees_areas && area->_kind == p_kind && area->has_room(box)) {
			return Ref<SharedArea>(area);
		}
	}
	return make(p_kind, p_transform);
}

Ref<SharedArea> SharedArea::make(const Kind &p_kind, const Transform3D &p_transform) {
	Ref<SharedArea> area;
	area.instantiate();
	area->start(p_kind, p_transform);
	return area;
}

void SharedArea::start(const Kind &p_kind, const Transform3D &p_transform) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	_id = get_instance_id();
	areas.push_back(_id);
	_kind = p_kind;
	_place = p_transform;
	_area = server->area_create();
	server->area_set_collision_layer(_area, 0);
	server->area_set_collision_mask(_area, p_kind.mask);
	server->area_set_monitorable(_area, false);
	server->area_set_monitor_callback(_area, callable_mp(this, &SharedArea::_changed));
	if (p_kind.sees_areas) {
		server->area_set_area_monitor_callback(_area, callable_mp(this, &SharedArea::_area_changed));
	}
	server->area_set_transform(_area, _place);
	server->area_set_space(_area, p_kind.space);
}

Eigen::AlignedBox3d SharedArea::find_bounds(double &r_volume) const {
	Eigen::AlignedBox3d bounds;
	r_volume = 0.0;
	for (const Box &box : _boxes) {
		if (box.is_used) {
			const Eigen::AlignedBox3d around = box_around(_place * box.local, box.half_extents);
			bounds.extend(around);
			r_volume += around.volume();
		}
	}
	return bounds;
}

bool SharedArea::has_room(const Eigen::AlignedBox3d &p_box) const {
	if (_has_moved || _used >= BOXES_MAX) {
		return false;
	}
	double volume = 0.0;
	const Eigen::AlignedBox3d bounds = find_bounds(volume);
	return bounds.merged(p_box).volume() <= MOST_SPREAD * (volume + p_box.volume());
}

int SharedArea::add(const Transform3D &p_transform, const Vector3 &p_half_extents, const Listener &p_listener) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const Transform3D local = _place.affine_inverse() * p_transform;
	_used++;
	const auto unused = std::ranges::find_if(_boxes, [](const Box &p_box) { return !p_box.is_used && p_box.overlaps == 0; });
	if (unused != _boxes.end()) {
		const int index = int(unused - _boxes.begin());
		*unused = { .shape = unused->shape, .local = local, .half_extents = p_half_extents, .listener = p_listener };
		server->shape_set_data(unused->shape, p_half_extents);
		server->area_set_shape_transform(_area, index, local);
		server->area_set_shape_disabled(_area, index, false);
		return index;
	}
	const RID shape = server->box_shape_create();
	server->shape_set_data(shape, p_half_extents);
	server->area_add_shape(_area, shape, local);
	_boxes.push_back({ .shape = shape, .local = local, .half_extents = p_half_extents, .listener = p_listener });
	return int(_boxes.size()) - 1;
}

// Removes a box. It stays in the list, so that the indices of others do not change, and is used again once all bodies have left it.
void SharedArea::remove(int p_box, bool p_tells) {
	Box &box = _boxes[size_t(p_box)];
	box.is_used = false;
	_used--;
	box.is_told = p_tells;
	box.listener = p_tells ? box.listener : Listener();
	_self = has_to_tell() ? Ref<SharedArea>(this) : _self;
	PhysicsServer3D::get_singleton()->area_set_shape_disabled(_area, p_box, true);
}

void SharedArea::move(int p_box, const Transform3D &p_transform) {
	_has_moved = true;
	_place = p_transform * _boxes[size_t(p_box)].local.affine_inverse();
	PhysicsServer3D::get_singleton()->area_set_transform(_area, _place);
}

void SharedArea::resize(int p_box, const Vector3 &p_half_extents) {
	_boxes[size_t(p_box)].half_extents = p_half_extents;
	PhysicsServer3D::get_singleton()->shape_set_data(_boxes[size_t(p_box)].shape, p_half_extents);
}

bool SharedArea::has_to_tell() const {
	return std::ranges::any_of(_boxes, [](const Box &p_box) { return !p_box.is_used && p_box.is_told && p_box.overlaps > 0; });
}

// Releases the area later, since the server is going through its areas now.
void SharedArea::_let_go() {
	_self = has_to_tell() ? _self : Ref<SharedArea>(); // nothing may follow this
}

// Returns the listener of the box with this index.
SharedArea::Listener SharedArea::count(int64_t p_status, int64_t p_box) {
	if (p_box < 0 || size_t(p_box) >= _boxes.size()) {
		return {};
	}
	Box &box = _boxes[size_t(p_box)];
	box.overlaps += p_status == PhysicsServer3D::AREA_BODY_ADDED ? 1 : -1;
	if (_self.is_valid() && box.overlaps == 0) {
		callable_mp(this, &SharedArea::_let_go).call_deferred();
	}
	return box.listener;
}

void SharedArea::_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id, int64_t p_body_shape, int64_t p_box) {
	if (const Callable changed = count(p_status, p_box).changed; changed.is_valid()) {
		changed.call(p_status, p_body, p_instance_id, p_body_shape, p_box);
	}
}

void SharedArea::_area_changed(int64_t p_status, const RID &p_area, int64_t p_instance_id, int64_t p_area_shape, int64_t p_box) {
	if (const Callable changed = count(p_status, p_box).area_changed; changed.is_valid()) {
		changed.call(p_status, p_area, p_instance_id, p_area_shape, p_box);
	}
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "physics/vehicle_wheels.h"

#include <godot_cpp/classes/cylinder_shape3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/classes/vehicle_body3d.hpp>
#include <godot_cpp/core/object.hpp>

#include <numbers>

using namespace godot;

namespace grass {

namespace {

// Width of a wheel as a share of its radius, since wheels have no width: typical for cars.
constexpr double WHEEL_WIDTH = 0.6;
// Least slip that leaves a track: rolling wheels report some hundredths.
constexpr double LEAST_SLIP = 0.1;

} // namespace

void VehicleWheels::body_changed(int64_t p_status, int64_t p_instance_id) {
	const uint64_t id = uint64_t(p_instance_id);
	const bool is_added = p_status == PhysicsServer3D::AREA_BODY_ADDED;
	auto found = _vehicles.find(id);
	if (found == _vehicles.end()) {
		if (!is_added || Object::cast_to<VehicleBody3D>(ObjectDB::get_instance(id)) == nullptr) {
			return;
		}
		found = _vehicles.emplace(id, Vehicle()).first;
		add_wheels(found->second, id);
	}
	found->second.overlaps += is_added ? 1 : -1;
}

// Drops vehicles that have left. One whose shapes the server counts again leaves and enters in the same tick, and its wheels roll on.
void VehicleWheels::drop_left() {
	std::erase_if(_vehicles, [this](const auto &p_entry) {
		if (p_entry.second.overlaps > 0) {
			return false;
		}
		for (const uint64_t wheel : p_entry.second.wheels) {
			_colliders.remove(wheel);
		}
		return true;
	});
}

void VehicleWheels::add_wheels(Vehicle &r_vehicle, uint64_t p_vehicle) {
	const Node *vehicle = Object::cast_to<Node>(ObjectDB::get_instance(p_vehicle));
	for (int i = 0; i < vehicle->get_child_count(); i++) {
		const VehicleWheel3D *wheel = Object::cast_to<VehicleWheel3D>(vehicle->get_child(i));
		if (wheel == nullptr) {
			continue;
		}
		Ref<CylinderShape3D> shape;
		shape.instantiate();
		shape->set_radius(wheel->get_radius());
		shape->set_height(float(WHEEL_WIDTH * wheel->get_radius()));
		const Eigen::AngleAxisd along_axle(0.5 * std::numbers::pi, Eigen::Vector3d::UnitZ()); // a cylinder's axis is vertical
		if (_colliders.add(wheel, shape, Eigen::Affine3d(along_axle), p_vehicle)) {
			r_vehicle.wheels.push_back(wheel->get_instance_id());
		}
	}
}

void VehicleWheels::clear() {
	_vehicles.clear();
	_colliders.clear();
}

void VehicleWheels::collect(const FieldReach &p_reach, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders) {
	drop_left();
	_colliders.collect(p_reach, p_tick, r_colliders);
}

std::vector<VehicleWheels::Slip> VehicleWheels::find_slips() const {
	std::vector<Slip> slips;
	for (const auto &[id, vehicle] : _vehicles) {
		for (const uint64_t wheel_id : vehicle.wheels) {
			const VehicleWheel3D *wheel = Object::cast_to<VehicleWheel3D>(ObjectDB::get_instance(wheel_id));
			if (wheel == nullptr || !wheel->is_inside_tree() || !wheel->is_in_contact()) {
				continue;
			}
			const double share = 1.0 - wheel->get_skidinfo();
			if (share > LEAST_SLIP) {
				slips.push_back({ wheel->get_contact_point(), 0.5 * WHEEL_WIDTH * wheel->get_radius(), share });
			}
		}
	}
	return slips;
}

} // namespace grass

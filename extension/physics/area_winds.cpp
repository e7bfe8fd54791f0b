// SPDX-License-Identifier: MIT
#include "physics/area_winds.h"

#include "physics/physics_shapes.h"
#include "shared/convert.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/object.hpp>

#include <cmath>

using namespace godot;

namespace grass {

namespace {

const Area3D *find_area(uint64_t p_id) {
	const Area3D *area = Object::cast_to<Area3D>(ObjectDB::get_instance(p_id));
	return area != nullptr && area->is_inside_tree() ? area : nullptr;
}

// Returns a box around its shapes, global; empty if none has an inside.
Eigen::AlignedBox3d bounds_of(const Area3D &p_area) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const RID rid = p_area.get_rid();
	Eigen::AlignedBox3d bounds;
	for (int i = 0; i < server->area_get_shape_count(rid); i++) {
		TrackedShape shape;
		read_shape(server->area_get_shape(rid, i), shape);
		for (const ShapePart &part : shape.parts) {
			const Eigen::Affine3d pose =
					to_eigen(p_area.get_global_transform()) * to_eigen(server->area_get_shape_transform(rid, i)) * part.offset;
			const Eigen::Vector3d half = pose.linear().cwiseAbs() * part.shape.get_half_extents();
			bounds.extend(Eigen::Vector3d(pose.translation() - half));
			bounds.extend(Eigen::Vector3d(pose.translation() + half));
		}
	}
	return bounds;
}

// Returns the force of an area with wind; without wind its speed is 0.
Force force_of(const Area3D &p_area) {
	Force force;
	force.kind = ForceKind::WIND;
	force.duration = 0.0;
	force.speed = 0.0;
	const Node3D *source = Object::cast_to<Node3D>(p_area.get_node_or_null(p_area.get_wind_source_path()));
	const Eigen::AlignedBox3d bounds = bounds_of(p_area);
	if (source == nullptr || bounds.isEmpty()) {
		return force;
	}
	force.place = bounds.center();
	force.radius = 0.5 * bounds.diagonal().norm();
	force.direction = to_eigen(-source->get_global_transform().basis.get_column(2));
	// As soft bodies compute it: by the distance from the source along the wind.
	const double way = std::max(force.direction.normalized().dot(force.place - to_eigen(source->get_global_position())), 0.0);
	force.speed = p_area.get_wind_force_magnitude() / std::pow(1.0 + way, double(p_area.get_wind_attenuation_factor()));
	return force;
}

} // namespace

void AreaWinds::area_changed(int64_t p_status, int64_t p_instance_id) {
	const bool is_added = p_status == PhysicsServer3D::AREA_BODY_ADDED;
	Known &known = _areas[uint64_t(p_instance_id)];
	known.overlaps += is_added ? 1 : -1;
}

// Advances by a tick. An area whose shapes the server counts again leaves and enters in the same tick, and its wind blows on.
void AreaWinds::pass(double p_delta) {
	std::erase_if(_areas, [](const auto &p_entry) { return p_entry.second.overlaps <= 0; });
	for (auto &[id, known] : _areas) {
		const Area3D *area = find_area(id);
		known.age = area != nullptr && area->get_wind_force_magnitude() > 0.0f ? known.age + p_delta : 0.0;
	}
}

bool AreaWinds::find_resting(std::vector<RestingBody> &r_areas) const {
	for (const auto &[id, known] : _areas) {
		const Area3D *area = find_area(id);
		if (known.overlaps <= 0 || (area != nullptr && area->get_wind_force_magnitude() > 0.0f)) {
			return false;
		}
		r_areas.push_back({ id, {} });
	}
	return true;
}

std::vector<Force> AreaWinds::get_forces() const {
	std::vector<Force> forces;
	for (const auto &[id, known] : _areas) {
		const Area3D *area = find_area(id);
		if (area != nullptr && area->get_wind_force_magnitude() > 0.0f) {
			forces.push_back(force_of(*area));
			forces.back().age = known.age;
		}
	}
	return forces;
}

} // namespace grass

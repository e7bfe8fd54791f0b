// SPDX-License-Identifier: MIT
#include "physics/ground_rays.h"

#include "shared/convert.h"
#include "shared/plant_group.h"

#include <godot_cpp/classes/animatable_body3d.hpp>
#include <godot_cpp/classes/character_body3d.hpp>
#include <godot_cpp/classes/rigid_body3d.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace godot;

namespace grass {

bool moves_about(const Object *p_body) {
	return Object::cast_to<RigidBody3D>(p_body) || Object::cast_to<CharacterBody3D>(p_body) || Object::cast_to<AnimatableBody3D>(p_body);
}

bool GroundRays::is_ground(const Object *p_body) const {
	const Node *node = Object::cast_to<Node>(p_body);
	if (is_in_plant(p_body) || !is_in_group(node)) {
		return false;
	}
	return !moves_about(p_body) || (_standing != nullptr && node != nullptr && node->is_ancestor_of(const_cast<Node *>(_standing)));
}

// Returns whether a node, or one above it, is in the group: a scene of several bodies is in it by its root.
bool GroundRays::is_in_group(const Node *p_node) const {
	if (String(_ground.group).is_empty()) {
		return true;
	}
	for (const Node *node = p_node; node != nullptr; node = node->get_parent()) {
		if (node->is_in_group(_ground.group)) {
			return true;
		}
	}
	return false;
}

void GroundRays::keep_within(const FieldGround &p_ground) {
	_ground = p_ground;
	_query->set_collision_mask(uint32_t(int64_t(_query->get_collision_mask()) & p_ground.mask));
}

GroundRays::GroundRays(const Ref<World3D> &p_world, const Transform3D &p_field, int64_t p_mask) :
		_field(to_eigen(p_field).matrix()), _to_field(_field.inverse()) {
	_space = p_world.is_valid() ? p_world->get_direct_space_state() : nullptr;
	_query.instantiate();
	_query->set_collision_mask(uint32_t(p_mask));
}

// Returns the first hit that is ground; empty: there is none.
Dictionary GroundRays::find_hit(const Eigen::Vector3d &p_from, const Eigen::Vector3d &p_to) {
	const Vector3 from = to_godot(Eigen::Vector3d(_field * p_from)), to = to_godot(Eigen::Vector3d(_field * p_to));
	if (_space == nullptr || !from.is_finite() || !to.is_finite()) {
		return Dictionary();
	}
	_query->set_from(from);
	_query->set_to(to);
	while (true) {
		Dictionary hit = _space->intersect_ray(_query);
		if (hit.is_empty()) {
			return hit;
		}
		const Object *body = hit["collider"];
		if (is_ground(body)) {
			return hit;
		}
		_passed.push_back(hit["rid"]); // not hit again, so the loop ends
		_query->set_exclude(_passed);
	}
}

std::optional<Eigen::Vector3d> GroundRays::cast(const Eigen::Vector3d &p_from, const Eigen::Vector3d &p_to) {
	const Dictionary hit = find_hit(p_from, p_to);
	return hit.is_empty() ? std::nullopt : std::optional<Eigen::Vector3d>(_to_field * to_eigen(Vector3(hit["position"])));
}

std::optional<GroundRays::Hit> GroundRays::hit_at(const Eigen::Vector2d &p_place) {
	const Dictionary hit = find_hit({ p_place.x(), std::min(GROUND_SEARCH, _ground.high), p_place.y() },
			{ p_place.x(), std::max(-GROUND_SEARCH, _ground.low), p_place.y() });
	return hit.is_empty() ? std::nullopt : std::optional<Hit>({ hit["rid"], hit["shape"] });
}

double GroundRays::height_at(const Eigen::Vector2d &p_place, double p_low, double p_high) {
	const double low = std::max(p_low, _ground.low), high = std::min(p_high, _ground.high);
	if (!(low < high)) {
		return std::numeric_limits<double>::quiet_NaN();
	}
	const auto hit = cast({ p_place.x(), high, p_place.y() }, { p_place.x(), low, p_place.y() });
	return hit ? hit->y() : std::numeric_limits<double>::quiet_NaN();
}

double GroundRays::height_at_corner(const Eigen::Vector2d &p_place, double p_low, double p_high) {
	constexpr double BESIDE = 0.002; // metres
	double height = height_at(p_place, p_low, p_high);
	for (int n = 0; n < 4 && std::isnan(height); n++) {
		height = height_at(p_place + BESIDE * Eigen::Vector2d(n % 2 * 2 - 1, n / 2 * 2 - 1), p_low, p_high);
	}
	return height;
}

} // namespace grass

// SPDX-License-Identifier: MIT
// Finds the ground with rays of the physics server, which hit bodies that do not move about and are no plants.
#pragma once

#include "physics/field_ground.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/physics_direct_space_state3d.hpp>
#include <godot_cpp/classes/physics_ray_query_parameters3d.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <optional>

namespace grass {

// Returns true for rigid bodies, characters and animated bodies, on which grass does not grow.
bool moves_about(const godot::Object *p_body);

class GroundRays {
public:
	// Casts rays below a field. p_field: global, without scale. p_mask: physics layers that are ground.
	GroundRays(const godot::Ref<godot::World3D> &p_world, const godot::Transform3D &p_field, int64_t p_mask = FieldGround::ALL_LAYERS);

	// Sets a node that is on the ground: bodies that carry it are ground, however they move.
	void stand(const godot::Node &p_node) { _standing = &p_node; }
	// Limits what rays find to bodies that are ground, and height_at() to the band.
	void keep_within(const FieldGround &p_ground);
	bool is_usable() const { return _space != nullptr; }
	// Returns where the ray first hits a body that does not move about; field space, metres.
	std::optional<Eigen::Vector3d> cast(const Eigen::Vector3d &p_from, const Eigen::Vector3d &p_to);
	// The shape of the highest ground at a place.
	struct Hit {
		godot::RID body;
		int64_t shape; // number in the body
	};
	std::optional<Hit> hit_at(const Eigen::Vector2d &p_place);
	// Returns the height of the highest ground at a place between two heights, in metres above the field; NaN if there is none.
	double height_at(const Eigen::Vector2d &p_place, double p_low = -GROUND_SEARCH, double p_high = GROUND_SEARCH);
	// Returns the same at a corner of the ground, which a ray may pass where the ground ends.
	double height_at_corner(const Eigen::Vector2d &p_place, double p_low = -GROUND_SEARCH, double p_high = GROUND_SEARCH);

private:
	godot::Dictionary find_hit(const Eigen::Vector3d &p_from, const Eigen::Vector3d &p_to);
	bool is_ground(const godot::Object *p_body) const;
	bool is_in_group(const godot::Node *p_node) const;

	const godot::Node *_standing = nullptr;
	FieldGround _ground;
	godot::PhysicsDirectSpaceState3D *_space = nullptr;
	Eigen::Isometry3d _field, _to_field;
	godot::Ref<godot::PhysicsRayQueryParameters3D> _query;
	godot::TypedArray<godot::RID> _passed; // bodies that move about, found so far
};

} // namespace grass

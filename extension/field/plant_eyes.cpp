// SPDX-License-Identifier: MIT
#include "field/plant_eyes.h"

#include "field/field_view.h"
#include "shared/convert.h"
#include "shared/plant_group.h"
#include "shared/scene_watch.h"

#include <godot_cpp/classes/character_body3d.hpp>
#include <godot_cpp/classes/rigid_body3d.hpp>

#include <algorithm>
#include <limits>

using namespace godot;

namespace grass {

namespace {

// Most eyes, cameras first. More: where a crowd is, its plants are looked for by turns.
constexpr size_t EYES = 32;
// Ticks between two searches for bodies, and how many are looked at then.
constexpr int FIND_BODIES_EVERY = 8;
constexpr size_t BODIES_LOOKED_AT = 512;
// How far around a rigid body plants are there for it, metres: at 200 m/s it moves 3.3 in a tick.
constexpr double BODY_REACH = 4.0;
constexpr double EVERYWHERE = std::numeric_limits<double>::infinity(); // as far as the species' own distance

bool is_awake(const RigidBody3D *p_body) {
	return p_body != nullptr && !p_body->is_sleeping() && !p_body->is_freeze_enabled();
}

} // namespace

// Characters first: a player must not wait for crates.
void PlantEyes::look_for_bodies(const BodyTracker &p_tracker) {
	_next_look = FIND_BODIES_EVERY - 1;
	_bodies.clear();
	std::vector<uint64_t> rigid;
	for (const uint64_t id : p_tracker.find_instances(BODIES_LOOKED_AT)) {
		const Object *body = ObjectDB::get_instance(id);
		if (Object::cast_to<CharacterBody3D>(body) != nullptr && !is_in_plant(body)) {
			_bodies.push_back(id);
		} else if (is_awake(Object::cast_to<RigidBody3D>(body)) && !is_in_plant(body)) {
			rigid.push_back(id);
		}
	}
	_bodies.insert(_bodies.end(), rigid.begin(), rigid.end());
	_bodies.resize(std::min(_bodies.size(), EYES));
}

std::vector<PlantEye> PlantEyes::find(const VisualInstance3D &p_node, const Transform3D &p_transform, const BodyTracker &p_tracker) {
	const Eigen::Affine3d field = to_eigen(p_transform);
	SceneWatch::get_singleton()->start(const_cast<VisualInstance3D *>(&p_node));
	std::vector<PlantEye> eyes;
	for (const Eigen::Vector3d &eye : find_eyes(&p_node, p_node.get_layer_mask(), field)) {
		eyes.push_back({ eye, EVERYWHERE });
	}
	if (_next_look-- <= 0) {
		look_for_bodies(p_tracker);
	}
	for (const uint64_t id : _bodies) {
		const Node3D *body = Object::cast_to<Node3D>(ObjectDB::get_instance(id));
		if (body != nullptr && body->is_inside_tree()) {
			const Eigen::Vector3d place = field.inverse(Eigen::Isometry) * to_eigen(body->get_global_position());
			eyes.push_back({ place, Object::cast_to<CharacterBody3D>(body) != nullptr ? EVERYWHERE : BODY_REACH });
		}
	}
	std::erase_if(eyes, [](const PlantEye &p_eye) { return !p_eye.place.allFinite(); });
	eyes.resize(std::min(eyes.size(), EYES));
	return eyes;
}

} // namespace grass

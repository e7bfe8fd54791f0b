// SPDX-License-Identifier: MIT
#include "physics/resting_bodies.h"

#include <godot_cpp/classes/area3d.hpp>
#include <godot_cpp/classes/collision_object3d.hpp>
#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

bool RestingBody::has_stirred(BodyReads &r_reads) const {
	const Object *found = ObjectDB::get_instance(object);
	r_reads.engine_calls += 2;
	if (const Area3D *area = Object::cast_to<Area3D>(found)) {
		return area->get_wind_force_magnitude() > 0.0f;
	}
	if (const CollisionObject3D *node = Object::cast_to<CollisionObject3D>(found)) {
		r_reads.engine_calls++;
		return !node->is_inside_tree() || node->get_global_transform() != place;
	}
	const PhysicsDirectBodyState3D *state = Object::cast_to<PhysicsDirectBodyState3D>(found);
	return state == nullptr || state->get_transform() != place;
}

void RestingBodies::add(const RestingBody &p_body, uint64_t p_field) {
	_bodies.try_emplace(p_body.object, Watched{ p_body, {} }).first->second.fields.push_back(p_field);
	_of_fields[p_field].push_back(p_body.object);
}

void RestingBodies::remove(uint64_t p_field) {
	const auto found = _of_fields.find(p_field);
	if (found == _of_fields.end()) {
		return;
	}
	for (const uint64_t object : found->second) {
		Watched &watched = _bodies[object];
		std::erase(watched.fields, p_field);
		if (watched.fields.empty()) {
			_bodies.erase(object);
		}
	}
	_of_fields.erase(found);
}

std::vector<uint64_t> RestingBodies::find_stirred(BodyReads &r_reads) {
	std::vector<uint64_t> stirred;
	auto next = _bodies.upper_bound(_last);
	for (size_t i = 0; i < std::min(READS_A_TICK, _bodies.size()); i++) {
		next = next == _bodies.end() ? _bodies.begin() : next;
		if (next->second.body.has_stirred(r_reads)) {
			stirred.insert(stirred.end(), next->second.fields.begin(), next->second.fields.end());
		}
		_last = next->first;
		++next;
	}
	return stirred;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "nodes/field_turns.h"

#include "nodes/field_monitors.h"
#include "nodes/grass_field.h"
#include "shared/script_call.h"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

// Calls p_visit for each field in the tree of which p_is_due is true and that the tree does not pause. Scripts may free any of them.
template <typename IsDue, typename Visit> void visit_fields(IsDue &&p_is_due, Visit &&p_visit) {
	std::vector<uint64_t> due;
	for (const GrassField *field : FieldMonitors::get_fields()) {
		if (p_is_due(*field)) {
			due.push_back(field->get_instance_id());
		}
	}
	for (const uint64_t id : due) {
		GrassField *field = Object::cast_to<GrassField>(ObjectDB::get_instance(id));
		if (field != nullptr && field->can_process()) {
			p_visit(*field);
		}
	}
}

double tree_time(uint64_t p_tree, double (Node::*p_time)() const) {
	const SceneTree *tree = Object::cast_to<SceneTree>(ObjectDB::get_instance(p_tree));
	return tree != nullptr ? (tree->get_root()->*p_time)() : 0.0;
}

} // namespace

FieldTurns *FieldTurns::_singleton = nullptr;

void FieldTurns::free_singleton() {
	if (_singleton != nullptr) {
		memdelete(_singleton);
		_singleton = nullptr;
	}
}

void FieldTurns::start(Node *p_inside) {
	if (_singleton == nullptr) {
		_singleton = memnew(FieldTurns);
	}
	SceneTree *tree = p_inside->get_tree();
	if (tree->get_instance_id() != _singleton->_tree) {
		_singleton->_tree = tree->get_instance_id();
		tree->connect("physics_frame", callable_mp(_singleton, &FieldTurns::_begin_tick));
		tree->connect("process_frame", callable_mp(_singleton, &FieldTurns::_begin_frame));
	}
}

void FieldTurns::remove(const GrassField &p_field) {
	if (_singleton != nullptr) {
		_singleton->_bodies.remove(p_field.get_instance_id());
	}
}

void FieldTurns::_begin_tick() {
	callable_mp(this, &FieldTurns::_tick).call_deferred();
}

void FieldTurns::_begin_frame() {
	callable_mp(this, &FieldTurns::_frame).call_deferred();
}

void FieldTurns::_tick() {
	if (FieldMonitors::get_fields().empty()) {
		return;
	}
	stir_by_bodies();
	stir_by_movers();
	const double delta = tree_time(_tree, &Node::get_physics_process_delta_time);
	visit_fields([](const GrassField &p_field) { return p_field.get_ticks().needs_tick(); },
			[&](GrassField &r_field) {
				const uint64_t id = r_field.get_instance_id();
				_bodies.remove(id);
				if (!outlives(r_field, [&] { r_field.get_ticks().tick(delta); })) {
					return;
				}
				for (const RestingBody &body : r_field.get_ticks().rest()) {
					_bodies.add(body, id);
				}
			});
}

void FieldTurns::_frame() {
	const double delta = tree_time(_tree, &Node::get_process_delta_time);
	visit_fields([](const GrassField &p_field) { return p_field.get_frames().needs_frame(); },
			[&](GrassField &r_field) { r_field.get_frames().frame(delta); });
}

void FieldTurns::stir_by_bodies() {
	BodyReads reads;
	for (const uint64_t id : _bodies.find_stirred(reads)) {
		if (GrassField *field = Object::cast_to<GrassField>(ObjectDB::get_instance(id))) {
			field->stir();
		}
	}
	count(reads);
}

// Counts reads that serve all fields in one of them.
void FieldTurns::count(const BodyReads &p_reads) {
	if (const std::vector<GrassField *> fields = FieldMonitors::get_fields(); !fields.empty()) {
		fields.front()->get_ticks().count_reads(p_reads);
	}
}

void FieldTurns::stir_by_movers() {
	BodyReads reads;
	const std::vector<Mover> movers = _movers.find(reads);
	count(reads);
	if (movers.empty()) {
		return;
	}
	for (GrassField *field : FieldMonitors::get_fields()) {
		if (field->get_ticks().is_stirred_by(movers)) {
			field->stir();
		}
	}
}

} // namespace grass

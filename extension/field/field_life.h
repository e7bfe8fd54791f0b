// SPDX-License-Identifier: MIT
// What a field is on its way to being drawn, from the change of a property to the picture: docs/internals/life_of_a_field.md. Setters only
// ask(); advance() does all of the rest.
#pragma once

#include "core/field/field_statistics.h"
#include "draw/frame_share.h"
#include "field/field_host.h"
#include "field/standing_field.h"
#include "field/wanted_field.h"

#include <godot_cpp/classes/geometry_instance3d.hpp>

#include <memory>

namespace grass {

class FieldLife {
public:
	// Of the field that the properties describe. The one before it stands until this one is made.
	enum class Stage {
		NONE, // the node is not in the tree
		ASKED, // properties changed
		PREPARING, // what they make is known, and is prepared beside what stands
		OUTDATED, // likewise, and properties changed since: it is finished and shown first, so changes in every frame still take effect
		MADE, // it stands, and its picture is made
		SHOWN, // all of it
	};

	FieldLife(FieldHost &p_host, godot::GeometryInstance3D &p_node, FieldProperties &p_properties, StandingField &p_standing) :
			_host(p_host), _node(p_node), _properties(p_properties), _standing(p_standing) {}

	// Asks for the field that the properties describe, however many of them change. It is made as advance() comes to it.
	void ask();
	// Takes a map for the field, prepared by another thread; null: none.
	void offer(std::unique_ptr<ShownMap> p_prepared) { _prepared = std::move(p_prepared); }
	// Takes the field as far as this frame has time for. Returns false if a script that ran meanwhile freed it: use nothing of it then.
	// Call it once a frame.
	[[nodiscard]] bool advance();
	// The same where no field stands yet, for whoever needs one now: a field that enters the tree is made at once, unless it is streamed.
	[[nodiscard]] bool stand() { return _standing.stands() || advance(); }
	void leave(); // the tree

	Stage get_stage() const { return _stage; }
	bool is_waiting() const { return _stage == Stage::ASKED || is_preparing(); }
	ShownMap *get_map() const { return _wanted.map.get(); } // that waits to be shown, or null
	double get_most_ms() const { return _most_ms; } // of one frame, since the last ask()
	int64_t get_memory_usage() const { return get_map() != nullptr ? get_map()->get_memory_usage() : 0; } // bytes
	void add_to(FieldStatistics &r_statistics) const;

private:
	bool is_preparing() const { return _stage == Stage::PREPARING || _stage == Stage::OUTDATED; }
	bool has_time(FrameShare::Turn &r_turn) const;
	bool prepare(FrameShare::Turn &r_turn);
	bool prepare_map(FrameShare::Turn &r_turn);
	[[nodiscard]] bool make();
	void show();

	FieldHost &_host;
	godot::GeometryInstance3D &_node;
	FieldProperties &_properties;
	StandingField &_standing;
	Stage _stage = Stage::NONE;
	WantedField _wanted; // while it is being prepared
	std::unique_ptr<ShownMap> _prepared;
	bool _is_reading = false; // scripts run: one that asks the field finds it as it was
	bool _is_new = false; // warnings of it are to be reported
	double _most_ms = 0.0;
	int64_t _makings = 0; // so far
};

} // namespace grass

// SPDX-License-Identifier: MIT
// The stages of a field from a changed property to its picture (docs/internals/life_of_a_field.md). Setters only call ask(); advance() does
// the rest.
#pragma once

#include "core/field/field_statistics.h"
#include "draw/frame_share.h"
#include "field/field_host.h"
#include "field/standing_field.h"
#include "field/wanted_field.h"

#include <memory>

namespace grass {

class FieldLife {
public:
	// The stage of the field that the properties describe. The previous field stays until this one is made.
	enum class Stage {
		NONE, // the node is not in the tree
		ASKED, // properties changed
		PREPARING, // the wanted field is known, and is prepared in the background
		OUTDATED, // the same, but properties changed since. It is finished and shown first, so changes in every frame still take effect
		MADE, // the field runs, and parts of its picture are still to be made
		SHOWN, // the whole picture is made
	};

	FieldLife(FieldHost &p_host, FieldProperties &p_properties, StandingField &p_standing) :
			_host(p_host), _properties(p_properties), _standing(p_standing) {}

	// Requests the field that the properties describe. Call it once or often after changes; advance() makes the field.
	void ask();
	// Sets a map that another thread has prepared for the field; null: none.
	void offer(std::unique_ptr<ShownMap> p_prepared) { _prepared = std::move(p_prepared); }
	// Advances the field as far as this frame has time. Returns false if a script that ran meanwhile freed the node: do not use it then.
	// Call it once a frame.
	[[nodiscard]] bool advance();
	// Calls advance() if there is no field yet, for a caller that needs one now: a field that enters the tree is made at once, unless it
	// is streamed.
	[[nodiscard]] bool stand() { return _standing.stands() || advance(); }
	void leave(); // call it when the node leaves the tree

	Stage get_stage() const { return _stage; }
	int64_t get_makings() const { return _makings; } // fields so far
	bool is_waiting() const { return _stage == Stage::ASKED || is_preparing(); }
	// Returns whether advance() has nothing to do until ask() is called, or the driver refuses a pass.
	bool rests() const { return !is_waiting() && !_is_new && !_standing.is_refused() && !_standing.get_picture().is_look_waiting(); }
	ShownMap *get_map() const { return _wanted.map.get(); } // the map that waits to be shown, or null
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
	FieldProperties &_properties;
	StandingField &_standing;
	Stage _stage = Stage::NONE;
	WantedField _wanted; // while it is being prepared
	std::unique_ptr<ShownMap> _prepared;
	bool _is_reading = false; // scripts run; their queries find the field unchanged
	bool _is_new = false; // its warnings are not reported yet
	double _most_ms = 0.0; // in one frame since the last ask()
	int64_t _makings = 0; // so far
};

} // namespace grass

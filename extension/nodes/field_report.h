// SPDX-License-Identifier: MIT
// What a GrassField reports: its errors and warnings, why a place is bare, its statistics and its memory.
#pragma once

#include "core/field/field_statistics.h"
#include "nodes/field_frames.h"
#include "nodes/field_monitors.h"
#include "nodes/field_parts.h"
#include "nodes/field_ticks.h"

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include <functional>

namespace grass {

class FieldReport {
public:
	FieldReport(FieldParts &p_parts, const FieldTicks &p_ticks, const FieldFrames &p_frames) :
			_parts(p_parts), _ticks(p_ticks), _frames(p_frames) {}

	godot::String label() const; // of the node, for messages
	// Returns p_text with the node's name before it, for an error; the first time also with what a bug report needs.
	godot::String message(const godot::String &p_text) const;
	// Sets a function that gets the warnings instead of the console.
	using WarningTeller = std::function<void(const godot::String &p_warning)>;
	void set_warning_teller(const WarningTeller &p_teller) { _warning_teller = p_teller; }
	void warn(const godot::String &p_warning) const;
	godot::PackedStringArray find_warnings() const; // all that hold now
	// Reports new warnings, once each: in the console, or in the editor beside the node.
	void report_warnings();

	// Explains why there is no grass at a place, or less than there could be. p_camera: null: the viewport's.
	godot::Dictionary explain(const godot::Vector3 &p_global, const godot::Camera3D *p_camera);
	godot::Dictionary get_statistics() const;
	godot::Dictionary get_counters() const;
	int64_t get_memory_usage() const; // bytes
	FieldMemory find_memory() const;
	double find_monitor(FieldMonitor p_monitor); // this field's share; times are measured from the first call on

private:
	godot::Node3D *find_other(const godot::Vector3 &p_global) const;
	FieldStatistics find_statistics() const;

	FieldParts &_parts;
	const FieldTicks &_ticks;
	const FieldFrames &_frames;
	WarningTeller _warning_teller;
	godot::PackedStringArray _warned_of; // when the field was made
	mutable bool _has_reported = false; // whether message() has included version and device
};

} // namespace grass

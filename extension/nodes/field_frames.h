// SPDX-License-Identifier: MIT
// The frames of a GrassField: makes the field that the properties describe, reads what writes its map, and draws it for the cameras of the
// frame.
#pragma once

#include "field/other_light.h"
#include "nodes/field_parts.h"
#include "nodes/field_ticks.h"

#include <cstdint>

namespace grass {

class FieldFrames {
public:
	FieldFrames(FieldParts &p_parts, FieldTicks &p_ticks) : _parts(p_parts), _ticks(p_ticks) {}

	// Returns whether a frame has something to do. Where frames are drawn, every one may need another wind.
	bool needs_frame() const;
	void frame(double p_delta); // scripts run: afterwards the field may be gone
	void stir() { _rests = false; }
	// Makes the field as a frame does, once in each. Runs in frame() or, if the node does not process, before the frame is drawn. Returns
	// false if a script freed the field.
	[[nodiscard]] bool advance();
	// Draws the field. Must be called when the cameras have their poses of this frame. In a paused tree, frame() has not run before.
	void before_draw();
	void add_to(FieldStatistics &r_statistics) const;

private:
	void draw();
	void show_light();
	void warn_once(const godot::String &p_warning);

	FieldParts &_parts;
	FieldTicks &_ticks;
	OtherLight _other_light;
	uint64_t _advanced_in = UINT64_MAX; // the frame of the last advance()
	bool _rests = false; // until stir()
	int64_t _visited = 0;
	double _ms = 0.0; // CPU time of the last frame
};

} // namespace grass

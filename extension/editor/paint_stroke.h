// SPDX-License-Identifier: MIT
// One stroke of the editor's brush, from press to release: changes the map at once, then becomes one step of the editor's
// history. A field without a map gets one, as part of that step.
#pragma once

#include "core/paint/stroke_path.h"
#include "editor/ground_picker.h"
#include "nodes/grass_brush.h"
#include "nodes/grass_field.h"
#include "nodes/grass_map.h"

#include <godot_cpp/classes/editor_undo_redo_manager.hpp>

#include <set>

namespace grass {

// What is held down while painting.
struct StrokeKeys {
	bool opposite = false; // see opposite_of()
	bool smooth = false; // see smoothing_of()
	double pressure = 1.0; // of a pen, 0..1
};

// What a stroke cost so far.
struct StrokeCosts {
	int64_t steps = 0, chunks = 0; // chunks that steps changed, each time
	int64_t rays = 0; // that looked for the ground
	double total_us = 0.0, worst_us = 0.0; // CPU time of all steps, and of the longest, microseconds
};

class PaintStroke {
public:
	// p_bakes: reads the ground under the brush into the map before it paints there, for the grass to stand on and the
	// brush's limits to use.
	void begin(
			GrassField *p_field, const godot::Ref<GrassBrush> &p_brush, const GroundPoint &p_point, const StrokeKeys &p_keys, bool p_bakes);
	void move(const GroundPoint &p_point, const StrokeKeys &p_keys);
	// Ends the stroke and writes it into the history, if it changed anything. The field may be gone by then.
	void finish(godot::EditorUndoRedoManager *p_history);
	// Ends the stroke and undoes it.
	void cancel();

	bool is_active() const { return _map.is_valid(); }
	const StrokeCosts &get_costs() const { return _costs; } // of the stroke, also after its end

private:
	void step(const StrokeStep &p_step, const StrokeKeys &p_keys);
	void bake(const StrokeStep &p_step);
	GrassField *find_field() const;
	void forget();

	uint64_t _field_id = 0;
	godot::Ref<GrassBrush> _brush;
	godot::Ref<GrassMap> _map; // null between strokes
	godot::Ref<GrassMapSnapshot> _before;
	bool _new_map = false, _changed = false, _bakes = false;
	StrokePath _path;
	double _level = 0.0; // of the ground under the cursor, metres above the field
	std::set<MapKey> _baked; // squares of BAKE_CELL metres, read in this stroke
	StrokeCosts _costs;
};

// Gives a field that has no map one: everything grows, as it did without. With the ground, if p_bakes, where the field is
// not so large that this takes long.
godot::Ref<GrassMap> add_map(GrassField *p_field, bool p_bakes);

// The name of a tool in the history and in the toolbar.
const char *name_of(GrassBrush::Tool p_tool);

} // namespace grass

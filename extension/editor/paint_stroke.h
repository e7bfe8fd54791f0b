// SPDX-License-Identifier: MIT
// One stroke of the editor's brush, from press to release, over all fields that it reaches: changes their maps at once, and becomes one
// step of the editor's undo history.
#pragma once

#include "editor/field_stroke.h"

#include <godot_cpp/classes/editor_undo_redo_manager.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace grass {

class PaintStroke {
public:
	// Begins a stroke. p_bakes: see FieldStroke.
	void begin(const PaintedFields &p_painted, const godot::Ref<GrassBrush> &p_brush, const GroundPoint &p_point, const StrokeKeys &p_keys,
			bool p_bakes);
	// Paints up to a point. p_painted: the same fields, and for a world also those that have appeared meanwhile.
	void move(const PaintedFields &p_painted, const GroundPoint &p_point, const StrokeKeys &p_keys);
	// Ends the stroke and writes it to the history, if it changed anything. Its fields may have been freed by then.
	void finish(godot::EditorUndoRedoManager *p_history);
	// Ends the stroke and undoes it.
	void cancel();

	bool is_active() const { return _brush.is_valid(); }
	const StrokeCosts &get_costs() const { return _costs; } // of the stroke, also after its end
	// Returns the names of the fields that were left out since they do not grow the species to plant; also after the stroke's end.
	const godot::PackedStringArray &get_left_out() const { return _left_out; }

private:
	struct Reached { // a field that the stroke may paint
		uint64_t id;
		std::optional<int64_t> species; // that the brush plants, in this field's numbering
	};

	void set_fields(const PaintedFields &p_painted);
	void step(const StrokeStep &p_step, const StrokeKeys &p_keys);
	void step_in(const Reached &p_field, const StrokeStep &p_step, const StrokeKeys &p_keys);
	FieldStroke *find_part(GrassField *p_field);
	void forget();

	godot::Ref<GrassBrush> _brush; // null between strokes
	std::vector<Reached> _fields;
	std::vector<FieldStroke> _parts; // for the fields that were reached
	uint64_t _chosen_id = 0, _world_id = 0; // see PaintedFields
	Eigen::Isometry3d _space = Eigen::Isometry3d::Identity();
	double _margin = 0.0;
	StrokePath _path; // in that space
	GroundPoint _point; // under the cursor
	bool _bakes = false;
	StrokeCosts _costs;
	godot::PackedStringArray _left_out;
};

// Returns the name of a tool in the history and in the toolbar.
const char *name_of(GrassBrush::Tool p_tool);

} // namespace grass

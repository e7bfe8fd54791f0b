// SPDX-License-Identifier: MIT
#include "editor/paint_stroke.h"

#include <godot_cpp/classes/time.hpp>

#include <algorithm>
#include <array>

using namespace godot;

namespace grass {

const char *name_of(GrassBrush::Tool p_tool) {
	static constexpr std::array<const char *, size_t(MapTool::COUNT)> NAMES = { "Paint", "Erase", "Smooth", "Density", "Height", "Species",
		"Tint", "Comb", "Cut", "Flatten", "Regrow", "Recover" };
	return NAMES[size_t(p_tool)];
}

void PaintStroke::set_fields(const PaintedFields &p_painted) {
	_fields.clear();
	for (const GrassField *field : p_painted.fields) {
		_fields.push_back({ field->get_instance_id(), find_species(*p_painted.fields[0], _brush->get_species(), *field) });
	}
}

void PaintStroke::begin(const PaintedFields &p_painted, const Ref<GrassBrush> &p_brush, const GroundPoint &p_point,
		const StrokeKeys &p_keys, bool p_bakes) {
	_brush = p_brush;
	set_fields(p_painted);
	_chosen_id = p_painted.chosen->get_instance_id();
	_world_id = p_painted.world != nullptr ? p_painted.world->get_instance_id() : 0;
	_space = p_painted.space;
	_margin = p_painted.margin();
	_bakes = p_bakes;
	_costs = {};
	_left_out.clear();
	_point = p_point;
	step(_path.begin(p_point.place()), p_keys);
}

void PaintStroke::move(const PaintedFields &p_painted, const GroundPoint &p_point, const StrokeKeys &p_keys) {
	set_fields(p_painted);
	_point = p_point;
	for (const StrokeStep &one : _path.move(p_point.place(), _brush->get_spacing())) {
		step(one, p_keys);
	}
}

void PaintStroke::step(const StrokeStep &p_step, const StrokeKeys &p_keys) {
	const uint64_t begin = Time::get_singleton()->get_ticks_usec();
	for (const Reached &field : _fields) {
		step_in(field, p_step, p_keys);
	}
	const double spent = double(Time::get_singleton()->get_ticks_usec() - begin);
	_costs.steps++;
	_costs.total_us += spent;
	_costs.worst_us = std::max(_costs.worst_us, spent);
}

void PaintStroke::step_in(const Reached &p_field, const StrokeStep &p_step, const StrokeKeys &p_keys) {
	GrassField *field = Object::cast_to<GrassField>(ObjectDB::get_instance(p_field.id));
	if (field == nullptr || !field->is_inside_tree()) {
		return;
	}
	const auto over = step_over(*field, _space, p_step, _point.position.y(), _brush->get_reach() + _margin);
	if (!over) {
		return;
	}
	const std::optional<Brush> brush = brush_for(**_brush, over->step, p_keys, p_field.species);
	if (!brush) {
		if (!_left_out.has(field->get_name())) {
			_left_out.push_back(field->get_name());
		}
	} else if (FieldStroke *part = find_part(field)) {
		part->step(
				_brush->get_stroke(over->step.from, over->step.to, over->turn + _brush->find_turn(p_step.to)), *brush, over->level, _costs);
	}
}

// Returns null if the field's map is painted already through another field: only one place of a shared map is under the brush.
FieldStroke *PaintStroke::find_part(GrassField *p_field) {
	for (FieldStroke &part : _parts) {
		if (part.get_map() == p_field->get_map()) {
			return part.get_field_id() == p_field->get_instance_id() ? &part : nullptr;
		}
	}
	return &_parts.emplace_back(p_field, _bakes, _point.on_body, Object::cast_to<GrassWorld>(ObjectDB::get_instance(_world_id)));
}

void PaintStroke::finish(EditorUndoRedoManager *p_history) {
	if (!is_active()) {
		return;
	}
	std::vector<MapStep> steps;
	for (FieldStroke &part : _parts) {
		if (const auto step = part.get_step()) {
			steps.push_back(*step);
		} else {
			part.cancel();
		}
	}
	if (!steps.empty()) {
		// A field's scene keeps the step, even if the map has its own file.
		Object *context = ObjectDB::get_instance(_chosen_id);
		for (size_t i = 0; i < _fields.size() && context == nullptr; i++) {
			context = ObjectDB::get_instance(_fields[i].id);
		}
		const String name = String(name_of(_brush->get_tool())) + " Grass";
		add_map_steps(p_history, name, context != nullptr ? context : steps[0].map.ptr(), steps);
	}
	forget();
}

void PaintStroke::cancel() {
	for (FieldStroke &part : _parts) {
		part.cancel();
	}
	forget();
}

void PaintStroke::forget() {
	_brush.unref();
	_fields.clear();
	_parts.clear();
}

} // namespace grass

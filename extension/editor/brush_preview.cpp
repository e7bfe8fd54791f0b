// SPDX-License-Identifier: MIT
#include "editor/brush_preview.h"

#include "world/world_fields.h"

using namespace godot;

namespace grass {

void BrushPreview::show(const PaintedFields &p_painted, const GrassBrush &p_brush, const GroundPoint &p_point, const StrokeKeys &p_keys) {
	hide();
	const StrokeStep way{ _last, p_point.place() };
	_last = p_point.place();
	const double reach = p_brush.get_reach() + p_painted.margin();
	for (GrassField *field : p_painted.fields) {
		const std::optional<int64_t> species = find_species(*p_painted.fields[0], p_brush.get_species(), *field);
		const auto over = step_over(*field, p_painted.space, { p_point.place(), p_point.place() }, p_point.position.y(), reach);
		const auto along = step_over(*field, p_painted.space, way, p_point.position.y(), reach);
		if (!over || !along) {
			continue;
		}
		if (const auto brush = brush_for(p_brush, along->step, p_keys, species)) {
			field->preview(p_brush.get_stroke(over->step.from, over->step.to, over->turn + p_brush.find_turn(p_point.place())), *brush);
			_field_ids.push_back(field->get_instance_id());
		}
	}
}

void BrushPreview::hide() {
	for (const uint64_t id : _field_ids) {
		if (GrassField *field = field_with(id)) {
			field->end_preview();
		}
	}
	_field_ids.clear();
}

int BrushPreview::get_count() const {
	int count = 0;
	for (const uint64_t id : _field_ids) {
		const GrassField *field = field_with(id);
		count += field != nullptr && field->is_preview() ? 1 : 0;
	}
	return count;
}

} // namespace grass

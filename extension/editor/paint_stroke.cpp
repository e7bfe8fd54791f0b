// SPDX-License-Identifier: MIT
#include "editor/paint_stroke.h"

#include "core/paint/brush_keys.h"
#include "editor/map_step.h"
#include "nodes/ground_rays.h"

#include <godot_cpp/classes/time.hpp>

#include <array>

using namespace godot;

namespace grass {

namespace {

constexpr double BAKE_CELL = 4.0; // metres: the ground is read in squares of this size
constexpr double LARGEST_BAKE = 65536.0; // m^2 that a new map reads at once, a ray for each: some tenths of a second

} // namespace

Ref<GrassMap> add_map(GrassField *p_field, bool p_bakes) {
	Ref<GrassMap> map;
	map.instantiate();
	map->set_base_density(1.0);
	p_field->set_map(map);
	if (p_bakes && p_field->get_terrain().is_empty() && p_field->get_size().x * p_field->get_size().y <= LARGEST_BAKE) {
		p_field->bake_ground();
	}
	return map;
}

const char *name_of(GrassBrush::Tool p_tool) {
	static constexpr std::array<const char *, size_t(MapTool::COUNT)> NAMES = { "Paint", "Erase", "Smooth", "Density", "Height", "Species",
		"Tint", "Comb", "Cut", "Flatten", "Regrow", "Recover" };
	return NAMES[size_t(p_tool)];
}

GrassField *PaintStroke::find_field() const {
	return Object::cast_to<GrassField>(ObjectDB::get_instance(_field_id));
}

void PaintStroke::begin(
		GrassField *p_field, const Ref<GrassBrush> &p_brush, const GroundPoint &p_point, const StrokeKeys &p_keys, bool p_bakes) {
	_field_id = p_field->get_instance_id();
	_brush = p_brush;
	_map = p_field->get_map();
	_new_map = _map.is_null();
	if (_new_map) {
		_map = add_map(p_field, p_bakes);
	}
	_before = _map->take_snapshot();
	_changed = false;
	_bakes = p_bakes && p_point.on_body && p_field->get_terrain().is_empty();
	_level = p_point.position.y();
	_baked.clear();
	_costs = {};
	step(_path.begin(p_point.place()), p_keys);
}

void PaintStroke::move(const GroundPoint &p_point, const StrokeKeys &p_keys) {
	const GrassField *field = find_field();
	if (field == nullptr || field->get_map() != _map) { // gone, or painted on another map
		return;
	}
	_level = p_point.position.y();
	for (const StrokeStep &one : _path.move(p_point.place(), _brush->get_param(BRUSH_RADIUS))) {
		step(one, p_keys);
	}
}

// The squares that the brush meets for the first time in this stroke, and those between them.
void PaintStroke::bake(const StrokeStep &p_step) {
	const GrassField *field = find_field();
	const double radius = _brush->get_param(BRUSH_RADIUS), border = radius + info_of(MAP_GROUND).texel_size();
	const Eigen::Array2i low = ((p_step.from.cwiseMin(p_step.to).array() - border) / BAKE_CELL).floor().cast<int>();
	const Eigen::Array2i high = ((p_step.from.cwiseMax(p_step.to).array() + border) / BAKE_CELL).floor().cast<int>();
	Eigen::Array2i first = high + 1, last = low - 1;
	for (int z = low.y(); z <= high.y(); z++) {
		for (int x = low.x(); x <= high.x(); x++) {
			if (_baked.insert({ x, z }).second) {
				first = first.min(Eigen::Array2i(x, z));
				last = last.max(Eigen::Array2i(x, z));
			}
		}
	}
	if (field == nullptr || (first > last).any()) {
		return;
	}
	GroundRays rays(field->get_world_3d(), field->field_transform());
	const double span = search_height(border + BAKE_CELL);
	const MapRegion region{ first.cast<double>() * BAKE_CELL, (last + 1).cast<double>() * BAKE_CELL };
	const auto height = [&](const Eigen::Vector2d &p_place) { return rays.height_at(p_place, _level - span, _level + span); };
	const LaidGround laid = _map->change([&](PaintMap &r_map) { return lay_ground(r_map, region, height); });
	_costs.rays += laid.sampled;
	_changed = _changed || !laid.changed.empty();
}

void PaintStroke::step(const StrokeStep &p_step, const StrokeKeys &p_keys) {
	const uint64_t begin = Time::get_singleton()->get_ticks_usec();
	if (_bakes) {
		bake(p_step);
	}
	Brush brush = _brush->get_brush(p_step.from, p_step.to);
	if (p_keys.smooth) {
		brush = smoothing_of(brush);
	} else if (p_keys.opposite) {
		brush = opposite_of(brush);
	}
	brush.strength *= p_keys.pressure;
	const BrushResult result = _map->apply(_brush->get_stroke(p_step.from, p_step.to), brush);
	_changed = _changed || !result.changed.empty();
	const double spent = double(Time::get_singleton()->get_ticks_usec() - begin);
	_costs.steps++;
	_costs.chunks += int64_t(result.changed.size());
	_costs.total_us += spent;
	_costs.worst_us = std::max(_costs.worst_us, spent);
}

void PaintStroke::finish(EditorUndoRedoManager *p_history) {
	if (!is_active()) {
		return;
	}
	if (!_changed) {
		cancel();
		return;
	}
	GrassField *field = find_field();
	if (field != nullptr || !_new_map) {
		// The field's scene keeps the step, also where the map is a file of its own.
		Object *context = field == nullptr ? static_cast<Object *>(_map.ptr()) : field;
		const MapStep step = { context, _map, _before, _new_map ? field : nullptr };
		add_map_step(p_history, String(name_of(_brush->get_tool())) + " Grass", step);
	}
	forget();
}

void PaintStroke::cancel() {
	if (!is_active()) {
		return;
	}
	if (_changed) {
		_map->restore_snapshot(_before);
	}
	GrassField *field = find_field();
	if (_new_map && field != nullptr && field->get_map() == _map) {
		field->set_map(Ref<GrassMap>());
	}
	forget();
}

void PaintStroke::forget() {
	_field_id = 0;
	_brush.unref();
	_map.unref();
	_before.unref();
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "editor/field_stroke.h"

#include "core/paint/brush_keys.h"
#include "editor/painted_fields.h"
#include "physics/grid_search.h"
#include "physics/ground_rays.h"

#include <cmath>

using namespace godot;

namespace grass {

namespace {

constexpr double BAKE_CELL = 4.0; // metres: the ground is read in squares of this size
constexpr double LARGEST_BAKE = 65536.0; // most m^2 that a new map reads at once, with a ray for each: some tenths of a second

} // namespace

Ref<GrassMap> add_map(GrassField *p_field, bool p_bakes) {
	p_field->make_map();
	if (p_bakes && p_field->get_parts().sources.get_terrain().is_empty() &&
			p_field->get_parts().settings.get_size().x * p_field->get_parts().settings.get_size().y <= LARGEST_BAKE) {
		p_field->get_parts().work.bake_whole_ground();
	}
	return p_field->get_map();
}

std::optional<Brush> brush_for(
		const GrassBrush &p_brush, const StrokeStep &p_step, const StrokeKeys &p_keys, const std::optional<int64_t> &p_species) {
	Brush brush = p_brush.get_brush(p_step.from, p_step.to);
	brush.strength *= p_keys.pressure;
	if (p_keys.smooth) {
		brush = smoothing_of(brush);
	} else if (p_keys.opposite) {
		return opposite_of(brush);
	}
	if (brush.tool == MapTool::SPECIES) {
		if (!p_species) {
			return {};
		}
		brush.target = double(*p_species);
	}
	return brush;
}

std::optional<FieldStep> step_over(
		const GrassField &p_field, const Eigen::Isometry3d &p_space, const StrokeStep &p_step, double p_level, double p_radius) {
	const Eigen::Isometry3d to_field = to_field_of(p_field) * p_space;
	const auto moved = [&](const Eigen::Vector2d &p_place) -> Eigen::Vector3d {
		return to_field * Eigen::Vector3d(p_place.x(), p_level, p_place.y());
	};
	const Eigen::Vector3d from = moved(p_step.from), to = moved(p_step.to);
	const FieldStep over{ { { from.x(), from.z() }, { to.x(), to.z() } }, to.y(),
		std::atan2(to_field.linear()(2, 0), to_field.linear()(0, 0)) };
	const bool is_over = p_field.get_parts().settings.get_ground_band().contains(over.level) &&
			(is_reached(p_field, over.step.from, p_radius) || is_reached(p_field, over.step.to, p_radius));
	return is_over ? std::optional<FieldStep>(over) : std::nullopt;
}

FieldStroke::FieldStroke(GrassField *p_field, bool p_bakes, bool p_is_ground, GrassWorld *p_world) :
		_field_id(p_field->get_instance_id()),
		_map(p_field->get_map()),
		_new_map(_map.is_null()),
		_bakes(p_bakes && p_is_ground && p_field->get_parts().sources.get_terrain().is_empty()) {
	if (_new_map) {
		_map = add_map(p_field, p_bakes);
	}
	_before = _map->take_snapshot();
	if (p_world != nullptr) {
		_world_id = p_world->get_instance_id();
		_plot = p_world->get_plot_at(p_field->get_global_position());
	}
}

GrassField *FieldStroke::find_field() const {
	return Object::cast_to<GrassField>(ObjectDB::get_instance(_field_id));
}

GrassWorld *FieldStroke::find_world() const {
	return Object::cast_to<GrassWorld>(ObjectDB::get_instance(_world_id));
}

// Bakes the squares that the brush meets for the first time in this stroke, and those between them.
void FieldStroke::bake(const MapShape &p_shape, double p_level, StrokeCosts &r_costs) {
	const GrassField *field = find_field();
	const double border = info_of(MAP_GROUND).texel_size();
	const Eigen::Array2i low = ((p_shape.get_min().array() - border) / BAKE_CELL).floor().cast<int>();
	const Eigen::Array2i high = ((p_shape.get_max().array() + border) / BAKE_CELL).floor().cast<int>();
	Eigen::Array2i first = high + 1, last = low - 1;
	for (int z = low.y(); z <= high.y(); z++) {
		for (int x = low.x(); x <= high.x(); x++) {
			if (_baked.insert({ x, z }).second) {
				first = first.min(Eigen::Array2i(x, z));
				last = last.max(Eigen::Array2i(x, z));
			}
		}
	}
	if ((first > last).any()) {
		return;
	}
	GroundRays rays(field->get_world_3d(), field->field_transform());
	rays.stand(*field);
	rays.keep_within(field->get_parts().settings.get_ground_band());
	const double radius = 0.5 * (p_shape.get_max() - p_shape.get_min()).maxCoeff();
	const double span = search_height(radius + border + BAKE_CELL);
	const MapRegion region{ first.cast<double>() * BAKE_CELL, (last + 1).cast<double>() * BAKE_CELL };
	const Eigen::Vector2d half = 0.5 * to_eigen(field->get_parts().settings.get_size());
	const MapRegion ground{ -half, half };
	const auto continued = [&](const HeightAt &p_ray) -> HeightAt {
		return [=](const Eigen::Vector2d &p_place) { return continued_ground(p_ray(p_place), p_ray, ground, p_place); };
	};
	const HeightAt height =
			continued([&](const Eigen::Vector2d &p_place) { return rays.height_at_corner(p_place, p_level - span, p_level + span); });
	const HeightAt between =
			continued([&](const Eigen::Vector2d &p_place) { return rays.height_at(p_place, p_level - span, p_level + span); });
	const LedgeSearch search{ between, field->get_parts().settings.get_param(PARAM_LEDGE_SLOPE) };
	const bool is_first = is_all_ground_in(_map->get_map(), region);
	const GroundGrid grid = is_first ? search_grid(rays, region, field->field_transform()) : _map->get_map().get_ground_grid();
	const LaidGround laid = _map->change([&](PaintMap &r_map) {
		r_map.set_ground_grid(grid);
		return lay_ground(r_map, region, height, MissingGround::STAYS, nullptr, search);
	});
	r_costs.rays += laid.sampled;
	_changed = _changed || !laid.changed.empty();
}

void FieldStroke::step(const MapShape &p_shape, const Brush &p_brush, double p_level, StrokeCosts &r_costs) {
	const GrassField *field = find_field();
	if (field == nullptr || field->get_map() != _map) { // it was freed, or has another map now
		return;
	}
	if (_bakes) {
		bake(p_shape, p_level, r_costs);
	}
	const BrushResult result = _map->apply(p_shape, p_brush);
	_changed = _changed || !result.changed.empty();
	r_costs.chunks += int64_t(result.changed.size());
}

std::optional<MapStep> FieldStroke::get_step() const {
	GrassField *field = find_field();
	GrassWorld *world = find_world();
	if (!_changed || (field == nullptr && _new_map) || (_world_id != 0 && world == nullptr)) {
		return {};
	}
	return MapStep{ _map, _before, _new_map ? field : nullptr, world, _plot };
}

void FieldStroke::cancel() {
	if (_world_id != 0) { // the plot may have left memory meanwhile
		if (GrassWorld *world = find_world(); world != nullptr && _changed) {
			world->restore_plot(_plot, _before, _map->take_snapshot());
		}
		return;
	}
	if (_changed) {
		_map->restore_snapshot(_before);
	}
	GrassField *field = find_field();
	if (_new_map && field != nullptr && field->get_map() == _map) {
		field->set_map(Ref<GrassMap>());
	}
}

} // namespace grass

// SPDX-License-Identifier: MIT
// The part of a stroke on one field: changes its map at once, and can undo that. A field without a map gets one.
#pragma once

#include "core/paint/stroke_path.h"
#include "editor/ground_picker.h"
#include "editor/map_step.h"
#include "nodes/grass_field.h"
#include "resources/grass_brush.h"
#include "resources/grass_map.h"

#include <optional>
#include <set>

namespace grass {

// Keys and pressure while painting.
struct StrokeKeys {
	bool opposite = false; // see opposite_of()
	bool smooth = false; // see smoothing_of()
	double pressure = 1.0; // of a pen, 0..1
};

// Cost of a stroke so far.
struct StrokeCosts {
	int64_t steps = 0, chunks = 0; // chunks: changed by steps, counted each time
	int64_t rays = 0; // cast to find the ground
	double total_us = 0.0, worst_us = 0.0; // CPU time of all steps and of the longest one, microseconds
};

// Returns the brush for one step over a field that has this number for the brush's species. Returns nothing if the brush plants a species
// that the field does not grow.
std::optional<Brush> brush_for(
		const GrassBrush &p_brush, const StrokeStep &p_step, const StrokeKeys &p_keys, const std::optional<int64_t> &p_species);

// A step over one field, in the field's space.
struct FieldStep {
	StrokeStep step;
	double level; // height of the ground there, metres
	double turn; // rotation of the step's space in the field's space, radians from x towards z
};

// Returns the step over a field. p_step: in p_space (a transform to global space), at p_level metres. Returns nothing if a brush of that
// radius does not reach the field, or if the ground there is not the field's.
std::optional<FieldStep> step_over(
		const GrassField &p_field, const Eigen::Isometry3d &p_space, const StrokeStep &p_step, double p_level, double p_radius);

// Gives a map to a field that has none. Grass grows everywhere, as it did before. If p_bakes, reads the ground too, unless the field is so
// large that this takes long.
godot::Ref<GrassMap> add_map(GrassField *p_field, bool p_bakes);

class FieldStroke {
public:
	// Begins a stroke on a field. p_bakes: reads the ground under the brush into a new map. p_is_ground: reads it into any map before the
	// brush paints there, since the grass and the brush's limits need it. p_world: the world if the field is one of its plots, or null.
	FieldStroke(GrassField *p_field, bool p_bakes, bool p_is_ground, GrassWorld *p_world);

	// Applies a step of the brush. p_level: of the ground under the cursor, metres above the field.
	void step(const MapShape &p_shape, const Brush &p_brush, double p_level, StrokeCosts &r_costs);
	// Returns the changes, or nothing if there was none, or if it was lost with its field.
	std::optional<MapStep> get_step() const;
	void cancel();

	uint64_t get_field_id() const { return _field_id; }
	const godot::Ref<GrassMap> &get_map() const { return _map; }

private:
	void bake(const MapShape &p_shape, double p_level, StrokeCosts &r_costs);
	GrassField *find_field() const;
	GrassWorld *find_world() const;

	uint64_t _field_id, _world_id = 0; // 0: not in a world
	godot::Vector2i _plot;
	godot::Ref<GrassMap> _map;
	godot::Ref<GrassMapSnapshot> _before;
	bool _new_map, _changed = false, _bakes;
	std::set<MapKey> _baked; // squares of BAKE_CELL metres that this stroke has read
};

} // namespace grass

// SPDX-License-Identifier: MIT
// What a stroke does to one field: changes its map at once, and knows how to take that back. A field without a map gets one.
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

// The brush for one step over a field that has this number for the brush's species. Nothing where it plants a species that the
// field does not grow.
std::optional<Brush> brush_for(
		const GrassBrush &p_brush, const StrokeStep &p_step, const StrokeKeys &p_keys, const std::optional<int64_t> &p_species);

// A step over one field, in its own space.
struct FieldStep {
	StrokeStep step;
	double level; // of the ground there, metres
	double turn; // of the space of the step in that of the field, radians from x towards z
};

// p_step: in p_space (from there to the world), at p_level metres. Nothing where a brush of that radius does not reach the field.
std::optional<FieldStep> step_over(
		const GrassField &p_field, const Eigen::Isometry3d &p_space, const StrokeStep &p_step, double p_level, double p_radius);

// Gives a field that has no map one: everything grows, as it did without. With the ground, if p_bakes, where the field is
// not so large that this takes long.
godot::Ref<GrassMap> add_map(GrassField *p_field, bool p_bakes);

class FieldStroke {
public:
	// p_bakes: reads the ground under the brush into a new map; p_is_ground: and into any, before the brush paints there, for the
	// grass to stand on and the brush's limits to use.
	// p_world: whose plot the field is, or null.
	FieldStroke(GrassField *p_field, bool p_bakes, bool p_is_ground, GrassWorld *p_world);

	// p_level: of the ground under the cursor, metres above the field.
	void step(const MapShape &p_shape, const Brush &p_brush, double p_level, StrokeCosts &r_costs);
	// Nothing: no change, or one that is lost with its field.
	std::optional<MapStep> get_step() const;
	void cancel();

	uint64_t get_field_id() const { return _field_id; }
	const godot::Ref<GrassMap> &get_map() const { return _map; }

private:
	void bake(const MapShape &p_shape, double p_level, StrokeCosts &r_costs);
	GrassField *find_field() const;
	GrassWorld *find_world() const;

	uint64_t _field_id, _world_id = 0; // 0: of no world
	godot::Vector2i _plot;
	godot::Ref<GrassMap> _map;
	godot::Ref<GrassMapSnapshot> _before;
	bool _new_map, _changed = false, _bakes;
	std::set<MapKey> _baked; // squares of BAKE_CELL metres, read in this stroke
};

} // namespace grass

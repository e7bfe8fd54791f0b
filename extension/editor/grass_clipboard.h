// SPDX-License-Identifier: MIT
// What the toolbar has copied: painted grass, and the species of a field. Kept while other scenes are edited.
#pragma once

#include "core/paint/copied_area.h"
#include "nodes/grass_field.h"

namespace grass {

class GrassClipboard {
public:
	// Copy the whole field, or the circle under the brush. p_middle: x, z in metres from the field's centre.
	void copy_field(const GrassField &p_field);
	void copy_circle(const GrassField &p_field, const Eigen::Vector2d &p_middle, double p_radius);
	void copy_species(const GrassField &p_field);

	bool has_grass() const { return _area.area() > 0.0; }
	bool is_of_field() const { return has_grass() && !_area.is_round; }
	int64_t count_species() const { return _palette.size(); }
	// Returns the copied species. In another scene than theirs, species that are a part of their scene are copies, which do not change with
	// it.
	godot::TypedArray<GrassSpecies> make_palette() const;
	// Pastes the area. Returns the number of its species that the field does not grow: these are not planted.
	int paste(const GrassField &p_field, GrassMap &r_map, const Eigen::Vector2d &p_middle) const;

private:
	void copy(const GrassField &p_field, const Eigen::Vector2d &p_middle, const Eigen::Vector2d &p_half, bool p_is_round);

	CopiedArea _area;
	godot::TypedArray<GrassSpecies> _planted; // the numbers in _area are of these
	godot::TypedArray<GrassSpecies> _palette;
	uint64_t _palette_scene = 0; // instance id of its root
};

} // namespace grass

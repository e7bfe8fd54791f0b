// SPDX-License-Identifier: MIT
// What cull reads of a frame: the cameras, and the field as they see it.
#pragma once

#include "core/field/field_setup.h"
#include "core/lod/field_levels.h"
#include "gpu/plant_passes.h"

namespace grass {

// The records of one drawn frame.
struct ViewRecords {
	GrassView view;
	std::vector<GrassCamera> cameras;
	PaintedSpecies painted; // for fields with plants and a map
	float plant_reach = 1.0f; // see FieldView
	uint64_t number = 0; // of the frame among those of the field
};

// The MultiMeshes that draw a field.
struct FieldMultiMeshes {
	godot::RID picture, shadows;
	uint32_t picture_capacity, shadow_capacity; // instances
};

// Returns the records of a frame. p_levels, p_surfaces: the levels that tiles can have, and those that meshes have surfaces for.
ViewRecords to_records(const FieldView &p_view, const FieldSetup &p_setup, LevelSet p_levels, LevelSet p_surfaces);

} // namespace grass

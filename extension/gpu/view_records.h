// SPDX-License-Identifier: MIT
// What cull reads of a frame: the cameras, and the field as they see it.
#pragma once

#include "gpu/gpu_field.h"

namespace grass {

// p_levels, p_surfaces: the levels that tiles can have, and those that meshes have surfaces for.
ViewRecords to_records(const FieldView &p_view, const FieldSetup &p_setup, LevelSet p_levels, LevelSet p_surfaces);

} // namespace grass

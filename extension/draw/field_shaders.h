// SPDX-License-Identifier: MIT
// All shaders that draw a field.
#pragma once

#include "draw/shared_shader.h"

namespace grass {

// Returns whether the look's shaders are ready; otherwise starts making them. See prepare_shader().
bool prepare_shaders(const Look &p_look);
// Returns whether the shaders compile with the look's hook.
bool are_compiled(const Look &p_look);

} // namespace grass

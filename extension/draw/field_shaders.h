// SPDX-License-Identifier: MIT
// All shaders that a field is drawn with.
#pragma once

#include "draw/shared_shader.h"

namespace grass {

// Returns whether the look's shaders are ready; else they are being made. See prepare_shader().
bool prepare_shaders(const Look &p_look);
// Whether those of the look compile with its hook.
bool are_compiled(const Look &p_look);

} // namespace grass

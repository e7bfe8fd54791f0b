// SPDX-License-Identifier: MIT
// shaders/solver/quick_joint.inc as C++: METHOD_DIRECT's quick solve, joint by joint, over any lane type.
#pragma once

#include "core/solver/leaves.h"

namespace grass {

#include "core/base/lane_words.h"

#include "solver/quick_joint.inc"

#include "core/base/lane_words_end.h"

} // namespace grass

// SPDX-License-Identifier: MIT
// shaders/base/matrix.inc as C++: the few 3 x 3 matrices of METHOD_DIRECT, over any lane type.
#pragma once

#include "core/base/vector.h"

namespace grass {

#include "core/base/lane_words.h"

#include "base/matrix.inc"

#include "core/base/lane_words_end.h"

} // namespace grass

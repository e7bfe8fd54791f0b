// SPDX-License-Identifier: MIT
// Undefines what lane_words.h defines.
#undef GRASS_LANES
#undef GRASS_RECORD
#undef VEC3
#undef TURN
#undef FACE
#undef MASK
#undef OF_T
#undef MADE
#undef IN
#undef INOUT
#undef TO_T
#undef GRASS_UNROLL
#undef NO_TURN
#undef precise

// SPDX-License-Identifier: MIT
// shaders/solver/leaves.inc as C++: small functions of the solver, over any lane type.
#pragma once

#include "core/base/matrix.h"
#include "core/bodies/collider.h"
#include "core/solver/constants.h"

namespace grass {

#define GRASS_FUNCTION inline constexpr
#include "core/base/lane_words.h"

#include "solver/leaves.inc"

#include "core/base/lane_words_end.h"
#undef GRASS_FUNCTION

// Returns p_a where the mask is true, else p_b.
template <class T, class Mask> GRASS_INLINE Touch<T> select(const Mask &p_mask, const Touch<T> &p_a, const Touch<T> &p_b) {
	return { select(p_mask, p_a.normal, p_b.normal), select(p_mask, p_a.slip, p_b.slip), select(p_mask, p_a.depth, p_b.depth),
		select(p_mask, p_a.held, p_b.held), select(p_mask, p_a.friction, p_b.friction) };
}

template <class T, class Mask> GRASS_INLINE Edge<T> select(const Mask &p_mask, const Edge<T> &p_a, const Edge<T> &p_b) {
	return { select(p_mask, p_a.face, p_b.face), select(p_mask, p_a.share, p_b.share) };
}

} // namespace grass

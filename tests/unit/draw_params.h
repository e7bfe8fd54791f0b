// SPDX-License-Identifier: MIT
#pragma once

#include "core/solver/solver_params.h"

namespace grass::test {

// Parameters at random: p_draw(Tunable) gives each number. Iterations and load stay as by default.
template <class Draw> SolverParams draw_params(Method p_method, const Draw &p_draw) {
	SolverParams params;
	params.method = p_method;
	params.natural_frequency = p_draw(NATURAL_FREQUENCY);
	params.damping_ratio = p_draw(DAMPING_RATIO);
	params.taper = p_draw(TAPER);
	params.width_to_thickness = p_draw(WIDTH_TO_THICKNESS);
	params.root_stiffness = p_draw(ROOT_STIFFNESS);
	params.bend_stiffness = p_draw(BEND_STIFFNESS);
	params.friction = p_draw(FRICTION);
	params.swing_speed_max = p_draw(SWING_SPEED_MAX);
	return params;
}

} // namespace grass::test

// SPDX-License-Identifier: MIT
// Computes how a blade's stiffness and mass change from root to tip, docs/internals/solver.md, [Eq 44].
#pragma once

namespace grass {

struct Section {
	double thins; // share of the root's width that is lost from knot to knot beyond the clamp
	double stiffness; // EI at the root, relative to a uniform blade that swings as often
	double first_joint; // stiffness of the first joint, relative to a blade that is as stiff all along as at its root
};

// Returns the section of a species. p_taper: share of the root's width that is lost at the tip, from 0 to less than 1.
Section make_section(double p_taper);

} // namespace grass

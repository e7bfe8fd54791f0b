// SPDX-License-Identifier: MIT
// What the sections of a field's species make of the basis, [Eq Q7], kept from step to step.
#pragma once

#include "core/base/layout.h"

#include <span>
#include <utility>
#include <vector>

namespace grass {

template <class T> struct StrainSection;

class StrainSections {
public:
	StrainSections();
	~StrainSections();

	// Returns the sections of the species that take these steps, in their order. Only those that have changed are computed, in some 50
	// microseconds each. Valid until the next call.
	std::span<const StrainSection<float>> find(std::span<const GrassStep> p_steps);
	// Returns the same as the numbers that strains.glsl reads.
	std::span<const float> find_numbers(std::span<const GrassStep> p_steps);

private:
	std::vector<std::pair<float, float>> _found_for; // what of a step they depend on
	std::vector<StrainSection<float>> _sections;
};

} // namespace grass

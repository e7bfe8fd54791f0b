// SPDX-License-Identifier: MIT
#include "core/solver/strain/sections.h"

#include "core/solver/strain/basis.h"

#include <cmath>

namespace grass {

StrainSections::StrainSections() = default;
StrainSections::~StrainSections() = default;

std::span<const StrainSection<float>> StrainSections::find(std::span<const GrassStep> p_steps) {
	_found_for.resize(p_steps.size(), { -1.0f, -1.0f });
	_sections.resize(p_steps.size());
	for (size_t i = 0; i < p_steps.size(); i++) {
		const std::pair wanted{ p_steps[i].free_motion.y, p_steps[i].energy.w };
		if (std::exchange(_found_for[i], wanted) != wanted) {
			const double stiffer = double(wanted.second);
			_sections[i] = make_strain_section(double(wanted.first) * GRASS_SEGMENTS, std::sqrt(stiffer * stiffer + 1.0));
		}
	}
	return _sections;
}

std::span<const float> StrainSections::find_numbers(std::span<const GrassStep> p_steps) {
	static_assert(sizeof(StrainSection<float>) == (2 * GRASS_STRAIN_SPRINGS + GRASS_STRAIN_MASSES) * sizeof(float));
	const std::span<const StrainSection<float>> sections = find(p_steps);
	return { reinterpret_cast<const float *>(sections.data()), sections.size_bytes() / sizeof(float) };
}

} // namespace grass

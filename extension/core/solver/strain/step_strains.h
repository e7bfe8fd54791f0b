// SPDX-License-Identifier: MIT
// The step of a tile's blades by their strains over any lane type. core/solver/step_tile.h takes it where TileState::sections wants it.
#pragma once

#include "core/solver/strain/strain.h"
#include "core/solver/tile_lanes.h"

namespace grass {

// p_species: points to the first lane's blade.
template <class T> GRASS_INLINE StrainStep<T> make_strain_step(std::span<const GrassStep> p_steps, const uint8_t *p_species) {
	const auto own = [&](vec4 GrassStep::*p_of, float vec4::*p_part) { return own_number<T>(p_steps, p_species, p_part, p_of); };
	const T even = own(&GrassStep::chain, &vec4::z), seconds = T(p_steps[0].chain.x);
	StrainStep<T> step;
	step.load = { own(&GrassStep::load, &vec4::x), own(&GrassStep::load, &vec4::y), own(&GrassStep::load, &vec4::z) };
	step.span = own(&GrassStep::free_motion, &vec4::x);
	step.ratio = T(p_steps[0].chain.y);
	step.drag = own(&GrassStep::chain, &vec4::w) * seconds;
	step.bending = even * own(&GrassStep::free_motion, &vec4::z);
	step.swing = even * seconds * seconds * T(WILD * WILD);
	step.still_turns = T(p_steps[0].pbd_motion.y);
	step.most_move = own(&GrassStep::load, &vec4::w);
	step.per_second = T(p_steps[0].energy.x);
	step.gap = T(p_steps[0].contact.z);
	return step;
}

template <class T>
GRASS_INLINE void take_section(
		StrainSection<T> &r_section, const StrainSection<float> *p_all, bool p_has_species, const uint8_t *p_species) {
	const auto own = [&](const auto &p_number) {
		alignas(64) float numbers[LANE_COUNT<T>];
		for (int lane = 0; lane < LANE_COUNT<T>; lane++) {
			numbers[lane] = p_number(p_all[p_has_species ? p_species[lane] : 0]);
		}
		return load<T>(numbers);
	};
	for (int i = 0; i < GRASS_STRAIN_SPRINGS; i++) {
		r_section.soft.at[i] = own([i](const StrainSection<float> &p_of) { return p_of.soft.at[i]; });
		r_section.stiff.at[i] = own([i](const StrainSection<float> &p_of) { return p_of.stiff.at[i]; });
	}
	for (int i = 0; i < GRASS_STRAIN_MASSES; i++) {
		r_section.mass[i] = own([i](const StrainSection<float> &p_of) { return p_of.mass[i]; });
	}
}

// Loads blades from p_first on. All segments of a blade are equally long.
template <class T> GRASS_INLINE void load_blade(const TileState &p_state, int p_first, StrainBlade<T> &r_blade) {
	const Vec3<T> width{ load<T>(&p_state.width[0][p_first]), T(0.0f), load<T>(&p_state.width[1][p_first]) };
	for (int k = 0; k < GRASS_KNOTS; k++) {
		r_blade.rest[k] = load_knot<T>(p_state.rest, k, p_first);
	}
	r_blade.length = length(r_blade.rest[1] - r_blade.rest[0]) * T(float(GRASS_SEGMENTS));
	const T shorter = T(0.5f * float(GRASS_SEGMENTS)) / maximum(r_blade.length, T(1e-12f));
	for (int s = 1; s <= GRASS_STRAIN_JOINTS; s++) {
		r_blade.axes[s] = joint_axes(r_blade.rest[s] - r_blade.rest[s - 1], r_blade.rest[s + 1] - r_blade.rest[s], width, shorter);
	}
	for (int n = 0; n < GRASS_STRAINS; n++) {
		r_blade.now.at[n] = load<T>(&p_state.strains[n][p_first]);
		r_blade.before.at[n] = load<T>(&p_state.strains_before[n][p_first]);
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const int free = k - GRASS_CLAMPED_KNOTS;
		r_blade.places[k] = load_knot<T>(p_state.knots, free, p_first);
		r_blade.places_before[k] = load_knot<T>(p_state.before, free, p_first);
		r_blade.twist[k - 1] = load<T>(&p_state.twist[free][p_first]);
	}
	if (!p_state.has_strains) {
		take_chain(r_blade);
	}
}

// Stores what a step has changed.
template <class T> GRASS_INLINE void store_blade(const StrainBlade<T> &p_blade, int p_first, TileState &r_state) {
	for (int n = 0; n < GRASS_STRAINS; n++) {
		store(p_blade.now.at[n], &r_state.strains[n][p_first]);
		store(p_blade.before.at[n], &r_state.strains_before[n][p_first]);
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const int free = k - GRASS_CLAMPED_KNOTS;
		store_knot(p_blade.places[k], r_state.knots, free, p_first);
		store_knot(p_blade.places_before[k], r_state.before, free, p_first);
		store(p_blade.twist[k - 1], &r_state.twist[free][p_first]);
	}
}

// Returns true if a step would change nothing: the blade is at rest, and nothing moves it.
template <class T> GRASS_INLINE auto is_resting(const StrainBlade<T> &p_blade, const StrainStep<T> &p_step) {
	T sum = sum_of(p_step.load);
	for (int n = 0; n < GRASS_STRAINS; n++) {
		sum = sum + (absolute(p_blade.now.at[n]) + absolute(p_blade.before.at[n]));
	}
	return sum <= T(0.0f);
}

// Takes one step, see TileStep.
template <class T> GRASS_INLINE float step_strains(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend) {
	StrainSection<T> section{};
	StrainStep<T> step{};
	float liveliest = 0.0f;
	for (int first = 0; first < GRASS_BLADES_PER_TILE - r_state.left_out; first += LANE_COUNT<T>) {
		if (first == 0 || p_steps.size() > 1) {
			step = make_strain_step<T>(p_steps, &r_state.species[first]);
			take_section(section, r_state.sections, p_steps.size() > 1, &r_state.species[first]);
		}
		StrainBlade<T> blade;
		load_blade(r_state, first, blade);
		StrainStep<T> own = step;
		if (r_state.air != nullptr) {
			const AirLoad &air = *r_state.air;
			own.load = own.load + Vec3<T>{ load<T>(&air.load[0][first]), load<T>(&air.load[1][first]), load<T>(&air.load[2][first]) };
			own.drag = own.drag + load<T>(&air.drag[first]) * T(p_steps[0].chain.x);
		}
		if (!any(!is_resting(blade, own))) {
			store_blade(blade, first, r_state);
			continue;
		}
		liveliest = std::max(liveliest, largest(strain_energy(blade, section, own)));
		take_free_step(blade, section, own, T(p_blend));
		store_blade(blade, first, r_state);
	}
	r_state.has_strains = true;
	return liveliest;
}

} // namespace grass

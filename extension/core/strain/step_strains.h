// SPDX-License-Identifier: MIT
// The step of a tile's free blades over any lane type; step_lanes.cpp, step_lanes_16.cpp and step_scalar.cpp instantiate it.
#pragma once

#include "core/solver/step_tile.h"
#include "core/strain/strain_tile.h"

namespace grass {

template <class T> GRASS_INLINE void take_step(StrainStep<T> &r_step, std::span<const StrainSpecies> p_all, const uint8_t *p_species) {
	const auto own = [&](vec4 GrassStep::*p_of, float vec4::*p_part) {
		alignas(64) float numbers[LANE_COUNT<T>];
		for (int lane = 0; lane < LANE_COUNT<T>; lane++) {
			numbers[lane] = p_all[p_all.size() > 1 ? p_species[lane] : 0].step.*p_of.*p_part;
		}
		return load<T>(numbers);
	};
	const T even = own(&GrassStep::chain, &vec4::z), seconds = T(p_all[0].step.chain.x);
	r_step.load = { own(&GrassStep::load, &vec4::x), own(&GrassStep::load, &vec4::y), own(&GrassStep::load, &vec4::z) };
	r_step.span = own(&GrassStep::free_motion, &vec4::x);
	r_step.ratio = T(p_all[0].step.chain.y);
	r_step.drag = own(&GrassStep::chain, &vec4::w) * seconds;
	r_step.bending = even * own(&GrassStep::free_motion, &vec4::z);
	r_step.swing = even * seconds * seconds * T(WILD * WILD);
	r_step.still_turns = T(p_all[0].step.pbd_motion.y);
	r_step.most_move = own(&GrassStep::load, &vec4::w);
	r_step.per_second = T(p_all[0].step.energy.x);
}

template <class T>
GRASS_INLINE void take_section(StrainSection<T> &r_section, std::span<const StrainSpecies> p_all, const uint8_t *p_species) {
	const auto own = [&](const auto &p_number) {
		alignas(64) float numbers[LANE_COUNT<T>];
		for (int lane = 0; lane < LANE_COUNT<T>; lane++) {
			numbers[lane] = p_number(p_all[p_all.size() > 1 ? p_species[lane] : 0].section);
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

// Loads blades from p_first on.
template <class T> GRASS_INLINE void load_blade(const TileState &p_tile, const StrainState &p_state, int p_first, StrainBlade<T> &r_blade) {
	const Vec3<T> width{ load<T>(&p_tile.width[0][p_first]), T(0.0f), load<T>(&p_tile.width[1][p_first]) };
	r_blade.length = load<T>(&p_state.lengths[p_first]);
	const T shorter = T(0.5f * float(GRASS_SEGMENTS)) / maximum(r_blade.length, T(1e-12f));
	for (int k = 0; k < GRASS_KNOTS; k++) {
		r_blade.rest[k] = load_knot<T>(p_tile.rest, k, p_first);
	}
	for (int s = 1; s <= GRASS_STRAIN_JOINTS; s++) {
		r_blade.axes[s] = joint_axes(r_blade.rest[s] - r_blade.rest[s - 1], r_blade.rest[s + 1] - r_blade.rest[s], width, shorter);
	}
	for (int n = 0; n < GRASS_STRAINS; n++) {
		r_blade.now.at[n] = load<T>(&p_state.strains[n][p_first]);
		r_blade.before.at[n] = load<T>(&p_state.before[n][p_first]);
	}
	for (int i = 0; i < GRASS_STRAIN_MASSES; i++) {
		const int knot = GRASS_STRAIN_FIRST_MASS + 2 * i;
		r_blade.offsets[knot] = load_knot<T>(p_state.offsets, knot - GRASS_CLAMPED_KNOTS, p_first);
		r_blade.masses_before[i] = load_knot<T>(p_state.masses_before, i, p_first);
	}
}

// Stores what a step has changed.
template <class T> GRASS_INLINE void store_blade(const StrainBlade<T> &p_blade, int p_first, StrainState &r_state) {
	for (int n = 0; n < GRASS_STRAINS; n++) {
		store(p_blade.now.at[n], &r_state.strains[n][p_first]);
		store(p_blade.before.at[n], &r_state.before[n][p_first]);
	}
	for (int i = 0; i < GRASS_STRAIN_MASSES; i++) {
		store_knot(p_blade.masses_before[i], r_state.masses_before, i, p_first);
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		store_knot(p_blade.offsets[k], r_state.offsets, k - GRASS_CLAMPED_KNOTS, p_first);
	}
}

template <class T>
GRASS_INLINE float step_strains_of(const TileState &p_tile, StrainState &r_state, std::span<const StrainSpecies> p_species, float p_blend) {
	StrainStep<T> step{};
	StrainSection<T> section{};
	float liveliest = 0.0f;
	for (int first = 0; first < GRASS_BLADES_PER_TILE - p_tile.left_out; first += LANE_COUNT<T>) {
		if (first == 0 || p_species.size() > 1) {
			take_step(step, p_species, &p_tile.species[first]);
			take_section(section, p_species, &p_tile.species[first]);
		}
		StrainBlade<T> blade;
		load_blade(p_tile, r_state, first, blade);
		StrainStep<T> own = step;
		if (p_tile.air != nullptr) {
			const float(&load_of)[3][GRASS_BLADES_PER_TILE] = p_tile.air->load;
			own.load = own.load + Vec3<T>{ load<T>(&load_of[0][first]), load<T>(&load_of[1][first]), load<T>(&load_of[2][first]) };
			own.drag = own.drag + load<T>(&p_tile.air->drag[first]) * T(p_species[0].step.chain.x);
		}
		liveliest = std::max(liveliest, largest(strain_energy(blade, section, own)));
		take_free_step(blade, section, own, T(p_blend));
		store_blade(blade, first, r_state);
	}
	return liveliest;
}

} // namespace grass

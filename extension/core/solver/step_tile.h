// SPDX-License-Identifier: MIT
// The step of a tile's blades over any lane type; step_lanes.cpp, step_lanes_16.cpp and step_scalar.cpp instantiate it.
#pragma once

#include "core/solver/solver.h"
#include "core/solver/tile_lanes.h"
#if GRASS_KNOTS == 16 // shaders/strain/basis.inc has no other table
#include "core/solver/strain/step_strains.h"
#endif

#include <algorithm>

namespace grass {

// Loads knots and twists.
template <class T> GRASS_INLINE void load_chain(const TileState &p_state, const LaneBlades<T> &p_blades, Blade<T> &r_blade) {
	for (int k = 0; k < GRASS_KNOTS; k++) {
		const int free = k - GRASS_CLAMPED_KNOTS;
		r_blade.rest[k] = load_knot(p_state.rest, k, p_blades);
		r_blade.knots[k] = free < 0 ? r_blade.rest[k] : load_knot(p_state.knots, free, p_blades);
		r_blade.before[k] = free < 0 ? r_blade.rest[k] : load_knot(p_state.before, free, p_blades);
		if (free >= 0) {
			r_blade.twist[k - 1] = load_own(p_state.twist[free], p_blades);
		}
	}
}

template <class T> GRASS_INLINE void store_chain(const Blade<T> &p_blade, const LaneBlades<T> &p_blades, TileState &r_state) {
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const int free = k - GRASS_CLAMPED_KNOTS;
		store_knot(p_blade.knots[k], r_state.knots, free, p_blades);
		store_knot(p_blade.before[k], r_state.before, free, p_blades);
		store_own(p_blade.twist[k - 1], r_state.twist[free], p_blades);
	}
}

// Sets the terms that depend on the species. p_species: by blade of the tile.
template <class T>
GRASS_INLINE void take_species(
		StepTerms<T> &r_terms, std::span<const GrassStep> p_steps, const uint8_t *p_species, const LaneBlades<T> &p_blades) {
	const auto own = [&](vec4 GrassStep::*p_of, float vec4::*p_part) { return own_number(p_steps, p_species, p_blades, p_part, p_of); };
	r_terms.keep = own(&GrassStep::pbd_motion, &vec4::x);
	r_terms.pull = own(&GrassStep::pbd_motion, &vec4::y);
	r_terms.pull_root = own(&GrassStep::pbd_motion, &vec4::z);
	r_terms.load = { own(&GrassStep::load, &vec4::x), own(&GrassStep::load, &vec4::y), own(&GrassStep::load, &vec4::z) };
	const T even = own(&GrassStep::chain, &vec4::z);
	r_terms.bending = even * own(&GrassStep::free_motion, &vec4::z);
	r_terms.drag = own(&GrassStep::chain, &vec4::w);
	r_terms.free_span = own(&GrassStep::free_motion, &vec4::x);
	r_terms.thins = own(&GrassStep::free_motion, &vec4::y);
	r_terms.first_joint = own(&GrassStep::free_motion, &vec4::w);
	r_terms.wild_move = T(WILD * p_steps[0].chain.x) * square_root(even);
	r_terms.energy_at_tip = own(&GrassStep::energy, &vec4::y);
	r_terms.energy_at_root = own(&GrassStep::energy, &vec4::z);
	r_terms.stiffer = own(&GrassStep::energy, &vec4::w);
}

// [Eq W6] Adds the effect of forces.
template <class T> GRASS_INLINE void add_air_load(StepTerms<T> &r_terms, const AirLoad &p_air, const LaneBlades<T> &p_blades) {
	const Vec3<T> accelerated = { load_own(p_air.load[0], p_blades), load_own(p_air.load[1], p_blades), load_own(p_air.load[2], p_blades) };
	const T drag = load_own(p_air.drag, p_blades);
	r_terms.load = r_terms.load + accelerated * (r_terms.is_direct ? T(1.0f) : r_terms.free_span * r_terms.free_span);
	r_terms.drag = r_terms.drag + drag;
	r_terms.keep = r_terms.keep / (T(1.0f) + drag * r_terms.seconds);
}

// Loads blades. Returns p_terms, those of the tile, as these blades have them.
template <class T>
GRASS_INLINE StepTerms<T> load_blades(const TileState &p_state, std::span<const GrassStep> p_steps, const StepTerms<T> &p_terms,
		const LaneBlades<T> &p_blades, Blade<T> &r_blade) {
	load_chain(p_state, p_blades, r_blade);
	r_blade.width = { load_own(p_state.width[0], p_blades), T(0.0f), load_own(p_state.width[1], p_blades) };
	r_blade.root = { load_own(p_state.root[0], p_blades), load_own(p_state.root[1], p_blades), load_own(p_state.root[2], p_blades) };
	r_blade.calm = load_own(p_state.calm, p_blades);
	StepTerms<T> terms = p_terms;
	if (p_steps.size() > 1) {
		take_species(terms, p_steps, p_state.species, p_blades);
	}
	if (p_state.air != nullptr) {
		add_air_load(terms, *p_state.air, p_blades);
	}
	return terms;
}

template <class T>
GRASS_INLINE float step_tile(
		TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
#if GRASS_KNOTS == 16
	if (r_state.sections != nullptr && p_steps[0].contact.x >= 1.0f) {
		return step_strains<T>(r_state, p_steps, p_blend);
	}
#endif
	r_state.has_strains = r_state.has_strains && r_state.sections != nullptr; // they stay where no time passes
	const StepTerms<T> terms = make_terms<T>(p_steps[0], p_blend, p_colliders, r_state.is_far);
	const BladeOrder order = apart<T>([&]() GRASS_APART {
		return find_order<T>(GRASS_BLADES_PER_TILE - r_state.left_out, [&](const LaneBlades<T> &p_blades) GRASS_APART {
			Blade<T> blade;
			const StepTerms<T> own = load_blades(r_state, p_steps, terms, p_blades, blade);
			measure_lengths(blade);
			return find_work(blade, own);
		});
	});
	float liveliest = 0.0f;
	for (int first = 0; first < order.count; first += LANE_COUNT<T>) {
		const LaneBlades<T> blades(&order.blades[first]);
		Blade<T> blade;
		const StepTerms<T> own = load_blades(r_state, p_steps, terms, blades, blade);
		liveliest = std::max(liveliest, largest(measure_energy(blade, own)));
		step_blade(blade, own);
		store_own(blade.calm, r_state.calm, blades);
		store_chain(blade, blades, r_state);
	}
	return liveliest;
}

} // namespace grass

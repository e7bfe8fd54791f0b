// SPDX-License-Identifier: MIT
// The step of a tile's blades by their strains over any lane type. core/solver/step_tile.h takes it where there are TileState::sections.
#pragma once

#include "core/solver/strain/strain.h"
#include "core/solver/tile_lanes.h"

namespace grass {

// p_species: by blade of the tile.
template <class T>
GRASS_INLINE StrainStep<T> make_strain_step(std::span<const GrassStep> p_steps, const uint8_t *p_species, const LaneBlades<T> &p_blades) {
	const auto own = [&](vec4 GrassStep::*p_of, float vec4::*p_part) { return own_number(p_steps, p_species, p_blades, p_part, p_of); };
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

// p_species: by blade of the tile.
template <class T>
GRASS_INLINE void take_section(StrainSection<T> &r_section, const StrainSection<float> *p_all, bool p_has_species, const uint8_t *p_species,
		const LaneBlades<T> &p_blades) {
	const auto own = [&](const auto &p_number) {
		alignas(64) float numbers[LANE_COUNT<T>];
		for (int lane = 0; lane < LANE_COUNT<T>; lane++) {
			numbers[lane] = p_number(p_all[p_has_species ? p_species[p_blades.at[lane]] : 0]);
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

template <class T> GRASS_INLINE void load_strains(const TileState &p_state, const LaneBlades<T> &p_blades, StrainBlade<T> &r_blade) {
	const Vec3<T> width{ load_own(p_state.width[0], p_blades), T(0.0f), load_own(p_state.width[1], p_blades) };
	for (int k = 0; k < GRASS_KNOTS; k++) {
		r_blade.rest[k] = load_knot(p_state.rest, k, p_blades);
	}
	r_blade.length = length(r_blade.rest[1] - r_blade.rest[0]) / T(float(GRASS_CLAMP_SHARE));
	const T shorter = T(0.5f) / maximum(r_blade.length * T(float(GRASS_SEGMENT_SHARE)), T(1e-12f));
	Joint<T> joint = clamp_of(r_blade);
	for (int s = 1; s <= GRASS_STRAIN_JOINTS; s++) {
		go_to_joint(joint, r_blade, s);
		r_blade.axes[s] = joint_axes(joint.below, joint.above, width, shorter);
	}
	for (int n = 0; n < GRASS_STRAINS; n++) {
		r_blade.now.at[n] = load_own(p_state.strains[n], p_blades);
		r_blade.before.at[n] = load_own(p_state.strains_before[n], p_blades);
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const int free = k - GRASS_CLAMPED_KNOTS;
		r_blade.places[k] = load_knot(p_state.knots, free, p_blades);
		r_blade.places_before[k] = load_knot(p_state.before, free, p_blades);
		r_blade.twist[k - 1] = load_own(p_state.twist[free], p_blades);
	}
	if (!p_state.has_strains) {
		take_chain(r_blade);
	}
}

// Stores what a step has changed.
template <class T> GRASS_INLINE void store_strains(const StrainBlade<T> &p_blade, const LaneBlades<T> &p_blades, TileState &r_state) {
	for (int n = 0; n < GRASS_STRAINS; n++) {
		store_own(p_blade.now.at[n], r_state.strains[n], p_blades);
		store_own(p_blade.before.at[n], r_state.strains_before[n], p_blades);
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const int free = k - GRASS_CLAMPED_KNOTS;
		store_knot(p_blade.places[k], r_state.knots, free, p_blades);
		store_knot(p_blade.places_before[k], r_state.before, free, p_blades);
		store_own(p_blade.twist[k - 1], r_state.twist[free], p_blades);
	}
}

// Returns true if a step would change nothing: the blade is at rest, and nothing moves it.
template <class T> GRASS_INLINE auto is_resting(const TileState &p_state, const StrainStep<T> &p_step, const LaneBlades<T> &p_blades) {
	T sum = sum_of(p_step.load);
	for (int n = 0; n < GRASS_STRAINS; n++) {
		sum = sum + (absolute(load_own(p_state.strains[n], p_blades)) + absolute(load_own(p_state.strains_before[n], p_blades)));
	}
	return sum <= T(0.0f);
}

// [Eq W6]
template <class T>
GRASS_INLINE void add_air_load(StrainStep<T> &r_step, const AirLoad &p_air, const T &p_seconds, const LaneBlades<T> &p_blades) {
	r_step.load = r_step.load +
			Vec3<T>{ load_own(p_air.load[0], p_blades), load_own(p_air.load[1], p_blades), load_own(p_air.load[2], p_blades) };
	r_step.drag = r_step.drag + load_own(p_air.drag, p_blades) * p_seconds;
}

// Takes one step, see TileStep.
template <class T> GRASS_INLINE float step_strains(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend) {
	const bool has_species = p_steps.size() > 1;
	const uint8_t first_blades[LANE_COUNT<T>] = {};
	const LaneBlades<T> any_blades(first_blades);
	const StrainStep<T> step = make_strain_step(p_steps, r_state.species, any_blades);
	StrainSection<T> section;
	take_section(section, r_state.sections, has_species, r_state.species, any_blades);
	const auto step_of = [&](const LaneBlades<T> &p_blades) GRASS_APART {
		StrainStep<T> own = has_species ? make_strain_step(p_steps, r_state.species, p_blades) : step;
		if (r_state.air != nullptr) {
			add_air_load(own, *r_state.air, T(p_steps[0].chain.x), p_blades);
		}
		return own;
	};
	const BladeOrder order = find_order<T>(GRASS_BLADES_PER_TILE - r_state.left_out, [&](const LaneBlades<T> &p_blades) GRASS_APART {
		const T moving = T(float(WORK_FREE));
		return r_state.has_strains ? select(is_resting(r_state, step_of(p_blades), p_blades), T(float(WORK_NONE)), moving) : moving;
	});
	float liveliest = 0.0f;
	for (int first = 0; first < order.count; first += LANE_COUNT<T>) {
		const LaneBlades<T> blades(&order.blades[first]);
		const StrainStep<T> own = step_of(blades);
		if (has_species) {
			take_section(section, r_state.sections, has_species, r_state.species, blades);
		}
		StrainBlade<T> blade;
		load_strains(r_state, blades, blade);
		const MassMotion<T> motion = mass_motion(blade, section);
		liveliest = std::max(liveliest, largest(strain_energy(blade, section, own, motion)));
		take_free_step(blade, section, own, motion, T(p_blend));
		store_strains(blade, blades, r_state);
	}
	r_state.has_strains = true;
	return liveliest;
}

} // namespace grass

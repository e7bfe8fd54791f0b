// SPDX-License-Identifier: MIT
#include "core/solver/solver_params.h"

#include "core/base/functions.h"
#include "core/solver/constants.h"
#include "core/solver/section.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace grass {

namespace {

// A damped oscillator without load: x'' = -w^2 x - 2 a x'.
struct Oscillator {
	double w, a; // 1/s

	// Contributions of the position at 0 (cosine) and of the speed at 0 (sine) to the position at t, without the factor exp(-a t).
	double cosine(double p_t) const {
		const double q = w * w - a * a;
		return q >= 0.0 ? grass::cosine(std::sqrt(q) * p_t) : hyperbolic_cosine(std::sqrt(-q) * p_t);
	}
	double sine(double p_t) const {
		const double q = w * w - a * a;
		if (std::abs(q) * p_t * p_t < 1e-12) {
			return p_t;
		}
		return q >= 0.0 ? grass::sine(std::sqrt(q) * p_t) / std::sqrt(q) : hyperbolic_sine(std::sqrt(-q) * p_t) / std::sqrt(-q);
	}
};

// Largest turn of a swing between two steps, radians.
constexpr double MOST_TURN = 2.5;
// First frequency of a uniform cantilever (radians per second), divided by the root of EI / (density area length^4).
constexpr double FIRST_MODE = 3.5160152685;
static_assert(WILD > FIRST_MODE - 1e-3 && WILD < FIRST_MODE + 1e-3);
// Turn of the first mode in a step up to which its frequency is exact, radians.
constexpr double EXACT_TURN = 1.0;

// [Eq 8] x(t+h) = x + keep (x - x(t-g)) - pull x holds exactly for the oscillator; h now, g the step before.
struct TwoStep {
	double keep, pull;
};

TwoStep two_step(const Oscillator &p_swing, double p_h, double p_g) {
	// Beyond a quarter of a swing, two positions no longer determine a speed.
	const double ratio = p_swing.sine(p_h) / p_swing.sine(p_g);
	const double keep = exponential(-p_swing.a * (p_h + p_g)) * ratio;
	const double stay = exponential(-p_swing.a * p_h) * (p_swing.cosine(p_h) + ratio * p_swing.cosine(p_g));
	return { keep, 1.0 + keep - stay };
}

constexpr double RADIANS_PER_CYCLE = 2.0 * std::numbers::pi;

// Sets GrassStep::free_motion, and load.xyz and pbd_motion.x for METHOD_DIRECT. p_h: seconds of the step, p_g: of the one before.
void set_direct_motion(GrassStep &r_step, const SolverParams &p_params, double p_h, double p_g) {
	// [Eq 39] Two positions give the speed in the middle of the step before; forces act from there to the middle of this step.
	const double half_turn = 0.5 * std::min(RADIANS_PER_CYCLE * p_params.natural_frequency * p_h, EXACT_TURN);
	r_step.free_motion.x = float(std::sqrt(0.5 * p_h * (p_h + p_g)) * std::tan(half_turn) / half_turn);
	const Section section = make_section(p_params.taper);
	r_step.free_motion.y = float(section.thins);
	r_step.free_motion.z = float(section.stiffness);
	r_step.free_motion.w = float(section.first_joint);
	r_step.load = { float(p_params.load[0]), float(p_params.load[1]), float(p_params.load[2]), 0.0f };
	r_step.pbd_motion.x = float(p_params.contact_rate / CONTACT_RATE.minimum);
}

// Sets GrassStep::pbd_motion, and load.xyz for METHOD_PBD.
void set_pbd_motion(GrassStep &r_step, const SolverParams &p_params, double p_h, double p_g) {
	const double swing = RADIANS_PER_CYCLE * p_params.natural_frequency, damping = p_params.damping_ratio * swing;
	// Two positions more than MOST_TURN of a swing apart no longer determine a speed: there, stiffer blades swing slower.
	const Oscillator tip{ std::min(swing, MOST_TURN / std::max(p_h, p_g)), damping };
	const Oscillator root{ tip.w * p_params.root_stiffness, damping };
	const TwoStep at_tip = two_step(tip, p_h, p_g), at_root = two_step(root, p_h, p_h);
	// [Eq 9] One minus the share that is left after all iterations, for each iteration.
	const double bend = RADIANS_PER_CYCLE * p_params.bend_stiffness * p_h;
	r_step.pbd_motion = { float(at_tip.keep), float(at_tip.pull), float(std::max(at_root.pull - two_step(tip, p_h, p_h).pull, 0.0)),
		float(1.0 - exponential(-bend * bend / p_params.iterations)) };
	const double weight = at_tip.pull / (tip.w * tip.w);
	r_step.free_motion.x = float(std::sqrt(weight));
	r_step.load = { float(p_params.load[0] * weight), float(p_params.load[1] * weight), float(p_params.load[2] * weight), 0.0f };
}

double or_zero(double p_value) {
	return std::isfinite(p_value) ? p_value : 0.0;
}

} // namespace

SolverParams SolverParams::sanitised() const {
	SolverParams params;
	params.method = method;
	params.natural_frequency = NATURAL_FREQUENCY.clamp(natural_frequency);
	params.damping_ratio = DAMPING_RATIO.clamp(damping_ratio);
	params.taper = TAPER.clamp(taper);
	params.width_to_thickness = WIDTH_TO_THICKNESS.clamp(width_to_thickness);
	params.root_stiffness = ROOT_STIFFNESS.clamp(root_stiffness);
	params.bend_stiffness = BEND_STIFFNESS.clamp(bend_stiffness);
	params.friction = FRICTION.clamp(friction);
	params.swing_speed_max = SWING_SPEED_MAX.clamp(swing_speed_max);
	params.iterations = int(ITERATIONS.clamp(iterations));
	params.contact_rate = CONTACT_RATE.minimum;
	while (params.contact_rate < CONTACT_RATE.clamp(contact_rate)) {
		params.contact_rate *= 2.0;
	}
	for (int i = 0; i < 3; i++) {
		params.load[i] = std::clamp(or_zero(load[i]), -MAX_LOAD, MAX_LOAD);
	}
	return params;
}

double SolverParams::energy_within(double p_distance) const {
	const double speed = RADIANS_PER_CYCLE * sanitised().natural_frequency * p_distance;
	return 0.5 * speed * speed / GRASS_FREE_KNOTS;
}

double SolverParams::calm_time() const {
	const SolverParams params = sanitised();
	return std::clamp(std::log(100.0) / std::max(RADIANS_PER_CYCLE * params.natural_frequency * params.damping_ratio, 1e-6), 1.0, 10.0);
}

GrassStep StepClock::advance(const SolverParams &p_params, double p_delta) {
	const bool passes = p_delta > 0.0 && std::isfinite(p_delta);
	if (passes) {
		const double h = std::clamp(p_delta, 1e-5, MAX_STEP);
		follow_load(p_params.sanitised().load);
		_delta_before = _last > 0.0 ? _last : h;
		_delta = _last = h;
	} else {
		_delta = 0.0;
	}
	return repeat(p_params);
}

// Finds the jump of the load: how far it is from where its last slope, or twice that, would have led it. So a smooth load has none.
void StepClock::follow_load(const double (&p_load)[3]) {
	for (int i = 0; i < 3; i++) {
		const double slope = _last > 0.0 ? (p_load[i] - _load[i]) / _last : 0.0, before = std::exchange(_load_slope[i], slope);
		const double steady = slope * before > 0.0 ? std::copysign(std::min(std::abs(slope), 2.0 * std::abs(before)), slope) : 0.0;
		_load_jump[i] = (slope - steady) * _last;
		_load[i] = p_load[i];
	}
}

GrassStep StepClock::repeat(const SolverParams &p_params) const {
	SolverParams params = p_params.sanitised();
	GrassStep step;
	if (_delta <= 0.0) {
		return step;
	}
	const double h = _delta, g = _delta_before, swing = RADIANS_PER_CYCLE * params.natural_frequency;
	bool jumps = false;
	for (int i = 0; i < 3; i++) {
		params.load[i] -= _load_jump[i] * (g / (h + g));
		jumps = jumps || _load_jump[i] != 0.0;
	}
	if (params.method == Method::DIRECT) {
		set_direct_motion(step, params, h, g);
		step.pbd_motion.y = jumps ? 1.0f : float(h / (h + g));
	} else {
		set_pbd_motion(step, params, h, g);
	}
	step.load.w = float(params.swing_speed_max * g);
	step.contact = { float(params.iterations), float(params.friction), float(GROUND_GAP), float(params.method) };
	step.chain = { float(h), float(h / g), float(swing * swing / (FIRST_MODE * FIRST_MODE)), float(2.0 * params.damping_ratio * swing) };
	const double at_root_more = params.root_stiffness * params.root_stiffness - 1.0;
	step.energy = { float(1.0 / (g * g)), float(swing * swing), float(swing * swing * at_root_more),
		float(std::sqrt(params.width_to_thickness * params.width_to_thickness - 1.0)) };
	return step;
}

} // namespace grass

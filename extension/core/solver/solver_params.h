// SPDX-License-Identifier: MIT
// The solver's parameters that a user sets, in physical units, and how the coefficients of a step follow from them, from the time step and
// from the number of iterations. docs/internals/solver.md, [Eq 8] and [Eq 9].
#pragma once

#include "core/base/layout.h"
#include "core/base/tunable.h"

namespace grass {

// Swings per second of a bent blade without damping: its material, section and length in one number. Below 0.3 grass stays down for
// seconds; above 5 it snaps back.
inline constexpr Tunable NATURAL_FREQUENCY{ "natural_frequency", "Hz", 0.1, 10.0, 0.05, 1.2 };
// How fast a swing dies down: 0 never, 1 without overshooting. Below 0.1 grass nods for seconds; above 1.5 it returns slowly.
inline constexpr Tunable DAMPING_RATIO{ "damping_ratio", "", 0.0, 3.0, 0.01, 0.5 };
// Share of its width that a blade loses from root to tip; the tip becomes softer and lighter accordingly. 0: uniform. Higher: the tip bends
// more and the root less.
inline constexpr Tunable TAPER{ "taper", "", 0.0, 0.9, 0.01, 0.3 };
// Ratio of a blade's width to its thickness at the root. A blade is stiffer in its plane than across it by the square of this ratio. 1: a
// stalk, which bends equally in all directions. Higher: a blade pushed sideways twists before it bends.
inline constexpr Tunable WIDTH_TO_THICKNESS{ "width_to_thickness", "x", 1.0, 20.0, 0.1, 2.0 };
// METHOD_PBD: frequency at the root, relative to the tip's. 1: the blade rises as a whole; more: the root rises first and the tip after it.
inline constexpr Tunable ROOT_STIFFNESS{ "root_stiffness", "x", 1.0, 4.0, 0.1, 1.6 };
// METHOD_PBD: swings per second of a single kinked joint. Below 2 contacts leave kinks; above 20 nothing changes any more.
inline constexpr Tunable BEND_STIFFNESS{ "bend_stiffness", "Hz", 0.0, 30.0, 0.1, 8.0 };
// Factor on the friction of bodies. 0: blades slide freely.
inline constexpr Tunable FRICTION{ "friction", "x", 0.0, 4.0, 0.05, 1.0 };
// METHOD_DIRECT: the solves in one step of a blade near something; with 1 it may tremble. Other blades take one. METHOD_PBD: rounds of
// local shape and contact; the paper found two or three enough; with 1 knots rest on each other's contacts.
inline constexpr Tunable ITERATIONS{ "iterations", "", 1.0, 10.0, 1.0, 2.0, true };
// METHOD_DIRECT: how often in a second contact with moving bodies is solved, at most. More: single blades follow bodies more exactly, and
// take as much more time. It needs two iterations or more. A step is halved again and again, so a rate counts as the next of 400, 800, 1600
// and so on.
inline constexpr Tunable CONTACT_RATE{ "contact_rate", "Hz", 400.0, 12800.0, 400.0, 400.0 };
// How far from an eye contact_rate applies, to the middle of a tile; 0: everywhere. Farther: more blades take as much more time.
inline constexpr Tunable CONTACT_DISTANCE{ "contact_distance", "m", 0.0, 100.0, 0.1, 4.0 };
// Greatest speed of a knot that swings freely, blade lengths per second. Below 5 grass looks sticky.
inline constexpr Tunable SWING_SPEED_MAX{ "swing_speed_max", "1/s", 1.0, 100.0, 1.0, 40.0 };

// How a blade is solved. docs/internals/solver.md compares them.
enum class Method { DIRECT = GRASS_METHOD_DIRECT, PBD = GRASS_METHOD_PBD };

struct SolverParams {
	Method method = Method::DIRECT;
	double natural_frequency = NATURAL_FREQUENCY.initial; // Hz
	double damping_ratio = DAMPING_RATIO.initial;
	double taper = TAPER.initial;
	double width_to_thickness = WIDTH_TO_THICKNESS.initial;
	double root_stiffness = ROOT_STIFFNESS.initial;
	double bend_stiffness = BEND_STIFFNESS.initial; // Hz
	double friction = FRICTION.initial;
	double swing_speed_max = SWING_SPEED_MAX.initial; // blade lengths per second
	int iterations = int(ITERATIONS.initial);
	double contact_rate = CONTACT_RATE.initial; // Hz
	// m/s^2 on every knot as a step begins, in addition to the gravity that the rest pose already includes.
	double load[3] = { 0.0, 0.0, 0.0 };

	// [Eq S1] Returns the energy up to which no knot of a blade is farther than p_distance (metres) from rest, and none is fast enough to
	// swing farther. J/kg.
	double energy_within(double p_distance) const;
	// [Eq S2] Returns the seconds in which a swing dies down to a hundredth, 1 to 10.
	double calm_time() const;
	// Returns the same parameters within the tunables' ranges; a value that is not a number becomes the default.
	SolverParams sanitised() const;
};

// Greatest load in any direction, m/s^2.
inline constexpr double MAX_LOAD = 1000.0;
// Longer steps (a frame that took half a second) are shortened to this: seconds.
inline constexpr double MAX_STEP = 0.1;
// Gap between a free knot and the ground, segment lengths.
inline constexpr double GROUND_GAP = 0.02;

// Converts parameters and elapsed seconds to the coefficients of a step. Remembers the step before, in which Verlet's displacement was
// made. Leaves `field` and `clump` of the result to the caller.
class StepClock {
public:
	// Returns the coefficients of the next step. p_delta: seconds; if 0, negative or not finite, no time passes.
	GrassStep advance(const SolverParams &p_params, double p_delta);
	// Returns the step of the last advance() for blades with other parameters.
	GrassStep repeat(const SolverParams &p_params) const;
	void reset() { *this = StepClock(); }

private:
	// [Eq 22] Finds by how much the load has jumped.
	void follow_load(const double (&p_load)[3]);

	double _delta = 0.0; // of the last advance(), seconds; 0: no time passed in it
	double _delta_before = 0.0; // of the step before that one, or else its own
	double _last = 0.0; // of the last one in which time passed; 0: none yet
	double _load[3]{}, _load_slope[3]{}; // as that step began, m/s^2; its change in the step before, m/s^3
	double _load_jump[3]{}; // m/s^2, as that step began
};

} // namespace grass

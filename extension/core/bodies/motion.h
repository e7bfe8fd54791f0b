// SPDX-License-Identifier: MIT
// Distinguishes motion from teleports. A body that moved from one place to another bends the grass between; one that was put there does
// not.
#pragma once

#include "core/base/tunable.h"

#include <Eigen/Geometry>

#include <limits>

namespace grass {

// A body that changes its place faster, without a reason to, was put there. At 60 ticks per second the default is 2 m a tick. Lower:
// scripted bodies that start fast leave a gap. Higher: short teleports mow.
inline constexpr Tunable TELEPORT_SPEED{ "teleport_speed", "m/s", 1.0, 10000.0, 1.0, 120.0 };

// The properties of a tick that are needed to judge motion.
struct MotionTick {
	double delta = 1.0 / 60.0; // seconds
	double teleport_speed = TELEPORT_SPEED.initial; // metres per second
	// The box in which bodies are watched; nothing is known of bodies outside it. Infinite unless set.
	Eigen::AlignedBox3d watched{ Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity()),
		Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()) };
};

// The motion of one body from one tick to the next. Places in metres, velocities in metres per second.
//
// A change of place is motion if it is slow, if the body's own velocity explains it, or if it resembles the motion before. Any other change
// is a jump, and the next change of place decides: if it resembles the jump, both were motion, and the path begins where the jump began.
// Otherwise the jump was a teleport.
class Motion {
public:
	// Starts with a body found at p_place. p_seen: its motion in the tick before; p_own: the velocity that the body itself reports; zero
	// where unknown. Returns where the path of this tick begins; p_place if there is no path.
	Eigen::Vector3d start(
			const Eigen::Vector3d &p_place, const Eigen::Vector3d &p_seen, const Eigen::Vector3d &p_own, const MotionTick &p_tick);
	// Returns whether a step, metres, is motion whatever the velocity of the body is, so that the caller need not read it.
	bool expects(const Eigen::Vector3d &p_step, const MotionTick &p_tick) const;
	// Follows the body from p_before to p_now. Returns where the path of this tick begins: at p_before as a rule, at p_now after a
	// teleport, and at an earlier place when a jump turns out to have been motion.
	Eigen::Vector3d follow(
			const Eigen::Vector3d &p_before, const Eigen::Vector3d &p_now, const Eigen::Vector3d &p_own, const MotionTick &p_tick);
	// Returns whether a turn of the body by an angle, radians, is motion. p_own: the angle by which its own angular velocity turns it in
	// the tick. Takes an angle instead of a speed, since a tick cannot show more than half a turn.
	bool follow_turn(double p_angle, double p_own);

	// Returns whether the next tick may still show that the body passed grass, even if it has left by then.
	bool is_open() const { return _is_new || (_still_time == 0.0 && (_is_jumping || !_velocity.isZero(0.0))); }

	// Returns whether the body has rested for so long that more rest changes nothing.
	bool is_at_rest() const;

	// The largest turn, radians, that needs no explanation.
	static constexpr double PLAUSIBLE_TURN = 0.5 * EIGEN_PI;

private:
	bool continues_jump(const Eigen::Vector3d &p_velocity) const;
	void stand_still(double p_delta);

	Eigen::Vector3d _velocity = Eigen::Vector3d::Zero(); // of the last motion
	Eigen::Vector3d _jump = Eigen::Vector3d::Zero(), _jump_from = Eigen::Vector3d::Zero(); // its velocity, and where it began
	double _last_turn = 0.0; // radians
	double _still_time = 0.0; // seconds
	bool _is_jumping = false; // the next change of place decides what the last one was
	bool _is_new = false; // found in the last tick; its motion is unknown
};

// Returns the axes of a limb whose y runs along p_axis, metres. They are as near to p_before as that allows, so that a limb that swings
// does not spin about itself. Returns p_before, which must be orthonormal, if p_axis has no direction.
Eigen::Matrix3d swing_axes(const Eigen::Matrix3d &p_before, const Eigen::Vector3d &p_axis);

} // namespace grass

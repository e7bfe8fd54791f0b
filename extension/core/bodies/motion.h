// SPDX-License-Identifier: MIT
// Tells motion from teleports. What moved from one place to another bends the grass between; what was put there does not.
#pragma once

#include "core/base/tunable.h"

#include <Eigen/Geometry>

#include <limits>

namespace grass {

// What changes its place faster, and nothing explains it, was put there. At 60 ticks per second the default is 2 m a tick.
// Slower: scripted bodies that start fast leave a gap. Faster: short teleports mow.
inline constexpr Tunable TELEPORT_SPEED{ "teleport_speed", "m/s", 1.0, 10000.0, 1.0, 120.0 };

// What a tick is, to whoever judges motion in it.
struct MotionTick {
	double delta = 1.0 / 60.0; // seconds
	double teleport_speed = TELEPORT_SPEED.initial; // metres per second
	// Nobody knows of bodies outside of it. Everything lies inside unless it is told.
	Eigen::AlignedBox3d watched{ Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity()),
		Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()) };
};

// The motion of one body from tick to tick. Places in metres, velocities in metres per second.
//
// A change of place is motion if it is slow, if the body's own velocity explains it, or if it is like the motion before it.
// What remains is a jump, and the next change of place decides: if it is like the jump, both were motion, and the path
// begins where the jump began. Otherwise the jump was a teleport.
class Motion {
public:
	// The body is found at p_place. p_seen: what it did in the tick before, p_own: the velocity that it says it has; zero where nobody
	// knows. Returns where the path of this tick begins; p_place if there is none.
	Eigen::Vector3d start(
			const Eigen::Vector3d &p_place, const Eigen::Vector3d &p_seen, const Eigen::Vector3d &p_own, const MotionTick &p_tick);
	// Whether a step, metres, is motion whatever the body's own velocity is. Spares the caller the look-up.
	bool expects(const Eigen::Vector3d &p_step, const MotionTick &p_tick) const;
	// The body went from p_before to p_now. Returns where the path of this tick begins: at p_before as a rule, at p_now after a
	// teleport, and at an earlier place when a jump turns out to have been motion.
	Eigen::Vector3d follow(
			const Eigen::Vector3d &p_before, const Eigen::Vector3d &p_now, const Eigen::Vector3d &p_own, const MotionTick &p_tick);
	// The body turned by an angle, radians; p_own: by how much its own angular velocity turns it in the tick. Whether the turn is motion.
	// An angle and not a speed: nobody sees more than half a turn in a tick.
	bool follow_turn(double p_angle, double p_own);

	// Whether the next tick may still show that the body passed grass, even if it has left by then.
	bool is_open() const { return _is_new || (_still_time == 0.0 && (_is_jumping || !_velocity.isZero(0.0))); }

	// It has stood still for so long that standing still for longer changes nothing.
	bool is_at_rest() const;

	// Radians of a turn that need no reason.
	static constexpr double PLAUSIBLE_TURN = 0.5 * EIGEN_PI;

private:
	bool continues_jump(const Eigen::Vector3d &p_velocity) const;
	void stand_still(double p_delta);

	Eigen::Vector3d _velocity = Eigen::Vector3d::Zero(); // of the last motion
	Eigen::Vector3d _jump = Eigen::Vector3d::Zero(), _jump_from = Eigen::Vector3d::Zero(); // its velocity, and where it began
	double _last_turn = 0.0; // radians
	double _still_time = 0.0; // seconds
	bool _is_jumping = false; // the next change of place decides what the last one was
	bool _is_new = false; // found in the last tick, and nothing known of its motion
};

} // namespace grass

// SPDX-License-Identifier: MIT
#include "core/bodies/motion.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

// Share by which two velocities may differ and still count as alike. Smaller: a fast body that turns or brakes leaves a gap. Larger: a fast
// body may mow when it is teleported.
constexpr double ALIKE = 0.5;
// Seconds at rest after which earlier motion explains nothing. Bodies that are moved once a frame rest in the ticks between. Shorter: they
// leave gaps at low frame rates. Longer: two teleports in a row count as motion.
constexpr double MEMORY = 0.1;

// Returns whether p_velocity could be p_expected, or up to p_slack faster, in a tick in which something slowed, turned or stopped the body.
bool is_explained(const Eigen::Vector3d &p_velocity, const Eigen::Vector3d &p_expected, double p_slack) {
	const double square = p_expected.squaredNorm();
	const double along = square > 0.0 ? std::clamp(p_velocity.dot(p_expected) / square, 0.0, 1.0) : 0.0;
	return (p_velocity - along * p_expected).norm() <= p_slack + ALIKE * std::sqrt(square);
}

} // namespace

// A body that enters the watched box has been inside for one tick when it is found, so it entered one tick earlier. A body that appeared
// inside has been there for one tick.
Eigen::Vector3d Motion::start(
		const Eigen::Vector3d &p_place, const Eigen::Vector3d &p_seen, const Eigen::Vector3d &p_own, const MotionTick &p_tick) {
	*this = Motion();
	const Eigen::Vector3d step = p_seen * p_tick.delta;
	if (step.isZero(0.0) || !step.allFinite()) {
		_is_new = true;
		return p_place;
	}
	const Eigen::Vector3d from = p_place - (p_tick.watched.contains(p_place - 2.0 * step) ? 1.0 : 2.0) * step;
	if (is_explained(p_seen, p_own, 0.0)) {
		_velocity = p_seen;
		return from;
	}
	_jump = p_seen;
	_jump_from = from;
	_is_jumping = true;
	return p_place;
}

bool Motion::expects(const Eigen::Vector3d &p_step, const MotionTick &p_tick) const {
	const Eigen::Vector3d velocity = p_step / p_tick.delta;
	return p_step.isZero(0.0) || continues_jump(velocity) || is_explained(velocity, _velocity, p_tick.teleport_speed);
}

bool Motion::continues_jump(const Eigen::Vector3d &p_velocity) const {
	return _is_jumping && (p_velocity - _jump).norm() <= ALIKE * _jump.norm();
}

void Motion::stand_still(double p_delta) {
	_still_time += p_delta;
	if (_still_time > MEMORY) {
		_velocity.setZero();
		_is_jumping = false;
	}
}

Eigen::Vector3d Motion::follow(
		const Eigen::Vector3d &p_before, const Eigen::Vector3d &p_now, const Eigen::Vector3d &p_own, const MotionTick &p_tick) {
	const Eigen::Vector3d step = p_now - p_before, velocity = step / p_tick.delta;
	const bool is_new = _is_new;
	_is_new = false;
	if (step.isZero(0.0)) {
		stand_still(p_tick.delta);
		return p_before;
	}
	_still_time = 0.0;
	const bool was_motion = continues_jump(velocity);
	_is_jumping = false;
	if (was_motion || is_explained(velocity, _velocity, p_tick.teleport_speed) || is_explained(velocity, p_own, p_tick.teleport_speed)) {
		_velocity = velocity;
		return was_motion ? _jump_from : p_before;
	}
	_jump = velocity;
	_jump_from = is_new && !p_tick.watched.contains(p_before - step) ? Eigen::Vector3d(p_before - step) : p_before;
	_is_jumping = velocity.allFinite();
	return p_now;
}

bool Motion::is_at_rest() const {
	return !_is_new && _still_time > MEMORY;
}

bool Motion::follow_turn(double p_angle, double p_own) {
	const double explained = std::max(p_own, _last_turn);
	_last_turn = p_angle;
	return p_angle <= PLAUSIBLE_TURN + (1.0 + ALIKE) * explained;
}

Eigen::Matrix3d swing_axes(const Eigen::Matrix3d &p_before, const Eigen::Vector3d &p_axis) {
	const double length = p_axis.stableNorm();
	if (!(length > 0.0 && std::isfinite(length))) {
		return p_before;
	}
	const Eigen::Vector3d y = p_axis / length, x = p_before.col(0) - p_before.col(0).dot(y) * y;
	const bool turns_onto_x = x.squaredNorm() < 1e-6;
	Eigen::Matrix3d axes;
	axes.col(0) = turns_onto_x ? y.unitOrthogonal() : x.normalized();
	axes.col(1) = y;
	axes.col(2) = axes.col(0).cross(y);
	return axes;
}

} // namespace grass

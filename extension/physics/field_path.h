// SPDX-License-Identifier: MIT
// How a field moves from tick to tick, as far as it matters to the bodies in it: they may ride with it, follow it late, or stay where they
// are.
#pragma once

#include "shared/convert.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace grass {

class FieldPath {
public:
	// Must be called once in each tick. p_field: its transform (orthonormal).
	void move_to(const godot::Transform3D &p_field) {
		const Eigen::Affine3d now = to_eigen(p_field).inverse(Eigen::Isometry);
		_from_world_before = _has_before ? _from_world : now;
		_from_world = now;
		_has_before = true;
		_has_jumped = (_from_world_before * to_eigen(p_field.origin)).norm() > JUMP;
		const bool had_moved = _has_moved;
		_has_moved = _from_world.matrix() != _from_world_before.matrix();
		_has_begun = _has_moved && !had_moved;
		_ticks_since_jump = _has_jumped ? 0 : std::min(_ticks_since_jump, JUMP_TICKS) + 1;
	}
	// Must be called when time has passed without move_to().
	void forget() { _has_before = false; }

	const Eigen::Affine3d &get_from_world() const { return _from_world; }
	const Eigen::Affine3d &get_from_world_before() const { return _from_world_before; } // in the tick before
	bool has_jumped() const { return _has_jumped; } // in this tick
	bool has_just_jumped() const { return _ticks_since_jump <= 1; } // in this tick or the one before
	bool has_jumped_lately() const { return _ticks_since_jump < JUMP_TICKS; }
	bool has_moved() const { return _has_moved; } // since the tick before
	bool has_begun() const { return _has_begun; } // to move in this tick, after rest
	bool rests() const { return !_has_moved && _ticks_since_jump > JUMP_TICKS; }

	// A field that moves farther in a tick jumps, and the bodies in it may follow a tick late. Metres.
	static constexpr double JUMP = 2.0;

private:
	// Ticks after a jump for which bodies that the server reports as gone are kept, since kinematic ones follow late.
	static constexpr int JUMP_TICKS = 6;

	Eigen::Affine3d _from_world = Eigen::Affine3d::Identity(), _from_world_before = Eigen::Affine3d::Identity();
	bool _has_before = false, _has_jumped = false, _has_moved = false, _has_begun = false;
	int _ticks_since_jump = 1 << 30;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// The shapes of a body, and the colliders that are made of them in each tick.
#pragma once

#include "physics/body_motion.h"
#include "physics/physics_shapes.h"
#include "physics/server_body.h"

#include <godot_cpp/variant/string.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace grass {

// The colliders of a body among those of a tick.
struct BodyColliders {
	enum class State {
		STALE, // they must be written as a whole
		MOVING, // only their poses must be written
		STILL, // with a single pose, which holds as long as the body does not move
		AT_REST, // the same, and in the next tick everything else will be as in this one, too
	};

	// Sets where they begin. If they were elsewhere, they must be written again.
	void place(size_t p_first) {
		state = first == p_first ? state : State::STALE;
		first = uint32_t(p_first);
	}
	bool are_still() const { return state >= State::STILL; }

	State state = State::STALE;
	uint32_t first = 0, count = 0;
	int64_t mesh_pieces = 0; // of these
};

// Warns once for each field and kind of shape: a user may expect a moving body to bend grass, and with its own form.
class ShapeWarnings {
public:
	void warn_of(const ServerBody &p_body, const TrackedShape &p_shape);

private:
	std::array<bool, 3> _has_warned{}; // of a height map, a trimesh, a convex polygon
};

class BodyShapes {
public:
	bool is_empty() const { return _shapes.empty(); }
	void clear(BodyColliders &r_colliders); // for ground
	// Returns whether one is to be warned of once it moves.
	bool is_odd() const;
	// Reads changes of shapes and friction. Returns whether they must be read in the next tick too, since a shape often changes in several
	// ticks in a row.
	bool look(const ServerBody &p_body, BodyColliders &r_colliders, const BodyTick &p_tick);
	void look_at_all_soon() { _next_look_at_all = 0; }
	// Updates the scale of the body itself, which its pose contains in every tick.
	void fit_scale(const Eigen::Affine3d &p_now, BodyColliders &r_colliders);
	// Writes all enabled shapes to their places. Those far from the grass meet no tile.
	void write(const ServerBody &p_body, const BodyMotion &p_motion, const Eigen::Affine3d &p_now, BodyColliders &r_colliders,
			const BodyTick &p_tick);

private:
	bool read(const ServerBody &p_body, BodyColliders &r_colliders, const BodyTick &p_tick);
	bool read_one(const ServerBody &p_body, int32_t p_index, BodyColliders &r_colliders, const BodyTick &p_tick);
	void fit_part(ShapePart &r_part) const;

	std::vector<TrackedShape> _shapes; // from the last look; none while the body is ground
	Eigen::Vector3d _scale = Eigen::Vector3d::Ones(); // the body's own, which its shapes inherit; negative if it mirrors
	double _friction = 0.0; // of blades along it
	std::vector<bool> _disabled; // by shape
	int _next_look_at_all = 0; // looks until the next one at everything
	int _lively_looks = 0; // that remain in every tick
};

} // namespace grass

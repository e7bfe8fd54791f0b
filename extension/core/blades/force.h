// SPDX-License-Identifier: MIT
// Forces that move the air around a place: a blast, the downwash of a rotor, a vortex, the wind of an area. [Eq W4]
#pragma once

#include "core/base/layout.h"
#include "core/base/tunable.h"
#include "core/bodies/body_shape.h"

#include <Eigen/Core>

namespace grass {

// Speed of the air where a force is strongest. 3 stirs the grass, 10 bends it, 30 flattens it. Beyond 60 it gets no flatter.
inline constexpr Tunable FORCE_SPEED{ "speed", "m/s", -100.0, 100.0, 0.1, 20.0 };
// How far a force reaches. Its cost grows with the number of tiles that it wakes, so with the square of the radius.
inline constexpr Tunable FORCE_RADIUS{ "radius", "m", 0.1, 100.0, 0.05, 5.0 };
// How long a blast blows.
inline constexpr Tunable FORCE_DURATION{ "duration", "s", 0.05, 10.0, 0.05, 0.6 };
// Share by which the air of a lasting force swells and ebbs. 0: blades come to rest in it, and then cost no simulation.
inline constexpr Tunable FORCE_TURBULENCE{ "turbulence", "", 0.0, 1.0, 0.01, 0.35 };

enum class ForceKind {
	BLAST, // outwards from the centre, once: its front runs to the radius, then the air calms down
	DOWNWASH, // outwards from the centre, in a standing ring on the ground
	VORTEX, // around the centre, in a ring, and slightly inwards
	WIND, // in one direction, strongest at the centre
};

struct Force {
	ForceKind kind = ForceKind::BLAST;
	Eigen::Vector3d place = Eigen::Vector3d::Zero(); // field space, metres
	Eigen::Vector3d direction = Eigen::Vector3d::UnitX(); // of a WIND; any length but zero
	double speed = FORCE_SPEED.initial; // m/s
	double radius = FORCE_RADIUS.initial; // metres
	double duration = FORCE_DURATION.initial; // of a BLAST, seconds; of others 0: until removed, otherwise they fade within it
	double turbulence = FORCE_TURBULENCE.initial;
	double age = 0.0; // seconds since it began

	// Makes all values finite and brings them within their limits.
	void sanitise();
	bool is_ring() const { return kind == ForceKind::DOWNWASH || kind == ForceKind::VORTEX; }
	double swell() const { return kind == ForceKind::BLAST ? 0.0 : turbulence; } // share of its speed by which it swells
	bool is_over() const { return duration > 0.0 && age >= duration; }
	// Returns the speed of its air at its current age where it is strongest, m/s.
	double speed_now() const;
	// Returns the distance from its place, metres, beyond which its air is slower than GRASS_FORCE_WAKES; 0 if it is slower everywhere.
	double reach() const;
	// Returns the record for the shaders, relative to the tile of p_grid below the force.
	GrassForce pack(const TileGrid &p_grid) const;
	// Returns the shape that wakes tiles. p_index: index among the step's forces.
	ColliderShape make_shape(int p_index) const;
};

} // namespace grass

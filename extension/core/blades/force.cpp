// SPDX-License-Identifier: MIT
#include "core/blades/force.h"

#include "core/blades/glsl_texts.h"

#include <bit>
#include <cmath>
#include <numbers>

namespace grass {

namespace {

// Speed of a blast's front, m/s. Slow enough to be seen running outwards. Slower: a large blast ends before its front arrives.
constexpr double FRONT_SPEED = 40.0;
// How many times a second the air swells.
constexpr double BEATS = 1.3;
// Share of a vortex's air that flows inwards.
constexpr double INFLOW = 0.3;
// Every force but a blast rises within this time, seconds, or within this share of its duration. A sudden start would show as a jump.
constexpr double RISE = 0.25, RISE_SHARE = 0.1;

double finite(double p_value, double p_default) {
	return std::isfinite(p_value) ? p_value : p_default;
}

} // namespace

void Force::sanitise() {
	place = place.allFinite() ? place : Eigen::Vector3d::Constant(ColliderShape::MAX_POSITION);
	place = place.cwiseMax(-ColliderShape::MAX_POSITION).cwiseMin(ColliderShape::MAX_POSITION);
	const double length = direction.norm();
	direction = std::isfinite(length) && length > 1e-9 ? Eigen::Vector3d(direction / length) : Eigen::Vector3d(Eigen::Vector3d::UnitX());
	speed = FORCE_SPEED.clamp(speed);
	radius = FORCE_RADIUS.clamp(radius);
	duration = std::clamp(
			finite(duration, FORCE_DURATION.initial), kind == ForceKind::BLAST ? FORCE_DURATION.minimum : 0.0, FORCE_DURATION.maximum);
	turbulence = FORCE_TURBULENCE.clamp(turbulence);
	age = std::clamp(finite(age, 0.0), 0.0, 1e6);
}

double Force::speed_now() const {
	if (is_over()) {
		return 0.0;
	}
	const double left = duration > 0.0 ? 1.0 - age / duration : 1.0;
	const double rise = duration > 0.0 ? std::min(RISE, RISE_SHARE * duration) : RISE;
	return speed * left * left * (kind == ForceKind::BLAST ? 1.0 : std::min(age / rise, 1.0));
}

double Force::reach() const {
	const double most = std::abs(speed_now()) * (1.0 + swell()) * (kind == ForceKind::VORTEX ? std::hypot(1.0, INFLOW) : 1.0);
	if (most <= GRASS_FORCE_WAKES) {
		return 0.0;
	}
	// Search the farthest place where the profile, which falls from here on, still reaches this strength.
	const double wanted = GRASS_FORCE_WAKES / most;
	double inside = is_ring() ? std::sqrt(0.2) : 0.0, outside = 1.0;
	for (int i = 0; i < 12; i++) {
		const double share = 0.5 * (inside + outside), left = 1.0 - share * share;
		(left * left * (is_ring() ? GRASS_FORCE_RING * share : 1.0) > wanted ? inside : outside) = share;
	}
	return radius * outside;
}

GrassForce Force::pack(const TileGrid &p_grid) const {
	const TilePlace at = p_grid.get_place(place);
	const float strength = float(speed_now());
	const bool is_wind = kind == ForceKind::WIND, is_vortex = kind == ForceKind::VORTEX, is_blast = kind == ForceKind::BLAST;
	GrassForce force;
	force.anchor = { at.x, at.z, 0, 0 };
	force.place = { at.offset.x(), at.offset.y(), at.offset.z(), float(radius) };
	const Eigen::Vector3f blow = is_wind ? Eigen::Vector3f(direction.cast<float>() * strength) : Eigen::Vector3f(Eigen::Vector3f::Zero());
	force.blow = { blow.x(), blow.y(), blow.z(), is_wind ? 0.0f : (is_vortex ? -float(INFLOW) * strength : strength) };
	const double front = is_blast ? age * FRONT_SPEED + GRASS_FORCE_FRONT * radius : 1e6;
	force.ring = { is_vortex ? strength : 0.0f, is_ring() ? 1.0f : 0.0f, float(front), 0.0f };
	const double turn = 2.0 * std::numbers::pi;
	force.beat = { float(swell()), float(std::fmod(age * BEATS, 1.0) * turn), 0.0f, 0.0f };
	return force;
}

ColliderShape Force::make_shape(int p_index) const {
	const double reached = reach();
	ColliderShape shape;
	shape.type = GRASS_CYLINDER;
	shape.size = { reached, is_ring() ? 2.0 * radius : reached, reached };
	shape.now.position = shape.before.position = place;
	shape.force = p_index;
	shape.air = float(std::abs(speed_now()) * (1.0 + swell()));
	const bool is_steady = turbulence <= 0.0 && duration <= 0.0 && age >= 2.0 * RISE;
	shape.revision = uint64_t(kind);
	for (const double part : { speed, direction.x(), direction.y(), direction.z(), is_steady ? 0.0 : age }) {
		shape.revision = shape.revision * 1099511628211u + std::bit_cast<uint64_t>(part);
	}
	return shape;
}

} // namespace grass

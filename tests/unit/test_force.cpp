// SPDX-License-Identifier: MIT
// What forces do to the air, and which tiles they wake.
#include "core/blades/force.h"

#include "tile_scene.h"

#include "core/blades/glsl_texts.h"

#include <cmath>
#include <limits>
#include <numbers>

using namespace grass;
using namespace grass::test;

namespace {

constexpr ForceKind KINDS[] = { ForceKind::BLAST, ForceKind::DOWNWASH, ForceKind::VORTEX, ForceKind::WIND };
const TileGrid GRID = TileGrid::make(64.0, 64.0, 64.0);

Force make_force(ForceKind p_kind) {
	Force force;
	force.kind = p_kind;
	force.duration = p_kind == ForceKind::BLAST ? 1.0 : 0.0;
	force.turbulence = 0.0;
	force.age = 0.4;
	return force;
}

glsl::vec4 to_glsl(const vec4 &p_a) {
	return { p_a.x, p_a.y, p_a.z, p_a.w };
}

// p_from: from the force's centre, metres.
Eigen::Vector3f air_of(const Force &p_force, const Eigen::Vector3d &p_from) {
	const GrassForce record = p_force.pack(GRID);
	return from_glsl(glsl::grass_force_air(record.place.w, to_glsl(record.blow), to_glsl(record.ring), to_glsl(record.beat),
			glsl::vec3(float(p_from.x()), float(p_from.y()), float(p_from.z()))));
}

ColliderShape shape_at(const TileManager &p_manager, int p_x, int p_z, double p_reach, int p_index) {
	ColliderShape shape;
	shape.type = GRASS_CYLINDER;
	shape.size = { p_reach, p_reach, p_reach };
	shape.now.position = shape.before.position = p_manager.get_grid().get_centre(p_x, p_z);
	shape.force = p_index;
	return shape;
}

} // namespace

TEST_CASE("force: blows as its kind says, and not at all from its radius on") {
	for (const ForceKind kind : KINDS) {
		const Force force = make_force(kind);
		CAPTURE(int(kind));
		for (int i = 0; i < 16; i++) {
			const double angle = 0.125 * i * std::numbers::pi;
			const Eigen::Vector3d out(std::cos(angle), 0.0, std::sin(angle)), around(-out.z(), 0.0, out.x());
			const Eigen::Vector3f air = air_of(force, 0.5 * force.radius * out);
			const Eigen::Vector3d way =
					kind == ForceKind::VORTEX ? around : (kind == ForceKind::WIND ? Eigen::Vector3d(1.0, 0.0, 0.0) : out);
			CHECK(air.cast<double>().dot(way) > 0.9 * double(air.norm()));
			CHECK(air.norm() > 1.0f);
			CHECK(air_of(force, 1.0001 * force.radius * out).norm() == 0.0f);
			CHECK(air_of(force, 0.999 * force.radius * out).norm() < 1e-3f * float(force.speed));
		}
		const Eigen::Vector3f middle = air_of(force, { 1e-4, 0.0, 0.0 });
		if (force.is_ring()) {
			CHECK(middle.norm() < 0.01f * float(force.speed));
		} else {
			CHECK(middle.norm() == doctest::Approx(force.speed_now()).epsilon(0.01));
		}
		CHECK(air_of(force, Eigen::Vector3d::Zero()).allFinite());
	}
}

TEST_CASE("force: is as strong as its speed says where it is strongest") {
	for (const ForceKind kind : { ForceKind::DOWNWASH, ForceKind::VORTEX }) {
		const Force force = make_force(kind);
		double most = 0.0;
		for (double share = 0.0; share < 1.0; share += 0.001) {
			const Eigen::Vector3f air = air_of(force, { share * force.radius, 0.0, 0.0 });
			most = std::max(most, double(kind == ForceKind::VORTEX ? air.z() : air.x()));
		}
		CHECK(most == doctest::Approx(force.speed).epsilon(1e-3));
	}
}

TEST_CASE("force: a blast's front runs out, and it is over after its duration") {
	Force blast = make_force(ForceKind::BLAST);
	blast.radius = 10.0;
	blast.age = 0.05;
	CHECK(air_of(blast, { 1.0, 0.0, 0.0 }).norm() > 5.0f);
	CHECK(air_of(blast, { 8.0, 0.0, 0.0 }).norm() == 0.0f);
	blast.age = 0.4;
	CHECK(air_of(blast, { 8.0, 0.0, 0.0 }).norm() > 0.1f);
	blast.age = blast.duration;
	CHECK(blast.is_over());
	CHECK(blast.speed_now() == 0.0);
	CHECK(blast.reach() == 0.0);
}

TEST_CASE("force: beyond its reach the air is too slow to wake a tile, and within it some is not") {
	for (const ForceKind kind : KINDS) {
		for (const double speed : { 1.0, 2.9, 4.0, 8.0, -12.0, 30.0, 100.0 }) {
			for (const double turbulence : { 0.0, 0.5 }) {
				Force force = make_force(kind);
				force.speed = speed;
				force.turbulence = turbulence;
				const double reach = force.reach();
				CAPTURE(int(kind));
				CAPTURE(speed);
				double inside = 0.0, outside = 0.0;
				for (double share = 0.0; share < 1.0; share += 0.01) {
					for (force.age = 1.0; force.age < 2.0; force.age += 0.13) {
						force.age = kind == ForceKind::BLAST ? 0.4 : force.age;
						const double air = double(air_of(force, { 0.0, 0.0, share * force.radius }).norm());
						(share * force.radius <= reach ? inside : outside) =
								std::max(share * force.radius <= reach ? inside : outside, air);
						if (kind == ForceKind::BLAST) {
							break;
						}
					}
				}
				force.age = kind == ForceKind::BLAST ? 0.4 : 1.0;
				CHECK(outside <= GRASS_FORCE_WAKES * 1.001);
				CHECK((reach == 0.0 || inside > GRASS_FORCE_WAKES));
			}
		}
	}
}

TEST_CASE("force: its air is the same from any tile") {
	Force force = make_force(ForceKind::VORTEX);
	force.place = { 3.3, 0.2, -7.1 };
	const GrassForce record = force.pack(GRID);
	const Eigen::Vector3d centre = GRID.get_centre(record.anchor.x, record.anchor.y);
	CHECK((centre + Eigen::Vector3d(record.place.x, record.place.y, record.place.z) - force.place).norm() < 1e-5);
}

TEST_CASE("force: what is not finite or out of range becomes something that is not") {
	const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
	for (const ForceKind kind : KINDS) {
		for (const double bad : { nan, infinity, -infinity, 1e300, -1e300 }) {
			Force force;
			force.kind = kind;
			force.place = { bad, 0.0, bad };
			force.direction = { bad, bad, 0.0 };
			force.speed = force.radius = force.duration = force.turbulence = force.age = bad;
			force.sanitise();
			const GrassForce record = force.pack(GRID);
			for (const vec4 &part : { record.place, record.blow, record.ring, record.beat }) {
				CHECK((std::isfinite(part.x) && std::isfinite(part.y) && std::isfinite(part.z) && std::isfinite(part.w)));
			}
			CHECK(record.place.w > 0.0f);
			CHECK(std::isfinite(force.reach()));
			const char *reason = nullptr;
			CHECK(force.make_shape(3).sanitise(reason));
		}
	}
}

TEST_CASE("force: wakes tiles as a body does, and is no collider of theirs") {
	TileManager manager = make_manager(256);
	ColliderShape force = shape_at(manager, 10, 10, 1.0, 5);
	const ColliderShape ball = make_ball(manager, 10, 10);
	step(manager, { ball, force });
	CHECK(manager.get_statistics().awake == 25);
	CHECK(manager.get_statistics().colliders == 1);
	CHECK(manager.get_collider_list().size() == 1);
	for (const GrassSlot &record : manager.get_slots()) {
		CHECK((record.list.w >> GRASS_SLOT_FORCES) == 1u << 5);
		CHECK(record.list.z == (record.tile.x == 10 && record.tile.y == 10 ? 1u : 0u));
	}
	step(manager, { ball });
	for (const GrassSlot &record : manager.get_slots()) {
		CHECK((record.list.w >> GRASS_SLOT_FORCES) == 0);
	}
	for (int i = 0; i < 20; i++) {
		step(manager, { ball });
		check_consistent(manager);
	}
	CHECK(manager.get_statistics().awake == 1);
}

TEST_CASE("force: a steady one lets its tiles become still, one that changes stirs them") {
	TileManager manager = make_manager(256);
	TileParams params;
	params.pool_size = 256;
	params.overhang = 0.0;
	params.still_delay = 1.0;
	manager.set_params(params);
	ColliderShape force = shape_at(manager, 10, 10, 1.0, 0);
	for (int i = 0; i < 12; i++) {
		step(manager, { force });
	}
	CHECK(manager.get_statistics().still == 25);
	force.revision++;
	step(manager, { force });
	CHECK(manager.get_statistics().still == 0);
}

TEST_CASE("force: a steady one that turns, or blows otherwise, is another one") {
	Force force = make_force(ForceKind::WIND);
	force.age = 5.0;
	const uint64_t before = force.make_shape(0).revision;
	force.age = 6.0;
	CHECK(force.make_shape(0).revision == before);
	Force turned = force, faster = force, back = force, gusty = force;
	turned.direction = { 0.0, 0.0, 1.0 };
	faster.speed += 0.5;
	back.speed = -back.speed;
	gusty.turbulence = 0.2;
	for (const Force &other : { turned, faster, back, gusty }) {
		CHECK(other.make_shape(0).revision != before);
	}
}

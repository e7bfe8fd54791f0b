// SPDX-License-Identifier: MIT
// Shapes: faces, paths, planes. What they do to blades: test_contact.cpp.
#include <doctest/doctest.h>

#include "blade_scene.h"
#include "sampled.h"

#include "core/solver/contact.h"

using namespace grass;
using namespace grass::test;

namespace {

const Eigen::Vector3f SIZE(0.15f, 0.12f, 0.1f); // metres

TileCollider make(int p_shape) {
	BladeScene scene;
	scene.add(p_shape, Eigen::Vector3f::Zero(), SIZE);
	static std::vector<Eigen::Vector4f> planes;
	planes = scene.planes;
	TileCollider collider;
	REQUIRE(make_tile_collider(scene.colliders[0], 0, 0, 0.5f, planes, collider));
	return collider;
}

} // namespace

TEST_CASE("The face of a point is unit, and the point moved by the distance lies on the surface") {
	std::mt19937 random(3);
	std::uniform_real_distribution<float> place(-0.3f, 0.3f);
	for (const int shape : SHAPES) {
		const TileCollider collider = make(shape);
		for (int i = 0; i < 1000; i++) {
			const Vec3<float> point{ place(random), place(random), place(random) };
			const Face<float> face = find_face(collider, point);
			CHECK(length(face.normal) == doctest::Approx(1.0f));
			const Face<float> there = find_face(collider, point - face.normal * face.distance);
			CHECK(there.distance > -1e-6f); // outside a box's edge the faces' planes meet, not the surface
			if (face.distance < 0.0f) {
				CHECK(there.distance < 1e-6f);
			}
		}
	}
}

TEST_CASE("At a centre or on an axis the way out is a fixed one") {
	for (const int shape : SHAPES) {
		const TileCollider collider = make(shape);
		for (const float along : { 0.0f, 0.05f }) {
			const Face<float> face = find_face(collider, Vec3<float>{ 0.0f, along, 0.0f }),
							  again = find_face(collider, Vec3<float>{ 0.0f, along, 0.0f });
			CHECK(length(face.normal) == doctest::Approx(1.0f));
			CHECK(face.distance < 0.0f);
			CHECK(dot(face.normal, again.normal) == doctest::Approx(1.0f));
		}
	}
}

TEST_CASE("A segment placed before a plane keeps its length, also one that points along the normal but for rounding") {
	std::mt19937 random(5);
	std::uniform_real_distribution<float> part(-1.0f, 1.0f);
	for (int i = 0; i < 20000; i++) {
		const Vec3<float> up{ 0.0f, 1.0f, 0.0f };
		const Vec3<float> normal = normalized<float>({ part(random), part(random), part(random) }, up);
		const float length_wanted = std::pow(10.0f, -2.0f + part(random));
		const float tilt = i % 2 ? 0.0f : std::pow(10.0f, -5.0f + 3.0f * part(random));
		const Vec3<float> along = normal * (i % 4 < 2 ? -length_wanted : 0.3f * length_wanted);
		const Vec3<float> segment = along + perpendicular(normal) * (tilt * length_wanted);
		const Vec3<float> placed = place_before_plane(segment, normal, 0.7f * length_wanted, length_wanted);
		REQUIRE(length(placed) == doctest::Approx(length_wanted).epsilon(1e-5));
		REQUIRE(dot(placed, normal) == doctest::Approx(0.7f * length_wanted).epsilon(1e-5));
	}
}

TEST_CASE("A path through a shape meets its near side, at any speed; beside it none") {
	for (const int shape : SHAPES) {
		const TileCollider collider = make(shape);
		for (const float far : { 0.3f, 3.0f, 30.0f }) {
			const Face<float> face = sweep<float>(collider, { { -far, 0.01f, 0.02f }, { far, 0.01f, 0.02f } }, { { 0, 1, 0 }, 1e6f });
			CHECK(face.normal.x < -0.9f);
			CHECK(face.distance == doctest::Approx(-(far + SIZE.x())).epsilon(0.05));
			CHECK(sweep<float>(collider, { { -far, 0.01f, 0.4f }, { far, 0.01f, 0.4f } }, { { 0, 1, 0 }, 1e6f }).distance >= 0.0f);
			CHECK(sweep<float>(collider, { { -2.0f * far, 0.01f, 0.0f }, { -far, 0.01f, 0.0f } }, { { 0, 1, 0 }, 1e6f }).distance >= 0.0f);
		}
	}
}

TEST_CASE("A face that leads into the ground gives way to another") {
	for (const int shape : SHAPES) {
		const TileCollider collider = make(shape);
		const float low = -(shape == GRASS_CAPSULE ? SIZE.x() + SIZE.y() : shape == GRASS_SPHERE ? SIZE.x() : SIZE.y()) + 0.01f;
		const Vec3<float> point{ 0.02f, low, 0.01f };
		CHECK(find_face(collider, point).normal.y < -0.9f);
		const Face<float> face = find_face(collider, point, Ground<float>{ { 0.0f, 1.0f, 0.0f }, 0.005f });
		CHECK(face.normal.y > -1e-6f);
		CHECK(face.distance < 0.0f);
		CHECK(find_face(collider, point - face.normal * face.distance).distance > -1e-4f);
	}
}

TEST_CASE("Colliders with a number that is not finite, or without planes, are left out") {
	for (int broken = 0; broken < 4; broken++) {
		BladeScene scene;
		GrassCollider &collider = scene.add(GRASS_BOX, { 0.0f, 0.25f, 0.0f }, SIZE);
		switch (broken) {
			case 0:
				collider.position.x = NOT_A_NUMBER;
				break;
			case 1:
				collider.rotation.w = INFINITY;
				break;
			case 2:
				collider.size.y = NOT_A_NUMBER;
				break;
			default:
				collider.anchor.z = GRASS_HULL;
		}
		scene.step();
		CHECK(scene.is_exactly_at_rest());
	}
}

namespace {

// Returns a collider of p_shape somewhere near the origin, at rest or on its way, and turning.
TileCollider make_moving(int p_shape, std::mt19937 &r_random) {
	std::uniform_real_distribution<float> share(-1.0f, 1.0f);
	const auto vector = [&](float p_size) {
		return Vec3<float>{ p_size * share(r_random), p_size * share(r_random), p_size * share(r_random) };
	};
	const float speed = share(r_random) < 0.0f ? 0.0f : 0.2f; // metres a step
	BladeScene scene;
	const Eigen::Vector3f size = 0.12f * Eigen::Vector3f(1.1f + share(r_random), 1.1f + share(r_random), 1.1f + share(r_random));
	GrassCollider &collider = scene.add(p_shape, Eigen::Vector3f::Zero(), size);
	const Turn<float> before = turn_by(vector(2.0f)), now = after(turn_by(vector(5.0f * speed)), before);
	const Vec3<float> place = vector(0.1f), way = vector(speed);
	BladeScene::place(collider, { place.x, place.y, place.z }, { place.x + way.x, place.y + way.y, place.z + way.z });
	collider.rotation_before = { before.axis.x, before.axis.y, before.axis.z, before.w };
	collider.rotation = { now.axis.x, now.axis.y, now.axis.z, now.w };
	static std::vector<Eigen::Vector4f> planes;
	planes = scene.planes;
	TileCollider made;
	REQUIRE(make_tile_collider(collider, 0, 0, 0.5f, planes, made));
	return made;
}

} // namespace

TEST_CASE("What passes by a collider touches it with no knot and no edge, whatever the shape, pose and path") {
	constexpr float SKIN_DEPTH = 0.004f, LENGTH = 0.033f; // metres
	const Ground<float> no_ground{ {}, 0.0f };
	const Vec3<float> root{};
	std::mt19937 random(11);
	std::uniform_real_distribution<float> share(-1.0f, 1.0f);
	const auto vector = [&](float p_size) { return Vec3<float>{ p_size * share(random), p_size * share(random), p_size * share(random) }; };
	const int count = sampled(4000);
	for (const int shape : SHAPES) {
		CAPTURE(shape);
		int passing = 0, beside = 0;
		for (int i = 0; i < count; i++) {
			const TileCollider collider = make_moving(shape, random);
			const float speed = share(random) < 0.0f ? 0.002f : 0.1f; // metres a step
			const Vec3<float> from_a = vector(0.4f), to_a = from_a + vector(speed);
			const Vec3<float> from_b = from_a + normalized(vector(1.0f), { 0.0f, 1.0f, 0.0f }) * LENGTH,
							  to_b = from_b + (to_a - from_a) + vector(0.01f);
			const Path<float> path_a = relative_path(collider, root, from_a, to_a), path_b = relative_path(collider, root, from_b, to_b);
			if (passes_by(collider, extent_of(from_a, from_a), extent_of(to_a, to_a), SKIN_DEPTH)) {
				passing++;
				CHECK(sweep(collider, path_a, no_ground).distance >= SKIN_DEPTH);
			}
			if (passes_by(collider, extent_of(from_a, from_b), extent_of(to_a, to_b), SKIN_DEPTH)) {
				const Edge<float> edge = sweep_edge(collider, path_a, path_b, SKIN_DEPTH);
				CHECK_FALSE((is_between_knots(edge) && edge.face.distance < SKIN_DEPTH));
				const Vec3<float> middle = (to_a + to_b) * 0.5f - collider.centre;
				beside += length(middle) < collider.bound + 0.5f * LENGTH ? 1 : 0;
			}
		}
		CHECK(passing > count / 4);
		CHECK((shape != GRASS_BOX || beside > count / 100)); // what the sphere about it would not have told
	}
}

// SPDX-License-Identifier: MIT
#include "core/bodies/body_shape.h"

#include "core/bodies/hull.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

using namespace grass;

namespace {

constexpr double NAN_VALUE = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

ColliderShape make(int p_type, const Eigen::Vector3d &p_size) {
	ColliderShape shape;
	shape.type = p_type;
	shape.size = p_size;
	return shape;
}

// Returns the reason for a refusal, or "" if the shape is taken.
std::string refusal(ColliderShape p_shape) {
	const char *reason = nullptr;
	const bool is_good = p_shape.sanitise(reason);
	CHECK(is_good == (reason == nullptr));
	return is_good ? "" : reason;
}

Quaternion random_rotation(std::mt19937 &r_random) {
	std::normal_distribution<double> normal;
	return Quaternion(normal(r_random), normal(r_random), normal(r_random), normal(r_random)).normalized();
}

// Returns how far a place is outside of a hull about its origin; below 0: inside. Metres.
double outside_of(const std::vector<Eigen::Vector4f> &p_planes, const Eigen::Vector3d &p_place) {
	double most = -INFINITE;
	for (const Eigen::Vector4f &plane : p_planes) {
		most = std::max(most, plane.head<3>().cast<double>().dot(p_place) - double(plane.w()));
	}
	return most;
}

} // namespace

TEST_CASE("body_shape: what cannot be mended is refused with a reason") {
	CHECK(refusal({}) == "");
	ColliderShape shape;
	shape.type = 5;
	CHECK(refusal(shape).find("type") != std::string::npos);
	shape.type = -1;
	CHECK(refusal(shape).find("type") != std::string::npos);
	for (const double bad : { NAN_VALUE, INFINITE, -INFINITE, 1e9 }) {
		for (int i = 0; i < 3; i++) {
			shape = {};
			shape.size[i] = bad;
			CHECK(refusal(shape).find("size") != std::string::npos);
			shape = {};
			shape.now.position[i] = bad;
			CHECK(refusal(shape).find("position") != std::string::npos);
			shape = {};
			shape.before.position[i] = bad;
			CHECK(refusal(shape).find("position") != std::string::npos);
		}
	}
	shape = {};
	shape.friction = NAN_VALUE;
	CHECK(refusal(shape).find("friction") != std::string::npos);
	shape = {};
	shape.before.rotation.coeffs().setZero();
	CHECK(refusal(shape).find("rotation") != std::string::npos);
	shape = {};
	shape.now.rotation.w() = NAN_VALUE;
	CHECK(refusal(shape).find("rotation") != std::string::npos);
}

TEST_CASE("body_shape: a hull needs good planes") {
	ColliderShape hull = make(GRASS_HULL, { 1.0, 1.0, 1.0 });
	CHECK(refusal(hull).find("planes") != std::string::npos);
	hull.planes.assign(4, { 0.0f, 1.0f, 0.0f, 1.0f });
	CHECK(refusal(hull) == "");
	hull.planes[2].x() = 1.0f;
	CHECK(refusal(hull).find("plane") != std::string::npos);
	hull.planes[2] = { 0.0f, 1.0f, 0.0f, std::numeric_limits<float>::quiet_NaN() };
	CHECK(refusal(hull).find("plane") != std::string::npos);
	hull.planes.assign(65, { 0.0f, 1.0f, 0.0f, 1.0f });
	CHECK(refusal(hull).find("planes") != std::string::npos);
}

TEST_CASE("body_shape: what can be mended is") {
	const char *reason = nullptr;
	ColliderShape shape = make(GRASS_BOX, { 0.0, -1.0, 1e-9 });
	shape.friction = 7.0;
	shape.now.rotation = Quaternion(2.0, 0.0, 0.0, 0.0);
	REQUIRE(shape.sanitise(reason));
	CHECK(shape.size == Eigen::Vector3d::Constant(ColliderShape::MIN_SIZE));
	CHECK(shape.friction == 1.0);
	CHECK(shape.now.rotation.norm() == doctest::Approx(1.0));
	ColliderShape capsule = make(GRASS_CAPSULE, { 0.5, -0.1, 0.0 });
	REQUIRE(capsule.sanitise(reason));
	CHECK(capsule.size.y() == 0.0);
}

TEST_CASE("body_shape: poses from transforms lose scale and keep the rotation") {
	const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized());
	Eigen::Affine3d now = Eigen::Affine3d::Identity();
	now.translate(Eigen::Vector3d(1.0, 2.0, 3.0)).rotate(turn).scale(3.0);
	ColliderShape shape;
	shape.set_poses(Eigen::Affine3d::Identity(), now);
	CHECK(shape.before.rotation.isApprox(Quaternion::Identity()));
	CHECK(shape.now.position == Eigen::Vector3d(1.0, 2.0, 3.0));
	CHECK(std::abs(shape.now.rotation.dot(Quaternion(turn))) == doctest::Approx(1.0));
	now.linear().setZero(); // scaled to nothing: some rotation, but a good one
	shape.set_poses(now, now);
	CHECK(refusal(shape) == "");
	now.linear().setConstant(NAN_VALUE);
	shape.set_poses(now, now);
	CHECK(refusal(shape).find("rotation") != std::string::npos);
}

// A wedge, which no turn makes like its mirrored form.
TEST_CASE("body_shape: a mirrored and scaled hull holds the places that its transform takes those of the hull to") {
	const Eigen::Vector3d points[] = { { -0.5, -0.2, -0.3 }, { 0.6, -0.2, -0.3 }, { -0.5, -0.2, 0.35 }, { -0.5, 0.2, -0.3 } };
	const Hull hull = Hull::make(points);
	std::mt19937 random(9);
	std::uniform_real_distribution<double> place(-0.7, 0.7), factor(0.3, 2.0);
	int inside = 0, wrong = 0;
	for (int n = 0; n < 64; n++) {
		Eigen::Affine3d transform = Eigen::Translation3d(place(random), place(random), place(random)) * random_rotation(random);
		const Eigen::Vector3d signs(n & 1 ? -1.0 : 1.0, n & 2 ? -1.0 : 1.0, n & 4 ? -1.0 : 1.0);
		transform.scale(n < 8 ? signs : Eigen::Vector3d(signs * factor(random)).cwiseProduct(Eigen::Vector3d(1.0, factor(random), 1.0)));
		ColliderShape shape = make(GRASS_HULL, hull.half_extents);
		shape.planes = hull.planes;
		shape.scale(ColliderShape::scale_of(transform.linear()));
		shape.set_poses(transform, transform);
		CHECK(refusal(shape) == "");
		const Bounds bounds = shape.get_swept_bounds();
		for (int i = 0; i < 200; i++) {
			const Eigen::Vector3d at(place(random), place(random), place(random)), there = transform * at;
			const double expected = outside_of(hull.planes, at);
			const double found = outside_of(shape.planes, shape.now.rotation.conjugate() * (there - shape.now.position));
			inside += expected < 0.0 ? 1 : 0;
			wrong += std::abs(expected) > 1e-5 && (expected < 0.0) != (found < 0.0) ? 1 : 0;
			wrong += expected < 0.0 && ((there - bounds.max).maxCoeff() > 1e-5 || (bounds.min - there).maxCoeff() > 1e-5) ? 1 : 0;
		}
	}
	CHECK(inside > 150);
	CHECK(wrong == 0);
}

TEST_CASE("body_shape: bounds of each shape at rest") {
	struct Case {
		int type;
		Eigen::Vector3d half;
	};
	const Case cases[] = { { GRASS_SPHERE, { 0.2, 0.2, 0.2 } }, { GRASS_CAPSULE, { 0.2, 0.7, 0.2 } }, { GRASS_BOX, { 0.2, 0.5, 0.9 } },
		{ GRASS_CYLINDER, { 0.2, 0.5, 0.2 } }, { GRASS_HULL, { 0.2, 0.5, 0.9 } } };
	for (const Case &expected : cases) {
		ColliderShape shape = make(expected.type, { 0.2, 0.5, 0.9 });
		shape.now.position = shape.before.position = { 3.0, 1.0, -2.0 };
		const Bounds bounds = shape.get_swept_bounds();
		CHECK((bounds.max - bounds.min).isApprox(2.0 * expected.half));
		CHECK((bounds.max + bounds.min).isApprox(2.0 * shape.now.position));
	}
}

TEST_CASE("body_shape: swept bounds hold the whole way of every corner, and little more") {
	std::mt19937 random(5);
	std::uniform_real_distribution<double> place(-3.0, 3.0), extent(0.05, 1.0);
	int outside = 0;
	for (int i = 0; i < 300; i++) {
		ColliderShape box = make(GRASS_BOX, { extent(random), extent(random), extent(random) });
		box.before = { { place(random), place(random), place(random) }, random_rotation(random) };
		box.now = { { place(random), place(random), place(random) }, random_rotation(random) };
		const Bounds bounds = box.get_swept_bounds();
		for (int step = 0; step <= 20; step++) {
			const double t = step / 20.0;
			const Eigen::Vector3d centre = (1.0 - t) * box.before.position + t * box.now.position;
			const Quaternion rotation = box.before.rotation.slerp(t, box.now.rotation);
			for (int corner = 0; corner < 8; corner++) {
				const Eigen::Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
				const Eigen::Vector3d point = centre + rotation * sign.cwiseProduct(box.size);
				outside += ((point.array() >= bounds.min.array() - 1e-9) && (point.array() <= bounds.max.array() + 1e-9)).all() ? 0 : 1;
			}
		}
		const double slack = 2.0 * box.size.norm();
		CHECK(((bounds.max - bounds.min).array() <= (box.now.position - box.before.position).cwiseAbs().array() + 2.0 * slack).all());
	}
	CHECK(outside == 0);
}

TEST_CASE("body_shape: a record leads back to the poses, to a tenth of a micrometre anywhere on the field") {
	const TileGrid grid = TileGrid::make(4096.0, 4096.0, 256.0);
	std::mt19937 random(6);
	std::uniform_real_distribution<double> place(-2048.0, 2048.0), step(-0.2, 0.2);
	double worst = 0.0;
	for (int i = 0; i < 1000; i++) {
		ColliderShape shape = make(GRASS_CYLINDER, { 0.3, 0.4, 0.0 });
		shape.now = { { place(random), 0.3, place(random) }, random_rotation(random) };
		shape.before = { shape.now.position + Eigen::Vector3d(step(random), step(random), step(random)), random_rotation(random) };
		const GrassCollider packed = shape.pack(grid, 9);
		const Eigen::Vector3d anchor = grid.get_centre(packed.anchor.x, packed.anchor.y);
		const Eigen::Vector3d now(packed.position.x, packed.position.y, packed.position.z);
		const Eigen::Vector3d before(packed.position_before.x, packed.position_before.y, packed.position_before.z);
		worst = std::max(worst, (anchor + now - shape.now.position).norm());
		worst = std::max(worst, (anchor + before - shape.before.position).norm());
		const vec4 a = packed.rotation, b = packed.rotation_before;
		CHECK(a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w >= 0.0f);
		CHECK(std::abs(shape.before.rotation.dot(Quaternion(b.w, b.x, b.y, b.z))) == doctest::Approx(1.0).epsilon(1e-6));
	}
	CHECK(worst < 1e-7);
}

TEST_CASE("body_shape: a record tells type, friction, sizes and planes") {
	const TileGrid grid = TileGrid::make(32.0, 32.0, 256.0);
	ColliderShape shape = make(GRASS_CAPSULE, { 0.3, 0.4, 0.1 });
	shape.friction = 0.25;
	const GrassCollider capsule = shape.pack(grid, 9);
	CHECK(capsule.anchor == ivec4{ 32, 32, GRASS_CAPSULE, 0 });
	CHECK(capsule.position.w == 0.25f);
	CHECK(capsule.size.x == 0.3f);
	CHECK(capsule.size.y == 0.4f);
	shape = make(GRASS_HULL, { 0.3, 0.4, 1.2 });
	shape.planes.assign(5, { 0.0f, 1.0f, 0.0f, 0.4f });
	const GrassCollider hull = shape.pack(grid, 9);
	CHECK(hull.anchor.z == GRASS_HULL);
	CHECK(hull.anchor.w == 9);
	CHECK(hull.position_before.w == 5.0f);
	CHECK(hull.size.x == doctest::Approx(1.3));
}

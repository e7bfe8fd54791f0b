// SPDX-License-Identifier: MIT
// How near METHOD_DIRECT among colliders comes to what it converges to, and what a collider that nothing touches changes.
#include <doctest/doctest.h>

#include "blade_scene.h"
#include "sampled.h"
#include "sward.h"

#include "core/solver/leaves.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <tuple>

using namespace grass;
using namespace grass::test;

namespace {

constexpr float RADIUS = 0.15f; // metres
constexpr int DEFAULT_ITERATIONS = int(ITERATIONS.initial);

// Straight blades in two rows, at 7.5 to 10.5 cm from the way of a ball. Leaves that it hits edge-on fall to one side or the other, and
// the least difference says to which: stalks do not.
BladeScene make_rows(bool p_has_leaves) {
	BladeScene scene;
	scene.params.width_to_thickness = p_has_leaves ? WIDTH_TO_THICKNESS.initial : 1.0;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		for (int k = 0; k < GRASS_KNOTS; k++) {
			scene.set_rest(b, k, { 0.0f, scene.length * float(knot_share(k)), 0.0f });
		}
		const float aside = 0.075f + 0.03f * float(b) / (GRASS_BLADES_PER_TILE - 1);
		scene.tile->root[2][b] = b % 2 == 0 ? aside : -aside;
	}
	return scene;
}

// Returns the knots of all blades 60 times a second, metres, while a ball rolls past at p_speed and for a while after.
std::vector<Eigen::Vector3f> roll_past(float p_speed, double p_rate, int p_iterations, double p_seconds, bool p_has_leaves = false) {
	BladeScene scene = make_rows(p_has_leaves);
	scene.params.iterations = p_iterations;
	scene.params.friction = 0.0;
	scene.add(GRASS_SPHERE, { -0.7f, RADIUS, 0.0f }, { RADIUS, 0.0f, 0.0f });
	std::vector<Eigen::Vector3f> track;
	double seen = 0.0; // sixtieths of a second
	for (int i = 0; i < int(std::lround(p_seconds * p_rate)); i++) {
		const auto place = [&](int p_step) { return Eigen::Vector3f(-0.7f + p_speed * float(p_step / p_rate), RADIUS, 0.0f); };
		BladeScene::place(scene.colliders[0], place(i), place(i + 1));
		scene.step(1.0 / p_rate);
		if ((i + 1) / p_rate * 60.0 < seen + 1.0 - 1e-6) {
			continue;
		}
		seen += 1.0;
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
				track.push_back(scene.knot(b, k));
			}
		}
	}
	return track;
}

// Root mean square over knots and time, blade lengths.
double difference(const std::vector<Eigen::Vector3f> &p_a, const std::vector<Eigen::Vector3f> &p_b) {
	REQUIRE(p_a.size() == p_b.size());
	double sum = 0.0;
	for (size_t i = 0; i < p_a.size(); i++) {
		sum += double((p_a[i] - p_b[i]).squaredNorm());
	}
	return std::sqrt(sum / double(p_a.size())) / 0.5;
}

// Returns the same of the median blade alone.
double median_difference(const std::vector<Eigen::Vector3f> &p_a, const std::vector<Eigen::Vector3f> &p_b) {
	REQUIRE(p_a.size() == p_b.size());
	constexpr size_t IN_FRAME = GRASS_BLADES_PER_TILE * GRASS_FREE_KNOTS;
	std::vector<double> sums(GRASS_BLADES_PER_TILE, 0.0);
	for (size_t i = 0; i < p_a.size(); i++) {
		sums[i % IN_FRAME / GRASS_FREE_KNOTS] += double((p_a[i] - p_b[i]).squaredNorm());
	}
	std::nth_element(sums.begin(), sums.begin() + GRASS_BLADES_PER_TILE / 2, sums.end());
	return std::sqrt(sums[GRASS_BLADES_PER_TILE / 2] / (double(p_a.size()) / GRASS_BLADES_PER_TILE)) / 0.5;
}

// A body at rest beside the plane in which the straight blade swings.
struct Beside {
	int shape;
	Eigen::Quaternionf turn;
	float height, gap; // of its centre, and from the plane, metres
};

// Returns how far a shape of make_size() reaches along a direction of its own axes, metres.
Eigen::Vector3f make_size(int p_shape) {
	return p_shape == GRASS_SPHERE ? Eigen::Vector3f(RADIUS, 0.0f, 0.0f) : Eigen::Vector3f(0.12f, 0.16f, 0.1f);
}
float reach(int p_shape, const Eigen::Vector3f &p_along) {
	const Eigen::Vector3f size = make_size(p_shape);
	switch (p_shape) {
		case GRASS_SPHERE:
			return size.x();
		case GRASS_CAPSULE:
			return size.x() + size.y() * std::abs(p_along.y());
		case GRASS_CYLINDER:
			return size.y() * std::abs(p_along.y()) + size.x() * std::hypot(p_along.x(), p_along.z());
		default:
			return p_along.cwiseAbs().dot(size);
	}
}

// Returns how far the tip of the straight blade swings in the fourth second, undamped.
float swing(float p_rate, const Beside *p_body) {
	BladeScene scene;
	scene.params.damping_ratio = 0.0;
	if (p_body != nullptr) {
		const Eigen::Quaternionf &turn = p_body->turn;
		const float away = reach(p_body->shape, turn.conjugate() * Eigen::Vector3f::UnitZ()) + p_body->gap;
		GrassCollider &collider = scene.add(p_body->shape, { 0.0f, p_body->height, -away }, make_size(p_body->shape));
		collider.rotation = collider.rotation_before = { turn.x(), turn.y(), turn.z(), turn.w() };
	}
	scene.bend(0.3f);
	scene.step_for(3.0, p_rate);
	float most = 0.0f;
	for (int i = 0; i < int(p_rate); i++) {
		scene.step(1.0 / p_rate);
		most = std::max(most, std::abs(scene.knot(0, GRASS_KNOTS - 1).x()));
	}
	return most;
}

} // namespace

TEST_CASE("METHOD_DIRECT: blades under a ball that passes off-centre go within 0.8 % L of the way at 1920 steps a second at 1 m/s, 3 % at "
		  "5 m/s, by default") {
	struct Pass {
		float speed; // m/s
		double seconds, most; // most: blade lengths
	};
	for (const Pass &pass : { Pass{ 1.0f, 1.7, 0.008 }, Pass{ 5.0f, 0.9, 0.03 } }) {
		CAPTURE(pass.speed);
		const std::vector<Eigen::Vector3f> converged = roll_past(pass.speed, 1920.0, 8, pass.seconds);
		const double error = difference(roll_past(pass.speed, 60.0, DEFAULT_ITERATIONS, pass.seconds), converged);
		CHECK(error < pass.most);
		const double whole = difference(roll_past(pass.speed, 60.0, 1, pass.seconds), converged);
		CHECK(error < 0.5 * whole);
		MESSAGE(pass.speed << " m/s: " << error << " L, in whole steps " << whole);
		CHECK(difference(roll_past(pass.speed, 480.0, DEFAULT_ITERATIONS, pass.seconds), converged) < 0.7 * error);
	}
}

TEST_CASE(
		"METHOD_DIRECT: the blades of a patch that a ball rolls over are as high as at 960 steps a second within 1 % (RMS over time) at 1 "
		"m/s, and as many are pressed, within 2 %, at worst 6 %, at 5 m/s, at 30, 60 and 144 steps a second") {
	for (const auto &[speed, seconds] : { std::pair(1.0f, 2.5), std::pair(5.0f, 1.2) }) {
		CAPTURE(speed);
		const std::vector<Sward> fine = roll_over(speed, 960.0, seconds, [](BladeScene &r_scene) { r_scene.params.iterations = 8; });
		for (const double rate : { 30.0, 60.0, 144.0 }) {
			CAPTURE(rate);
			const std::vector<Sward> sward = roll_over(speed, rate, seconds, [](BladeScene &) {});
			REQUIRE(sward.size() == fine.size());
			const SwardError error = difference(sward, fine);
			CHECK(error.height < (speed > 2.0f ? 0.02 : 0.01));
			CHECK(error.pressed < 0.02);
			CHECK(error.worst < 0.06);
			MESSAGE(speed << " m/s, " << rate << " steps a second: height " << error.height << ", pressed " << error.pressed
						  << ", at worst " << error.worst);
		}
	}
}

TEST_CASE("[Eq 43] parts of a step: at most 16, halved while longer than 1/400 s or no more than the iterations") {
	const double seconds[] = { 0.1, 1.0 / 30.0, 1.0 / 60.0, 1.0 / 144.0, 1.0 / 240.0, 1.0 / 960.0, 1e-5 };
	const std::pair<int, std::array<int, 7>> rows[] = {
		{ 1, { 1, 1, 1, 1, 1, 1, 1 } },
		{ 2, { 16, 16, 8, 4, 2, 2, 2 } },
		{ 3, { 16, 16, 8, 4, 2, 2, 2 } },
		{ 5, { 16, 16, 8, 4, 4, 4, 4 } },
		{ 10, { 16, 16, 8, 8, 8, 8, 8 } },
	};
	for (const auto &[iterations, parts] : rows) {
		for (size_t i = 0; i < parts.size(); i++) {
			CAPTURE(iterations);
			CAPTURE(seconds[i]);
			CHECK(most_parts(iterations, float(seconds[i]), 1.0f) == parts[i]);
		}
	}
}

TEST_CASE("METHOD_DIRECT: so does the median of leaves, within 1.2 % and 3.5 %") {
	constexpr int iterations = DEFAULT_ITERATIONS;
	for (const auto &[speed, seconds, most] : { std::tuple(1.0f, 1.7, 0.012), std::tuple(5.0f, 0.9, 0.035) }) {
		CAPTURE(speed);
		const std::vector<Eigen::Vector3f> converged = roll_past(speed, 1920.0, 8, seconds, true);
		const double error = median_difference(roll_past(speed, 60.0, iterations, seconds, true), converged);
		CHECK(error < most);
		const double fine = median_difference(roll_past(speed, 480.0, iterations, seconds, true), converged);
		CHECK(fine < 0.65 * error);
		MESSAGE(speed << " m/s: " << error << " L, at 480 steps a second " << fine);
	}
}

TEST_CASE("METHOD_DIRECT: a body at rest beside a swing takes nothing of it, whatever its shape, from 0.1 segments on, tilted from 0.3") {
	const float segment = 0.5f / GRASS_SEGMENTS; // metres
	std::mt19937 random(11);
	std::uniform_real_distribution<float> between(-1.0f, 1.0f);
	for (const float rate : sampled({ 30.0f, 60.0f, 144.0f })) {
		CAPTURE(rate);
		const float alone = swing(rate, nullptr);
		CHECK(alone > 0.05f);
		for (const int shape : SHAPES) {
			CAPTURE(shape);
			for (const float gap : { 0.1f, 0.15f, 0.3f, 0.6f, 3.0f }) {
				CAPTURE(gap);
				const Eigen::Quaternionf turn = Eigen::Quaternionf(between(random), between(random), between(random), 1.0f).normalized();
				Beside body{ shape, turn, 0.3f + 0.2f * between(random), gap * segment };
				CHECK((gap < 0.3f || swing(rate, &body) > 0.999f * alone));
				body.turn = Eigen::Quaternionf::Identity();
				CHECK(swing(rate, &body) > 0.999f * alone);
				body.gap = -0.05f * segment; // it touches
				CHECK(swing(rate, &body) != alone);
			}
		}
	}
}

TEST_CASE("METHOD_DIRECT: a blade that a level plate holds down lies within 0.4 % L of it") {
	BladeScene scene;
	scene.params.friction = 0.0;
	scene.add(GRASS_BOX, { 0.0f, 0.6f, 0.0f }, { 2.0f, 0.05f, 2.0f });
	const auto height = [](double p_seconds) { return Eigen::Vector3f(0.0f, float(0.6 - 0.3 * std::min(p_seconds / 2.0, 1.0)), 0.0f); };
	for (int i = 0; i < 300; i++) {
		BladeScene::place(scene.colliders[0], height(i / 60.0), height((i + 1) / 60.0));
		scene.step();
	}
	const TileCollider plate = scene.tile_colliders()[0];
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		CAPTURE(b);
		float gap = 1.0f; // metres
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			gap = std::min(gap, -scene.depth_in(plate, b, k));
		}
		CHECK(gap < 0.004f * scene.length);
		CHECK(gap > -1e-4f);
	}
}

// SPDX-License-Identifier: MIT
#include "core/blades/wind.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/half.h"
#include "core/blades/patch.h"

using namespace grass;

namespace {

const glsl::vec4 MIDDLE(0.5f);

// A wind with the default gusts.
struct WindParams {
	Eigen::Vector2f velocity = Eigen::Vector2f::Zero(); // along x, z; m/s
	float gust_size = float(GUST_SIZE.initial); // metres
	float gust_strength = float(GUST_STRENGTH.initial);
};

WindParams blowing(float p_x, float p_z) {
	WindParams wind;
	wind.velocity = { p_x, p_z };
	return wind;
}

WindClock clock_at(double p_time, const WindParams &p_wind) {
	WindClock clock;
	clock.advance(p_time, p_wind.velocity.norm(), p_wind.gust_size);
	return clock;
}

glsl::vec2 wrapped(const WindClock &p_clock) {
	return { float(p_clock.sway), float(p_clock.roll) };
}
float gust_at(const Eigen::Vector2f &p_place, const WindClock &p_clock, const WindParams &p_wind) {
	return glsl::grass_gust_at(to_glsl(p_place), wrapped(p_clock), to_glsl(p_wind.velocity), p_wind.gust_size);
}
glsl::GrassWind wind_at(const Eigen::Vector2f &p_place, float p_along, const WindClock &p_clock, const WindParams &p_wind) {
	return glsl::grass_wind_at(to_glsl(p_place), p_along, MIDDLE, wrapped(p_clock), to_glsl(p_wind.velocity),
			glsl::vec2(p_wind.gust_size, p_wind.gust_strength), glsl::vec2(0.0f));
}

std::vector<Eigen::Vector3f> blade_of(const Patch &p_patch, int p_blade) {
	std::vector<Eigen::Vector3f> knots(GRASS_KNOTS, Eigen::Vector3f::Zero());
	for (int k = 1; k < GRASS_KNOTS; k++) {
		const uint16_t *halves = &p_patch.texels[Patch::texel_index(p_blade, k)];
		knots[size_t(k)] = { half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]) };
	}
	return knots;
}

// Returns the knots as the blade shader bends them.
std::vector<Eigen::Vector3f> bend(const std::vector<Eigen::Vector3f> &p_knots, const WindParams &p_wind, float p_time) {
	std::vector<Eigen::Vector3f> bent(p_knots.size());
	for (size_t k = 0; k < p_knots.size(); k++) {
		const size_t below = std::min(k, p_knots.size() - 2);
		const Eigen::Vector3f tangent = (p_knots[below + 1] - p_knots[below]) * std::max(float(k), 0.01f);
		const glsl::GrassWind here = wind_at({ 1.0f, 2.0f }, float(knot_share(k)), clock_at(p_time, p_wind), p_wind);
		const glsl::vec3 knot = to_glsl(p_knots[k]), along = to_glsl(tangent);
		bent[k] = from_glsl(glsl::grass_wind_point(knot, along, here.tilt * glsl::grass_wind_hold(knot, along)));
	}
	return bent;
}

double length_of(const std::vector<Eigen::Vector3f> &p_knots) {
	double length = 0.0;
	for (size_t k = 1; k < p_knots.size(); k++) {
		length += (p_knots[k] - p_knots[k - 1]).norm();
	}
	return length;
}

} // namespace

TEST_CASE("wind: none leaves every knot where it is, bit for bit") {
	const Patch patch = generate_patch({});
	for (int blade = 0; blade < GRASS_PATCH_BLADES; blade += 101) {
		const std::vector<Eigen::Vector3f> knots = blade_of(patch, blade);
		CHECK(bend(knots, blowing(0.0f, 0.0f), 12.3f) == knots);
	}
	CHECK(wind_at({ 3.0f, 4.0f }, 1.0f, clock_at(1.0, blowing(0.0f, 0.0f)), blowing(0.0f, 0.0f)).gust == 0.0f);
}

TEST_CASE("wind: keeps the root still and the blade as long as it is") {
	const Patch patch = generate_patch({});
	for (const float speed : { 2.0f, 6.0f, 15.0f, 40.0f }) {
		double worst = 0.0, sum = 0.0;
		int count = 0;
		for (int blade = 0; blade < GRASS_PATCH_BLADES; blade += 53) {
			const std::vector<Eigen::Vector3f> knots = blade_of(patch, blade);
			const std::vector<Eigen::Vector3f> bent = bend(knots, blowing(0.8f * speed, 0.6f * speed), 0.37f * float(blade));
			REQUIRE(bent[0].norm() == 0.0f);
			for (const Eigen::Vector3f &knot : bent) {
				REQUIRE(knot.y() >= 0.0f);
			}
			const double stretch = std::abs(length_of(bent) / length_of(knots) - 1.0);
			worst = std::max(worst, stretch);
			sum += stretch;
			count++;
		}
		CAPTURE(speed);
		CAPTURE(worst);
		CHECK(sum / count < 0.03);
		CHECK(worst < 0.21);
	}
}

TEST_CASE("wind: bends downwind, more the stronger it blows, and never past its limit") {
	const std::vector<Eigen::Vector3f> straight = [] {
		std::vector<Eigen::Vector3f> knots;
		for (int k = 0; k < GRASS_KNOTS; k++) {
			knots.emplace_back(0.0f, 0.5f * float(knot_share(k)), 0.0f);
		}
		return knots;
	}();
	double before = 0.0;
	for (const float speed : { 1.0f, 3.0f, 8.0f, 20.0f }) {
		double mean = 0.0;
		for (int i = 0; i < 400; i++) {
			const std::vector<Eigen::Vector3f> bent = bend(straight, blowing(-speed, 0.0f), 0.1f * float(i));
			mean -= bent.back().x() / 400.0;
			REQUIRE(length_of(bent) == doctest::Approx(0.5).epsilon(0.02));
			REQUIRE(bent.back().y() > 0.0f);
		}
		CHECK(mean > 1.3 * before);
		before = mean;
	}
}

TEST_CASE("wind: a blade that lies flat is not pressed into the ground") {
	std::vector<Eigen::Vector3f> flat;
	for (int k = 0; k < GRASS_KNOTS; k++) {
		flat.emplace_back(0.03f * float(k), k == 0 ? 0.0f : 0.012f, 0.0f);
	}
	for (const Eigen::Vector3f &knot : bend(flat, blowing(20.0f, 0.0f), 1.0f)) {
		CHECK(knot.y() >= 0.0f);
	}
}

TEST_CASE("wind: gusts travel with the wind") {
	const WindParams wind = blowing(3.0f, 4.0f);
	double moved = 0.0, stayed = 0.0;
	float least = 1.0f, most = 0.0f;
	for (int i = 0; i < 2000; i++) {
		const Eigen::Vector2f place(0.73f * float(i % 50), 1.29f * float(i / 50));
		const float now = gust_at(place, clock_at(7.0, wind), wind);
		moved += std::abs(gust_at(place + 0.8f * wind.velocity, clock_at(7.8, wind), wind) - now);
		stayed += std::abs(gust_at(place, clock_at(7.8, wind), wind) - now);
		least = std::min(least, now);
		most = std::max(most, now);
	}
	CHECK(moved < 1e-3 * stayed);
	CHECK(least < 0.1f);
	CHECK(most > 0.9f);
}

TEST_CASE("wind: is smooth in time") {
	const WindParams wind = blowing(6.0f, 1.0f);
	double fastest = 0.0;
	for (float time = 0.0f; time < 30.0f; time += 1.0f / 60.0f) {
		const glsl::vec2 before = wind_at({ 5.0f, 5.0f }, 1.0f, clock_at(time, wind), wind).tilt;
		const glsl::vec2 after = wind_at({ 5.0f, 5.0f }, 1.0f, clock_at(time + 1.0f / 60.0f, wind), wind).tilt;
		fastest = std::max(fastest, double(glsl::length(after - before)));
	}
	CHECK(fastest < 0.08);
	CHECK(fastest > 0.001);
}

TEST_CASE("wind: the clock turns over without a jerk, and stays small for days") {
	const WindParams wind = blowing(6.0f, 1.0f);
	for (int i = 0; i < 400; i++) {
		const Eigen::Vector2f place(0.83f * float(i % 20) - 8.0f, 1.29f * float(i / 20));
		for (const double part : { 0.0, 0.3, 0.7 }) {
			const WindClock here{ part, part };
			const WindClock next{ part + GRASS_WIND_SWAY_PERIOD, part + GRASS_WIND_ROLL_PERIOD };
			const glsl::GrassWind a = wind_at(place, 1.0f, here, wind), b = wind_at(place, 1.0f, next, wind);
			CHECK(glsl::length(a.tilt - b.tilt) < 2e-3f); // single precision of an argument of 5,888 cells
			CHECK(std::abs(a.gust - b.gust) < 5e-3f);
		}
	}
	WindClock clock;
	for (int day = 0; day < 10; day++) {
		clock.advance(86400.0, wind.velocity.norm(), wind.gust_size);
		CHECK(clock.sway < GRASS_WIND_SWAY_PERIOD);
		CHECK(clock.roll < GRASS_WIND_ROLL_PERIOD);
	}
}

TEST_CASE("wind: a change of its speed moves no gust") {
	WindClock clock;
	clock.advance(1000.0, 3.0, 7.0);
	const double before = clock.roll;
	clock.advance(1.0 / 60.0, 30.0, 7.0);
	CHECK(std::abs(clock.roll - before) == doctest::Approx(30.0 / 60.0 / 7.0));
}

namespace {

// The greatest change from frame to frame in half a minute, of the gust and of the tilt at a tip, after an hour of wind.
struct Change {
	float gust = 0.0f, tilt = 0.0f;
};

// p_wind_at: of the part of that time that has passed, 0..1. p_is_product: by a clock that is the product of time and wind.
template <typename WindAt> Change fastest_change(WindAt p_wind_at, bool p_is_product) {
	constexpr double FRAME = 1.0 / 60.0, BEFORE = 3600.0;
	constexpr int FRAMES = 1800;
	const Eigen::Vector2f place(9.0f, -12.0f);
	WindClock clock = clock_at(BEFORE, p_wind_at(0.0f));
	Change most;
	float gust = 0.0f;
	glsl::vec2 tilt(0.0f);
	for (int frame = 0; frame <= FRAMES; frame++) {
		const WindParams wind = p_wind_at(float(frame) / float(FRAMES));
		clock.advance(FRAME, wind.velocity.norm(), wind.gust_size);
		const WindClock used = p_is_product ? clock_at(BEFORE + frame * FRAME, wind) : clock;
		const float gust_now = gust_at(place, used, wind);
		const glsl::vec2 tilt_now = wind_at(place, 1.0f, used, wind).tilt;
		if (frame > 0) {
			most.gust = std::max(most.gust, std::abs(gust_now - gust));
			most.tilt = std::max(most.tilt, glsl::length(tilt_now - tilt));
		}
		gust = gust_now;
		tilt = tilt_now;
	}
	return most;
}

} // namespace

// As a script or a curve may change it, in each frame a little.
TEST_CASE("wind: what changes little by little makes no gust jump") {
	const auto steady = [](float) { return blowing(9.0f, 0.0f); };
	const auto turning = [](float p_part) {
		const float angle = 1.5f * p_part, speed = 3.0f + 6.0f * p_part;
		return blowing(speed * std::cos(angle), speed * std::sin(angle));
	};
	const Change usual = fastest_change(steady, false), changed = fastest_change(turning, false), product = fastest_change(turning, true);
	CHECK(usual.gust > 0.01f); // gusts come by
	CHECK(changed.gust < 1.5f * usual.gust);
	CHECK(changed.tilt < 1.5f * usual.tilt);
	CHECK(product.gust > 2.0f * usual.gust);
}

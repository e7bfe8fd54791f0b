// SPDX-License-Identifier: MIT
#include "core/bodies/motion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

using namespace grass;

using Eigen::Vector3d;

namespace {

const Vector3d NONE = Vector3d::Zero();

MotionTick tick_of(double p_rate) {
	return { .delta = 1.0 / p_rate };
}

// A body whose path is watched: how much of the way along x it swept.
struct Walker {
	Motion motion;
	MotionTick tick;
	Vector3d place = Vector3d::Zero();
	std::vector<double> from; // where the path of each tick began

	explicit Walker(double p_rate) : tick(tick_of(p_rate)) { motion.start(place, NONE, NONE, tick); }
	void step(const Vector3d &p_step, const Vector3d &p_own = NONE) {
		const Vector3d before = place;
		place += p_step;
		from.push_back(motion.follow(before, place, p_own, tick).x());
	}
	void stand(int p_ticks) {
		for (int i = 0; i < p_ticks; i++) {
			step(NONE);
		}
	}
	bool swept_last() const { return from.back() != place.x(); }
};

} // namespace

TEST_CASE("motion: a steady body sweeps all of its way at any speed and tick rate, the start included") {
	for (const double rate : { 10.0, 60.0, 240.0 }) {
		for (const double speed : { 5.0, 30.0, 121.0, 200.0, 600.0, 2000.0 }) {
			CAPTURE(rate);
			CAPTURE(speed);
			Walker walker(rate);
			walker.stand(3);
			double reached = 0.0; // swept without a gap from the start to here
			for (int i = 0; i < 5; i++) {
				walker.step(Vector3d(speed / rate, 0.0, 0.0));
				reached = walker.from.back() <= reached ? walker.place.x() : reached;
			}
			CHECK(reached == walker.place.x());
		}
	}
}

TEST_CASE("motion: a start that its own velocity explains is swept at once") {
	Walker walker(60.0);
	walker.stand(3);
	walker.step(Vector3d(10.0, 0.0, 0.0), Vector3d(600.0, 0.0, 0.0));
	CHECK(walker.from.back() == 0.0);
	CHECK_FALSE(Walker(60.0).motion.expects(Vector3d(10.0, 0.0, 0.0), walker.tick));
	CHECK(walker.motion.expects(Vector3d(10.0, 0.0, 0.0), walker.tick));
}

TEST_CASE("motion: what brakes, turns and stops is motion") {
	Walker walker(60.0);
	for (const Vector3d &step : { Vector3d(10, 0, 0), Vector3d(10, 0, 0), Vector3d(8, 4, 0), Vector3d(3, 0, 0), Vector3d(0.1, 0, 0) }) {
		walker.step(step);
	}
	walker.stand(1);
	// The second step explains the first, so its path begins where the body stood; each later one begins where the one before ended.
	const double begins[] = { 10.0, 0.0, 20.0, 28.0, 31.0 };
	for (size_t i = 0; i < 5; i++) {
		CAPTURE(i);
		CHECK(walker.from[i] == begins[i]);
	}
	CHECK(walker.from.back() == walker.place.x());
}

TEST_CASE("motion: teleports sweep nothing") {
	SUBCASE("out of rest, then standing") {
		for (const double rate : { 10.0, 60.0, 240.0 }) {
			Walker walker(rate);
			walker.stand(3);
			walker.step(Vector3d(13.0, 0.0, 0.0));
			CHECK_FALSE(walker.swept_last());
			walker.stand(30);
			CHECK(walker.from.back() == walker.place.x());
		}
	}
	SUBCASE("of a running body, which goes on running") {
		Walker walker(60.0);
		const Vector3d stride(0.13, 0.0, 0.0), velocity = stride * 60.0;
		for (int i = 0; i < 5; i++) {
			walker.step(stride, velocity);
		}
		walker.step(Vector3d(5.0, 0.0, 0.0) + stride, velocity);
		CHECK_FALSE(walker.swept_last());
		const double landed = walker.place.x();
		for (int i = 0; i < 5; i++) {
			walker.step(stride, velocity);
			CHECK(walker.from.back() >= landed);
			CHECK(walker.swept_last());
		}
	}
	SUBCASE("in successive ticks") {
		Walker walker(60.0);
		walker.stand(3);
		for (const double x : { 5.0, -20.0, 13.0, 40.0, -41.0 }) {
			walker.step(Vector3d(x, 0.0, 3.0));
			CHECK_FALSE(walker.swept_last());
		}
	}
	SUBCASE("the same one again, a while later") {
		Walker walker(60.0);
		for (int i = 0; i < 3; i++) {
			walker.stand(30);
			walker.step(Vector3d(7.0, 0.0, 0.0));
			CHECK_FALSE(walker.swept_last());
		}
	}
	SUBCASE("shorter ones, where the field says so") {
		Walker walker(60.0);
		walker.tick.teleport_speed = 30.0;
		walker.step(Vector3d(0.6, 0.0, 0.0));
		CHECK_FALSE(walker.swept_last());
		walker.stand(30);
		walker.step(Vector3d(0.4, 0.0, 0.0));
		CHECK(walker.swept_last());
	}
}

TEST_CASE("motion: a body that is moved in every fourth tick leaves no gap") {
	Walker walker(240.0);
	walker.stand(3);
	double reached = 0.0;
	for (int i = 0; i < 5; i++) {
		walker.step(Vector3d(3.0, 0.0, 0.0));
		reached = walker.from.back() <= reached ? walker.place.x() : reached;
		walker.stand(3);
	}
	CHECK(reached == walker.place.x());
}

TEST_CASE("motion: a body that is found has come from where its velocity says") {
	MotionTick tick = tick_of(60.0);
	tick.watched = Eigen::AlignedBox3d(Vector3d::Constant(-20.0), Vector3d::Constant(20.0));
	const Vector3d velocity(450.0, 0.0, 0.0), entering(-10.0, 0.0, 0.0), fired(5.0, 0.0, 0.0);
	CHECK(Motion().start(entering, velocity, velocity, tick).x() == doctest::Approx(-25.0));
	CHECK(Motion().start(fired, velocity, velocity, tick).x() == doctest::Approx(-2.5));
	CHECK(Motion().start(fired, NONE, NONE, tick) == fired);
	SUBCASE("a velocity that may be a teleport's counts when it lasts") {
		Motion motion;
		CHECK(motion.start(entering, velocity, NONE, tick) == entering);
		CHECK(motion.is_open());
		CHECK(motion.follow(entering, entering + velocity / 60.0, NONE, tick).x() == doctest::Approx(-25.0));
	}
	SUBCASE("and not when it does not") {
		Motion motion;
		motion.start(entering, velocity, Vector3d(8.0, 0.0, 0.0), tick);
		const Vector3d next = entering + Vector3d(0.1, 0.0, 0.0);
		CHECK(motion.follow(entering, next, NONE, tick) == entering);
	}
	SUBCASE("nothing known, and it goes on fast") {
		Motion motion;
		motion.start(entering, NONE, NONE, tick);
		const Vector3d step(15.0, 0.0, 0.0), second = entering + step;
		CHECK(motion.is_open());
		CHECK(motion.follow(entering, second, NONE, tick) == second);
		CHECK(motion.follow(second, second + step, NONE, tick).x() == doctest::Approx(-25.0));
	}
}

TEST_CASE("motion: it is open while it may still be found to have passed grass") {
	Walker walker(60.0);
	walker.stand(2);
	CHECK_FALSE(walker.motion.is_open());
	walker.step(Vector3d(9.0, 0.0, 0.0));
	CHECK(walker.motion.is_open());
	walker.stand(1);
	CHECK_FALSE(walker.motion.is_open());
}

TEST_CASE("motion: half a turn is put there, a rotor goes on") {
	Motion motion;
	CHECK(motion.follow_turn(0.5, 0.0));
	CHECK(motion.follow_turn(0.0, 0.0));
	CHECK_FALSE(motion.follow_turn(3.0, 0.0));
	CHECK(motion.follow_turn(3.0, 0.0));
	CHECK(Motion().follow_turn(3.0, 3.0));
}

TEST_CASE("motion: what is not finite, and ticks without time, move nothing") {
	const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
	for (const double odd : { nan, inf }) {
		Walker walker(60.0);
		walker.step(Vector3d(odd, 0.0, 0.0));
		walker.place = Vector3d(1.0, 0.0, 0.0);
		walker.step(Vector3d(0.1, 0.0, 0.0));
		CHECK(walker.from.back() == 1.0);
		walker.motion.start(walker.place, Vector3d::Constant(odd), Vector3d::Constant(odd), walker.tick);
		walker.step(Vector3d(0.1, 0.0, 0.0));
		CHECK(std::isfinite(walker.from.back()));
	}
	Walker stopped(60.0);
	stopped.tick.delta = 0.0;
	stopped.stand(1);
	CHECK(stopped.from.back() == 0.0);
	stopped.step(Vector3d(1.0, 0.0, 0.0));
	CHECK_FALSE(stopped.swept_last());
}

TEST_CASE("motion: a limb that swings in any direction does not spin about itself") {
	for (const Vector3d &down : { Vector3d(0, -1, 0), Vector3d(0, 1, 0), Vector3d(1, 0, 0), Vector3d(0.3, -0.2, -0.9) }) {
		CAPTURE(down.transpose());
		const Vector3d side = down.unitOrthogonal(), front = down.cross(side).normalized();
		Eigen::Matrix3d axes = swing_axes(Eigen::Matrix3d::Identity(), down);
		Vector3d along = axes.col(1);
		for (int n = 1; n <= 400; n++) { // round and round, and through the middle
			const double angle = 0.1 * n, sway = 0.4 * std::sin(0.37 * n);
			const Vector3d wanted = (down + sway * (std::cos(angle) * side + std::sin(angle) * front)).normalized();
			const Eigen::Matrix3d next = swing_axes(axes, 0.4 * wanted);
			REQUIRE((next.col(1) - wanted).norm() < 1e-12);
			REQUIRE((next.transpose() * next - Eigen::Matrix3d::Identity()).norm() < 1e-12);
			REQUIRE(next.determinant() > 0.0);
			const double turn = Eigen::AngleAxisd(axes.transpose() * next).angle();
			REQUIRE(turn <= 1.1 * std::acos(std::min(along.dot(wanted), 1.0)) + 1e-6);
			axes = next;
			along = wanted;
		}
	}
}

TEST_CASE("motion: a limb without a direction keeps its axes, one along their x has some") {
	const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
	const Eigen::Matrix3d before = swing_axes(Eigen::Matrix3d::Identity(), Vector3d(1, 2, 3));
	for (const Vector3d &axis : { Vector3d(0, 0, 0), Vector3d(nan, 0, 0), Vector3d(0, inf, 0) }) {
		CHECK(swing_axes(before, axis) == before);
	}
	for (const double size : { 1e-150, 1.0, 1e150 }) {
		const Eigen::Matrix3d axes = swing_axes(before, -size * before.col(0));
		CHECK((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm() < 1e-12);
		CHECK((axes.col(1) + before.col(0)).norm() < 1e-12);
	}
}

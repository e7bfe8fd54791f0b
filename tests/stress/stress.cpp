// SPDX-License-Identifier: MIT
#include "stress.h"

#include "draw_params.h"

#include "core/base/lanes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <sstream>
#include <thread>

namespace grass::test {

namespace {

constexpr float ROOM = 1.0f; // half the box that bodies fly in, metres

vec4 quaternion(float p_angle, const Eigen::Vector3f &p_axis) {
	const Eigen::Quaternionf turn(Eigen::AngleAxisf(p_angle, p_axis));
	return { turn.x(), turn.y(), turn.z(), turn.w() };
}

// Returns the numbers below p_count that this run is for, first and last + 1: all, or in the k-th of n parts of them.
std::pair<int, int> find_part(int p_count) {
	int part = 1, parts = 1;
	if (const char *words = std::getenv("GRASS_STRESS_PART")) {
		REQUIRE_MESSAGE((std::sscanf(words, "%d/%d", &part, &parts) == 2 && part >= 1 && part <= parts),
				"GRASS_STRESS_PART is " << words << "; it takes a part, such as 2/10");
	}
	const auto start = [&](int p_part) { return int(int64_t(p_count) * p_part / parts); };
	return { start(part - 1), start(part) };
}

} // namespace

const char *name_of(Method p_method) {
	return p_method == Method::DIRECT ? "METHOD_DIRECT" : "METHOD_PBD";
}

int sized(int p_usual, int p_full) {
#if defined(GRASS_IS_SANITIZED)
	p_usual = std::min(p_usual, std::max(p_usual / 40, 4)); // as slow as that
#endif
	const char *size = std::getenv("GRASS_STRESS");
	return size && std::string(size) == "full" ? p_full : p_usual;
}

void check_each(int p_count, const std::function<std::string(int)> &p_body) {
	const std::pair<int, int> part = find_part(p_count);
	const int end = part.second;
	std::atomic<int> next = part.first;
	std::mutex mutex;
	std::vector<std::string> failures;
	const auto work = [&] {
		for (int i = next++; i < end; i = next++) {
			const std::string failure = p_body(i);
			if (!failure.empty()) {
				const std::lock_guard lock(mutex);
				failures.push_back("number " + std::to_string(i) + ": " + failure);
			}
		}
	};
	std::vector<std::thread> threads;
	for (unsigned i = 0; i < std::max(std::thread::hardware_concurrency(), 1u); i++) {
		threads.emplace_back(work);
	}
	for (std::thread &thread : threads) {
		thread.join();
	}
	for (const std::string &failure : failures) {
		FAIL_CHECK(failure);
	}
	CHECK(next >= end);
}

Eigen::Vector3f Dice::direction() {
	Eigen::Vector3f way;
	do {
		way = Eigen::Vector3f(float(uniform(-1, 1)), float(uniform(-1, 1)), float(uniform(-1, 1)));
	} while (!(way.norm() > 0.1f && way.norm() < 1.0f));
	return way.normalized();
}

SolverParams Dice::params(Method p_method) {
	const auto draw = [&](const Tunable &p_tunable) {
		const int where = below(10);
		return where == 0 ? p_tunable.minimum : where == 1 ? p_tunable.maximum : within(p_tunable);
	};
	SolverParams params = draw_params(p_method, draw);
	params.iterations = int(std::lround(draw(ITERATIONS)));
	if (below(3) == 0) {
		const Eigen::Vector3f load = direction() * float(uniform(0.0, 20.0));
		std::copy_n(load.data(), 3, params.load);
	}
	return params;
}

double Dice::delta() {
	constexpr double USUAL[] = { 1.0 / 30.0, 1.0 / 60.0, 1.0 / 144.0 };
	switch (below(12)) {
		case 0:
			return 0.0;
		case 1:
			return 0.5;
		case 2:
			return uniform(0.0, 1.0);
		case 3:
			return magnitude(1e-6, 1.0);
		default:
			return USUAL[below(3)];
	}
}

Storm::Storm(BladeScene &r_scene, Dice &r_dice, int p_count, double p_smallest, double p_largest, double p_speed) : _scene(r_scene) {
	for (int i = 0; i < p_count; i++) {
		const auto size = [&] { return float(r_dice.magnitude(p_smallest, p_largest)); };
		const int first = int(_scene.planes.size());
		std::vector<Eigen::Vector4f> planes = std::move(_scene.planes); // add() makes those of one hull
		const int shape = SHAPES[r_dice.below(5)];
		GrassCollider &collider = _scene.add(shape, Eigen::Vector3f::Zero(), { size(), size(), size() });
		if (shape == GRASS_HULL) {
			collider.anchor.w = first;
			planes.insert(planes.end(), _scene.planes.begin(), _scene.planes.end());
		}
		_scene.planes = std::move(planes);
		_bodies.push_back({ Eigen::Vector3f::NullaryExpr([&] { return float(r_dice.uniform(-ROOM, ROOM)); }),
				r_dice.direction() * float(r_dice.magnitude(1e-3, p_speed)), r_dice.direction(), 0.0f,
				float(r_dice.uniform(-20.0, 20.0)) });
		write(collider, _bodies.back(), _bodies.back());
	}
}

void Storm::move(double p_delta) {
	for (size_t i = 0; i < _bodies.size(); i++) {
		Body &body = _bodies[i];
		Body before = body;
		body.centre += body.velocity * float(p_delta);
		body.angle += body.spin * float(p_delta);
		if (before.centre.cwiseAbs().maxCoeff() > ROOM) {
			body.centre = -body.velocity.normalized() * ROOM * 0.5f;
			before = body;
		}
		write(_scene.colliders[i], before, body);
	}
}

void Storm::write(GrassCollider &r_collider, const Body &p_before, const Body &p_now) const {
	BladeScene::place(r_collider, p_before.centre, p_now.centre);
	r_collider.rotation_before = quaternion(p_before.angle, p_before.axis);
	r_collider.rotation = quaternion(p_now.angle, p_now.axis);
}

std::string look_at(const BladeScene &p_scene) {
	if (!p_scene.is_finite()) {
		return "not finite";
	}
	const float stretch = p_scene.stretch();
	std::ostringstream report;
	if (!(stretch <= MOST_STRETCH)) {
		report << "a segment is wrong by " << stretch << " of its length";
	}
	return report.str();
}

std::string calm_down(BladeScene &r_scene, double p_seconds) {
	r_scene.colliders.clear();
	const Method method = r_scene.params.method;
	r_scene.params = SolverParams();
	r_scene.params.method = method;
	r_scene.step_for(p_seconds);
	const float distance = r_scene.distance_from_rest();
	std::ostringstream report;
	if (!(distance < AT_REST)) {
		report << "still " << distance << " L from rest";
	}
	return look_at(r_scene) + report.str();
}

} // namespace grass::test

// SPDX-License-Identifier: MIT
// How contact_rate brings single blades nearer to what METHOD_DIRECT converges to, wherever a body hits them.
#include <doctest/doctest.h>

#include "blade_scene.h"

#include "core/solver/leaves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace grass;
using namespace grass::test;

namespace {

constexpr float RADIUS = 0.15f; // metres
constexpr float FARTHEST = 0.1f; // metres, of a root from the way of the ball's centre
constexpr double LOOKS = 720.0; // a second, of the limit: a multiple of every rate below
constexpr double LIMIT_RATE = 5760.0; // steps a second
constexpr int LIMIT_ITERATIONS = 8; // with fewer friction is farther from its limit
const float SPEEDS[] = { 1.0f, 3.0f, 5.0f }; // m/s

struct Case {
	float speed; // m/s
	bool is_leaf;
	float friction;
};

// Blades at every offset, on both sides of the ball's way. By turns one is straight, one leans and one is curved, to any side.
BladeScene make_blades(const Case &p_case) {
	BladeScene scene;
	scene.params.width_to_thickness = p_case.is_leaf ? WIDTH_TO_THICKNESS.initial : 1.0;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const float lean = b % 3 == 1 ? 0.5f : 0.0f, curve = b % 3 == 2 ? 1.0f : 0.0f, heading = 2.4f * float(b); // radians
		scene.tile->width[0][b] = -sin_of(heading);
		scene.tile->width[1][b] = cos_of(heading);
		scene.tile->root[2][b] = FARTHEST * (float(b) + 0.5f) / GRASS_BLADES_PER_TILE * (b % 2 == 0 ? 1.0f : -1.0f);
		Eigen::Vector3f knot = Eigen::Vector3f::Zero();
		for (int k = 0; k < GRASS_KNOTS; k++) {
			scene.set_rest(b, k, knot);
			const float angle = lean + curve * float(k) / GRASS_SEGMENTS;
			knot += scene.length / GRASS_SEGMENTS *
					Eigen::Vector3f(sin_of(angle) * cos_of(heading), cos_of(angle), sin_of(angle) * sin_of(heading));
		}
	}
	return scene;
}

// A look at all free knots, metres: [blade][knot].
using Look = std::vector<Eigen::Vector3f>;

Look look_at(const BladeScene &p_scene) {
	Look look;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			look.push_back(p_scene.knot(b, k));
		}
	}
	return look;
}

// The blades p_looks times a second while a ball rolls through them, and for as long after it as makes whole thirtieths.
std::vector<Look> roll_through(const Case &p_case, double p_rate, int p_iterations, double p_contact_rate, double p_looks) {
	BladeScene scene = make_blades(p_case);
	scene.params.iterations = p_iterations;
	scene.params.contact_rate = p_contact_rate;
	scene.add(GRASS_SPHERE, { -0.7f, RADIUS, 0.0f }, { RADIUS, 0.0f, 0.0f });
	const double seconds = std::min(1.5, std::ceil(30.0 * (1.2 / double(p_case.speed) + 0.3)) / 30.0);
	std::vector<Look> looks;
	for (int i = 0; i < int(seconds * p_rate + 1e-6); i++) {
		const auto place = [&](int p_step) { return Eigen::Vector3f(-0.7f + p_case.speed * float(p_step / p_rate), RADIUS, 0.0f); };
		BladeScene::place(scene.colliders[0], place(i), place(i + 1));
		scene.colliders[0].position.w = p_case.friction;
		scene.step(1.0 / p_rate);
		if ((i + 1) % int(p_rate / p_looks) == 0) {
			looks.push_back(look_at(scene));
		}
	}
	return looks;
}

// Adds each blade's root mean square over knots and time to r_errors, blade lengths. p_limit: LOOKS times a second.
void add_errors(const std::vector<Look> &p_looks, double p_rate, const std::vector<Look> &p_limit, std::vector<double> &r_errors) {
	const size_t apart = size_t(LOOKS / p_rate);
	for (size_t b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		double sum = 0.0;
		for (size_t i = 0; i < p_looks.size(); i++) {
			const Look &limit = p_limit.at((i + 1) * apart - 1);
			for (size_t j = b * GRASS_FREE_KNOTS; j < (b + 1) * GRASS_FREE_KNOTS; j++) {
				sum += double((p_looks[i][j] - limit[j]).squaredNorm());
			}
		}
		r_errors.push_back(std::sqrt(sum / double(p_looks.size() * GRASS_FREE_KNOTS)) / 0.5);
	}
}

double median_of(std::vector<double> p_errors) {
	std::nth_element(p_errors.begin(), p_errors.begin() + p_errors.size() / 2, p_errors.end());
	return p_errors[p_errors.size() / 2];
}

} // namespace

TEST_CASE("METHOD_DIRECT: from contact_rate 3200 on the median blade that a ball rolls over, at any offset, is within 1.5 % L of the "
		  "converged way at 1 m/s and 5 % at 3 and 5 m/s, and any higher rate is nearer") {
	const double rates[] = { 30.0, 60.0, 144.0 }; // steps a second
	const double contact_rates[] = { 400.0, 800.0, 1600.0, 3200.0, 6400.0 };
	const auto is_tested = [](double p_rate, double p_contact_rate) { return p_rate == 60.0 || p_contact_rate == 3200.0; };
	for (const float speed : SPEEDS) {
		CAPTURE(speed);
		std::vector<double> errors[std::size(rates)][std::size(contact_rates)];
		for (const auto &[is_leaf, friction] : { std::pair(false, 0.0f), { false, 0.5f }, { true, 0.0f }, { true, 0.5f } }) {
			const Case one{ speed, is_leaf, friction };
			const std::vector<Look> limit = roll_through(one, LIMIT_RATE, LIMIT_ITERATIONS, CONTACT_RATE.initial, LOOKS);
			for (size_t r = 0; r < std::size(rates); r++) {
				for (size_t c = 0; c < std::size(contact_rates); c++) {
					if (!is_tested(rates[r], contact_rates[c])) {
						continue;
					}
					const std::vector<Look> looks = roll_through(one, rates[r], int(ITERATIONS.initial), contact_rates[c], rates[r]);
					add_errors(looks, rates[r], limit, errors[r][c]);
				}
			}
		}
		for (size_t r = 0; r < std::size(rates); r++) {
			CAPTURE(rates[r]);
			double before = 1.0; // blade lengths
			for (size_t c = 0; c < std::size(contact_rates); c++) {
				CAPTURE(contact_rates[c]);
				if (!is_tested(rates[r], contact_rates[c])) {
					continue;
				}
				const double error = median_of(errors[r][c]);
				MESSAGE(speed << " m/s, " << rates[r] << " steps a second, contact_rate " << contact_rates[c] << ": " << error << " L");
				CHECK(error < 0.95 * before);
				CHECK((contact_rates[c] < 3200.0 || error < (speed > 2.0f ? 0.05 : 0.015)));
				before = error;
			}
		}
	}
}

TEST_CASE("[Eq 43] contact_rate over its default is how many times more parts a step may have") {
	const double seconds[] = { 1.0 / 30.0, 1.0 / 60.0, 1.0 / 144.0, 1e-5 };
	const std::pair<float, std::array<int, 4>> rows[] = {
		{ 1.0f, { 16, 8, 4, 2 } },
		{ 3.0f, { 64, 32, 16, 2 } },
		{ 8.0f, { 128, 64, 32, 2 } },
		{ 32.0f, { 512, 256, 128, 2 } },
	};
	for (const auto &[finer, parts] : rows) {
		for (size_t i = 0; i < std::size(seconds); i++) {
			CAPTURE(finer);
			CAPTURE(seconds[i]);
			CHECK(most_parts(2, float(seconds[i]), finer) == parts[i]);
			CHECK(most_parts(1, float(seconds[i]), finer) == 1);
		}
	}
}

TEST_CASE("contact_rate changes no bit of blades that no body can reach, and none of METHOD_PBD") {
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		CAPTURE(int(method));
		BladeScene plain(method), fine(method);
		fine.params.contact_rate = CONTACT_RATE.maximum;
		for (BladeScene *scene : { &plain, &fine }) {
			scene->bend(1.0f);
			const float away = method == Method::PBD ? 0.2f : 2.0f; // metres
			scene->add(GRASS_SPHERE, { away, RADIUS, 0.0f }, { RADIUS, 0.0f, 0.0f });
			for (int i = 0; i < 30; i++) {
				BladeScene::place(scene->colliders[0], { away, RADIUS, 0.02f * float(i) }, { away, RADIUS, 0.02f * float(i + 1) });
				scene->step();
			}
		}
		CHECK(plain.distance_from(fine) == 0.0f);
	}
}

// SPDX-License-Identifier: MIT
// How contact_rate brings single blades nearer to what METHOD_DIRECT converges to, wherever a body hits them.
#include <doctest/doctest.h>

#include "rolled_blades.h"
#include "sampled.h"

#include "core/solver/leaves.h"

#include <array>
#include <vector>

using namespace grass;
using namespace grass::test;

namespace {

constexpr float RADIUS = 0.15f; // metres
constexpr double LOOKS = 720.0; // a second, of the limit: a multiple of every rate below
constexpr Stepping LIMIT{ 5760.0, 8, CONTACT_RATE.minimum }; // with fewer iterations friction is farther from its limit
const float SPEEDS[] = { 5.0f, 3.0f, 1.0f, 0.6f }; // m/s; a sample is the first, which takes the least time

} // namespace

TEST_CASE("METHOD_DIRECT: from contact_rate 3200 on the median blade that a ball rolls over, at any offset, is within 1.5 % L of the "
		  "converged way at 0.6 and 1 m/s and 5 % at 3 and 5 m/s, and up to 1600 a higher rate is nearer") {
	const double rates[] = { 30.0, 60.0, 144.0 }; // steps a second
	const double contact_rates[] = { 400.0, 800.0, 1600.0, 3200.0, 6400.0 };
	const auto is_tested = [](double p_rate, double p_contact_rate) { return p_rate == 60.0 || p_contact_rate == 3200.0; };
	for (const float speed : sampled(SPEEDS)) {
		CAPTURE(speed);
		std::vector<double> errors[std::size(rates)][std::size(contact_rates)];
		for (const auto &[is_leaf, friction] : { std::pair(false, 0.0f), { false, 0.5f }, { true, 0.0f }, { true, 0.5f } }) {
			const Roll roll{ speed, is_leaf, friction };
			const std::vector<Look> limit = roll_through(roll, LIMIT, LOOKS);
			for (size_t r = 0; r < std::size(rates); r++) {
				for (size_t c = 0; c < std::size(contact_rates); c++) {
					if (!is_tested(rates[r], contact_rates[c])) {
						continue;
					}
					const std::vector<Look> looks = roll_through(roll, { rates[r], int(ITERATIONS.initial), contact_rates[c] }, rates[r]);
					add_errors(looks, limit, size_t(LOOKS / rates[r]), errors[r][c]);
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
				CHECK(error < (contact_rates[c] > 1600.0 ? 1.15 : speed < 1.0f ? 1.0 : 0.95) * before);
				CHECK((contact_rates[c] < 3200.0 || error < (speed > 2.0f ? 0.05 : 0.015)));
				before = error;
			}
		}
	}
}

TEST_CASE("[Eq 43] contact_rate over its least is how many times more parts a step may have") {
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

TEST_CASE("contact_rate counts as the next one of 400, 800, 1600 and so on, whatever lies between") {
	const auto counted = [](double p_rate) {
		SolverParams params;
		params.contact_rate = p_rate;
		return params.sanitised().contact_rate;
	};
	const std::pair<double, double> rows[] = { { 0.0, 400.0 }, { 400.0, 400.0 }, { 401.0, 800.0 }, { 600.0, 800.0 }, { 800.0, 800.0 },
		{ 1200.0, 1600.0 }, { 6120.0, 6400.0 }, { 12800.0, 12800.0 }, { 1e9, 12800.0 }, { double(NOT_A_NUMBER), CONTACT_RATE.initial } };
	for (const auto &[rate, wanted] : rows) {
		CAPTURE(rate);
		CHECK(counted(rate) == wanted);
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

TEST_CASE("contact_rate changes no bit of blades beside bodies that creep") {
	for (const int shape : { GRASS_SPHERE, GRASS_BOX, GRASS_CYLINDER }) {
		CAPTURE(shape);
		BladeScene plain, fine;
		plain.params.contact_rate = CONTACT_RATE.minimum;
		fine.params.contact_rate = CONTACT_RATE.maximum;
		for (BladeScene *scene : { &plain, &fine }) {
			scene->add(shape, { 0.0f, 0.1f, 0.0f }, { 0.1f, 0.1f, 0.1f });
		}
		const auto place = [](int p_step) { return Eigen::Vector3f(0.07f * float(p_step) / 60.0f, 0.1f, 0.0f); }; // 0.14 lengths a second
		float bent = 0.0f;
		for (int i = 0; i < 240; i++) {
			for (BladeScene *scene : { &plain, &fine }) {
				BladeScene::place(scene->colliders[0], place(i), place(i + 1));
				scene->step();
			}
			bent = std::max(bent, plain.distance_from_rest());
			REQUIRE(plain.distance_from(fine) == 0.0f);
		}
		CHECK(bent > 0.1f);
	}
}

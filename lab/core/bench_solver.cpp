// SPDX-License-Identifier: MIT
// The solver's figures: time back to rest, sag, contact, blades per second. Prints what lab/results/solver.md quotes; with
// `speed`, only the table of blades per second.
#include "blade_scene.h"

#include <chrono>
#include <cstdio>
#include <string>
#include <utility>

using namespace grass;
using namespace grass::test;

namespace {

constexpr double RATES[] = { 30.0, 60.0, 144.0, 720.0 };
constexpr int ITERATION_COUNTS[] = { 2, 3, 10 };

void print_return() {
	std::printf("Released from an arc of 1.5 rad: seconds until all 64 blades stay within 10 %% and 1 %% of their length of rest,\n"
				"overshoot (blade lengths), RMS difference of a tip's path from that at 720 Hz, 3 iterations (blade lengths)\n");
	const auto path = [](double p_rate, int p_iterations, double &r_tenth, double &r_hundredth, float &r_overshoot) {
		BladeScene scene;
		scene.params.iterations = p_iterations;
		scene.bend(1.5f);
		std::vector<Eigen::Vector3f> places{ scene.knot(40, GRASS_KNOTS - 1) };
		for (int i = 1; i <= int(3.0 * p_rate); i++) {
			scene.step(1.0 / p_rate);
			const float distance = scene.distance_from_rest();
			r_tenth = distance > 0.1f ? i / p_rate : r_tenth;
			r_hundredth = distance > 0.01f ? i / p_rate : r_hundredth;
			r_overshoot = std::max(r_overshoot, (scene.rest(0, GRASS_KNOTS - 1) - scene.knot(0, GRASS_KNOTS - 1)).x() / scene.length);
			places.push_back(scene.knot(40, GRASS_KNOTS - 1));
		}
		return places;
	};
	double tenth, hundredth;
	float overshoot = 0.0f;
	const std::vector<Eigen::Vector3f> reference = path(720.0, 3, tenth, hundredth, overshoot);
	for (const double rate : RATES) {
		for (const int iterations : ITERATION_COUNTS) {
			overshoot = 0.0f;
			const std::vector<Eigen::Vector3f> places = path(rate, iterations, tenth, hundredth, overshoot);
			double sum = 0.0;
			for (size_t i = 0; i < reference.size(); i++) { // the path between two steps is taken as straight
				const double at = double(i) * rate / 720.0;
				const size_t step = std::min(size_t(at), places.size() - 2);
				const float share = float(at - double(step));
				sum += double((places[step] * (1.0f - share) + places[step + 1] * share - reference[i]).squaredNorm());
			}
			std::printf("  %3.0f Hz, %2d iterations: %.3f s, %.3f s, %.3f, %.4f\n", rate, iterations, tenth, hundredth, double(overshoot),
					std::sqrt(sum / double(reference.size())) / 0.5);
		}
	}
}

void print_sag() {
	std::printf("Sag of a straight blade's tip under 4 m/s^2 across (blade lengths)\n");
	for (const double rate : RATES) {
		std::printf("  %3.0f Hz:", rate);
		for (const int iterations : ITERATION_COUNTS) {
			BladeScene scene;
			scene.params.iterations = iterations;
			scene.params.load[0] = 4.0;
			scene.step_for(6.0, rate);
			std::printf("  %d iterations %.5f", iterations, double(scene.knot(0, GRASS_KNOTS - 1).x() / scene.length));
		}
		std::printf("\n");
	}
}

void print_contact() {
	std::printf("A sphere (r = 0.15 m) rolls through the tile: worst stretch (share), worst depth (m, of blades whose clamp is free),\n"
				"seconds from its leaving the root to 1 %% of rest\n");
	for (const double rate : { 30.0, 60.0, 144.0 }) {
		for (const float speed : { 1.0f, 5.0f, 20.0f, 1000.0f }) {
			BladeScene scene;
			scene.add(GRASS_SPHERE, Eigen::Vector3f::Zero(), { 0.15f, 0.0f, 0.0f });
			const float stride = speed / float(rate);
			const int count = int(2.0f / stride) + 4;
			float stretch = 0.0f, depth = 0.0f;
			double last = 0.0;
			for (int i = 0; i < count + int(3.0 * rate); i++) {
				const float x = (float(i) - 0.5f * float(count) + 0.37f) * stride;
				BladeScene::place(scene.colliders[0], { x - stride, 0.15f, 0.02f }, { x, 0.15f, 0.02f });
				scene.step(1.0 / rate);
				stretch = std::max(stretch, scene.stretch());
				depth = std::max(depth, scene.depth());
				last = scene.distance_from_rest() > 0.01f ? double(x / speed) : last;
			}
			std::printf("  %3.0f Hz, %4.0f m/s: %.1e, %.1e, %.2f s\n", rate, double(speed), double(stretch), double(depth), last);
		}
	}
}

// A table of million blades a second on one core, 60 Hz, defaults, the best of some rounds. The versions take turns, so that what else the
// machine does slows all of them.
void print_speed() {
	constexpr const char *LANES[] = { "4 lanes", "8 lanes", "16 lanes" };
	constexpr const char *SCENES[] = { "at rest", "swinging", "among 4 colliders" };
	constexpr int ROUNDS = 20, STEPS[] = { 200, 30, 30 };
	std::vector<std::pair<const char *, Step>> versions{ { "double", step_scalar_double }, { "float", step_scalar_float } };
	for (size_t i = 0; i < get_lane_steps().size(); i++) {
		versions.emplace_back(LANES[i], get_lane_steps()[i]);
	}
	std::printf("method,scene,numbers,million_blades_a_second,times_double\n");
	const auto time = [&](Method p_method, int p_kind, Step p_step) {
		BladeScene scene(p_method);
		scene.step_function = p_step;
		for (int j = 0; j < 4 && p_kind == 2; j++) {
			scene.add(j, { 0.2f * float(j) - 0.3f, 0.25f, 0.1f * float(j) }, { 0.1f, 0.1f, 0.1f });
		}
		if (p_kind != 0) {
			scene.bend(1.0f);
		}
		scene.step();
		const auto start = std::chrono::steady_clock::now();
		for (int step = 0; step < STEPS[p_kind]; step++) {
			scene.step();
		}
		return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / STEPS[p_kind] / GRASS_BLADES_PER_TILE;
	};
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		for (int kind = 0; kind < 3; kind++) {
			std::vector<std::vector<double>> seconds(versions.size());
			for (int round = 0; round < ROUNDS; round++) {
				for (size_t i = 0; i < versions.size(); i++) {
					seconds[i].push_back(time(method, kind, versions[i].second));
				}
			}
			for (size_t i = 0; i < versions.size(); i++) {
				const auto best = [&](size_t p_of) { return *std::min_element(seconds[p_of].begin(), seconds[p_of].end()); };
				std::printf("%s,%s,%s,%.2f,%.2f\n", method == Method::DIRECT ? "DIRECT" : "PBD", SCENES[kind], versions[i].first,
						1e-6 / best(i), best(0) / best(i));
			}
		}
	}
}

// Microseconds that a step of a blade takes on one core, on average over a scene; best of 5.
void print_contact_speed() {
	std::printf("Microseconds a blade step, lanes, 60 Hz, defaults\n");
	const auto print = [](const char *p_name, int p_steps, const std::function<void(BladeScene &)> &p_make,
							   const std::function<void(BladeScene &, int)> &p_move) {
		double best = 1e9;
		for (int i = 0; i < 5; i++) {
			BladeScene scene;
			p_make(scene);
			const auto start = std::chrono::steady_clock::now();
			for (int step = 0; step < p_steps; step++) {
				p_move(scene, step);
				scene.step();
			}
			best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
		}
		std::printf("  %-22s: %.2f\n", p_name, best / p_steps / GRASS_BLADES_PER_TILE * 1e6);
	};
	const auto add = [](int p_shape, const Eigen::Vector3f &p_size) {
		return [=](BladeScene &r_scene) { r_scene.add(p_shape, Eigen::Vector3f::Zero(), p_size); };
	};
	const auto stay = [](BladeScene &, int) {};
	const auto slide = [](BladeScene &r_scene, int p_step) {
		const float x = float(p_step) / 60.0f - 0.7f;
		BladeScene::place(r_scene.colliders[0], { x, 0.15f, 0.02f }, { x + 1.0f / 60.0f, 0.15f, 0.02f });
	};
	const auto press = [](float p_height) {
		return [=](BladeScene &r_scene, int p_step) {
			const auto height = [&](int p_at) { return std::max(0.8f - 0.01f * float(p_at), p_height); };
			BladeScene::place(r_scene.colliders[0], { 0.1f, height(p_step), 0.02f }, { 0.1f, height(p_step + 1), 0.02f });
		};
	};
	print(
			"swinging", 120, [](BladeScene &r_scene) { r_scene.bend(1.0f); }, stay);
	print(
			"swinging, 4 colliders", 120,
			[](BladeScene &r_scene) {
				for (int i = 0; i < 4; i++) {
					r_scene.add(i, { 0.2f * float(i) - 0.3f, 0.25f, 0.1f * float(i) }, { 0.1f, 0.1f, 0.1f });
				}
				r_scene.bend(1.0f);
			},
			stay);
	print("a ball rolls through", 84, add(GRASS_SPHERE, { 0.15f, 0.0f, 0.0f }), slide);
	print("a crate slides through", 84, add(GRASS_BOX, { 0.15f, 0.15f, 0.15f }), slide);
	print("pressed by a ball", 180, add(GRASS_SPHERE, { 0.3f, 0.0f, 0.0f }), press(0.4f));
	print("pressed by a slab", 180, add(GRASS_BOX, { 0.3f, 0.1f, 0.3f }), press(0.2f));
}

} // namespace

int main(int p_count, char **p_arguments) {
	if (p_count > 1 && std::string(p_arguments[1]) == "speed") {
		print_speed();
		return 0;
	}
	print_return();
	print_sag();
	print_contact();
	print_speed();
	print_contact_speed();
}

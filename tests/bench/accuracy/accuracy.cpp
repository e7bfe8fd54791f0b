// SPDX-License-Identifier: MIT
// Run time against error of both solver methods on reference problems, for GRASS_KNOTS knots: CSV to the standard
// output. `./grass bench accuracy` builds and runs it for 8, 16 and 32 knots and draws the plots.
//   accuracy_16 [--quick]                 rows of the CPU
//   accuracy_16 --record FOLDER [--quick] writes what a GPU is to compute to FOLDER/METHOD_16.pack
//   accuracy_16 --play FOLDER [--quick]   rows of the GPU that made FOLDER/METHOD_16.result of it
#include "blade_scene.h"
#include "references.h"
#include "tape.h"

#include <chrono>
#include <cstdio>

using namespace grass;
using namespace grass::test;

namespace {

constexpr double FRAME = 1.0 / 60.0; // seconds

struct Config {
	Method method;
	Step step;
	int substeps; // a frame
	int iterations; // a substep
};

// On tape, p_keep is what of the problem is wanted back after every p_stride steps.
BladeScene make_scene(const Config &p_config, Keep p_keep, int p_stride, double p_damping_ratio, double p_frequency = 1.2) {
	BladeScene scene;
	if (p_config.step == step_on_tape) {
		tape->begin(p_keep, p_stride);
	}
	scene.params.method = p_config.method;
	scene.params.iterations = p_config.iterations;
	scene.params.damping_ratio = p_damping_ratio;
	scene.params.natural_frequency = p_frequency;
	scene.params.taper = 0.0; // the references are even rods, and round
	scene.params.width_to_thickness = 1.0;
	scene.step_function = p_config.step;
	return scene;
}

void step_frame(BladeScene &r_scene, const Config &p_config) {
	r_scene.step_for(FRAME, p_config.substeps / FRAME);
}

// Error of the straight blade's sag under an even load across it, share.
double static_error(const Config &p_config, double p_gamma) {
	constexpr int FRAMES = 300;
	BladeScene scene = make_scene(p_config, Keep::TIP, FRAMES * p_config.substeps, 1.0);
	scene.params.load[0] = load_of_gamma(p_gamma, scene.params.natural_frequency, double(scene.length));
	for (int frame = 0; frame < FRAMES; frame++) {
		step_frame(scene, p_config);
	}
	return std::abs(double(scene.knot(0, GRASS_KNOTS - 1).x() / scene.length) / elastica_drop(p_gamma) - 1.0);
}

// Error of the straight blade's first frequency, share; r_kept: amplitude kept a period.
double frequency_error(const Config &p_config, double &r_kept) {
	const double frequency = 2.5;
	BladeScene scene = make_scene(p_config, Keep::TIP, 1, 1.0, frequency);
	scene.params.load[0] = load_of_gamma(0.1, frequency, double(scene.length));
	for (int frame = 0; frame < 120; frame++) {
		step_frame(scene, p_config);
	}
	scene.params.load[0] = 0.0;
	scene.params.damping_ratio = 0.0;
	const double delta = FRAME / p_config.substeps;
	double before = 0.0, first = 0.0, last = 0.0, most = 0.0, first_most = 0.0, last_most = 0.0;
	int periods = -1;
	for (int i = 0; i < int(3.0 / delta); i++) {
		scene.step(delta);
		const double now = double(scene.knot(0, GRASS_KNOTS - 1).x());
		most = std::max(most, std::abs(now));
		if (before < 0.0 && now >= 0.0) {
			last = (double(i) - now / (now - before)) * delta;
			last_most = most;
			if (++periods == 0) {
				first = last;
				first_most = most;
			}
			most = 0.0;
		}
		before = now;
	}
	r_kept = periods > 0 ? std::pow(last_most / first_most, 1.0 / periods) : 0.0;
	return periods > 0 ? std::abs(periods / (last - first) / frequency - 1.0) : 1.0;
}

using Track = std::vector<Eigen::Vector3f>; // all knots of all blades, frame after frame, metres

void append_knots(const BladeScene &p_scene, Track &r_path) {
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			r_path.push_back(p_scene.knot(b, k));
		}
	}
}

// Released from an arc, for a second.
Track transient(const Config &p_config) {
	BladeScene scene = make_scene(p_config, Keep::KNOTS, p_config.substeps, 0.1);
	scene.bend(1.0f);
	Track path;
	for (int frame = 0; frame < 60; frame++) {
		step_frame(scene, p_config);
		append_knots(scene, path);
	}
	return path;
}

// A ball rolls through at 5 m/s, for 0.3 seconds.
Track sphere_sweep(const Config &p_config) {
	BladeScene scene = make_scene(p_config, Keep::KNOTS, p_config.substeps, 0.5);
	scene.add(GRASS_SPHERE, Eigen::Vector3f::Zero(), { 0.15f, 0.0f, 0.0f });
	const float stride = 5.0f * float(FRAME) / float(p_config.substeps);
	Track path;
	float x = -0.6f;
	for (int frame = 0; frame < 18; frame++) {
		for (int i = 0; i < p_config.substeps; i++, x += stride) {
			BladeScene::place(scene.colliders[0], { x, 0.2f, 0.02f }, { x + stride, 0.2f, 0.02f });
			scene.step(FRAME / p_config.substeps);
		}
		append_knots(scene, path);
	}
	return path;
}

// Root of the mean square of the distance, blade lengths.
double difference(const Track &p_a, const Track &p_b) {
	double sum = 0.0;
	for (size_t i = 0; i < p_a.size(); i++) {
		sum += double((p_a[i] - p_b[i]).squaredNorm());
	}
	return std::sqrt(sum / double(p_a.size())) / 0.5;
}

// A ball without friction rolls past the blades' root at p_speed, 9 cm aside, for p_frames.
Track pass_by(const Config &p_config, float p_speed, int p_frames) {
	BladeScene scene = make_scene(p_config, Keep::KNOTS, p_config.substeps, 0.5);
	scene.params.friction = 0.0;
	scene.add(GRASS_SPHERE, {}, { 0.15f, 0.0f, 0.0f });
	const double delta = FRAME / p_config.substeps;
	const auto place = [&](int p_step) { return Eigen::Vector3f(-0.5f + p_speed * float(p_step * delta), 0.15f, 0.09f); };
	Track path;
	for (int i = 0; i < p_frames * p_config.substeps; i++) {
		BladeScene::place(scene.colliders[0], place(i), place(i + 1));
		scene.step(delta);
		if ((i + 1) % p_config.substeps == 0) {
			append_knots(scene, path);
		}
	}
	return path;
}
Track slow_pass(const Config &p_config) {
	return pass_by(p_config, 1.0f, 90);
}
Track fast_pass(const Config &p_config) {
	return pass_by(p_config, 5.0f, 48);
}

// How far from a body's surface it holds the blades that it has moved to p_to in two seconds: the mean, blade lengths. No knot of a blade
// that it holds should be farther.
double standoff(
		const Config &p_config, int p_shape, const Eigen::Vector3f &p_size, const Eigen::Vector3f &p_from, const Eigen::Vector3f &p_to) {
	constexpr int MOVE = 120, FRAMES = 240;
	BladeScene scene = make_scene(p_config, Keep::KNOTS, FRAMES * p_config.substeps, 1.0);
	scene.params.friction = 0.0;
	scene.add(p_shape, p_from, p_size);
	const double half = std::sqrt(0.5);
	if (p_shape == GRASS_CAPSULE) { // lying across
		scene.colliders[0].rotation = scene.colliders[0].rotation_before = { float(half), 0.0f, 0.0f, float(half) };
	}
	const int moves = MOVE * p_config.substeps;
	const auto place = [&](int p_step) {
		return Eigen::Vector3f(p_from + (p_to - p_from) * (float(std::min(p_step, moves)) / float(moves)));
	};
	for (int i = 0; i < FRAMES * p_config.substeps; i++) {
		BladeScene::place(scene.colliders[0], place(i), place(i + 1));
		scene.step(FRAME / p_config.substeps);
	}
	const TileCollider body = scene.tile_colliders()[0];
	double sum = 0.0;
	int held = 0;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		float gap = 1.0f; // metres
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			gap = std::min(gap, std::abs(scene.depth_in(body, b, k)));
		}
		if (gap < scene.length / GRASS_SEGMENTS) {
			sum += double(gap / scene.length);
			held++;
		}
	}
	return sum / std::max(held, 1);
}

// Milliseconds that a frame of 65,536 swinging blades takes: on one core, or on the GPU.
double time_frame(const Config &p_config) {
	BladeScene scene = make_scene(p_config, Keep::TIME, 1, 0.05);
	scene.bend(1.0f);
	if (p_config.step == step_on_tape) {
		step_frame(scene, p_config);
		return tape->milliseconds();
	}
	double best = 1e9;
	for (int frame = 0; frame < 40; frame++) {
		const auto start = std::chrono::steady_clock::now();
		step_frame(scene, p_config);
		best = std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
	}
	return best * 65536.0 / GRASS_BLADES_PER_TILE;
}

struct References {
	Track transient, sweep, slow_pass, fast_pass;
};

struct Row {
	double ms;
	std::pair<const char *, double> errors[10];
};

// Solves every problem with one configuration.
Row measure(const Config &p_config, const References &p_references) {
	const double ms = time_frame(p_config);
	double kept = 0.0;
	const double frequency = frequency_error(p_config, kept);
	const double static_1 = static_error(p_config, 1.0), static_5 = static_error(p_config, 5.0);
	return { ms,
		{ { "static_1", static_1 }, { "static_5", static_5 }, { "frequency", frequency }, { "amplitude_lost", std::max(1.0 - kept, 0.0) },
				{ "transient", difference(transient(p_config), p_references.transient) },
				{ "sphere_sweep", difference(sphere_sweep(p_config), p_references.sweep) },
				{ "slow_pass", difference(slow_pass(p_config), p_references.slow_pass) },
				{ "fast_pass", difference(fast_pass(p_config), p_references.fast_pass) },
				{ "plate", standoff(p_config, GRASS_BOX, { 2.0f, 0.05f, 2.0f }, { 0.0f, 0.6f, 0.0f }, { 0.0f, 0.25f, 0.0f }) },
				{ "post", standoff(p_config, GRASS_CAPSULE, { 0.03f, 1.0f, 0.0f }, { -0.04f, 0.3f, 0.0f }, { 0.05f, 0.3f, 0.0f }) } } };
}

const char *name_of(Method p_method) {
	return p_method == Method::DIRECT ? "DIRECT" : "PBD";
}

// Solves everything with every configuration of a method and step function.
void measure_all(Method p_method, Step p_step, bool p_is_quick, const References &p_references,
		const std::function<void(const Config &, const Row &)> &p_report) {
	for (const int substeps : { 1, 2, 4 }) {
		for (const int iterations : { 1, 2, 4 }) {
			if (p_is_quick && (substeps == 4 || iterations == 4)) {
				continue;
			}
			const Config config{ p_method, p_step, substeps, iterations };
			p_report(config, measure(config, p_references));
		}
	}
}

void print_rows(const char *p_precision, const Config &p_config, const Row &p_row) {
	for (const auto &[name, value] : p_row.errors) {
		std::printf("%s,%s,%d,%d,%d,%.4g,%s,%.6g\n", name_of(p_config.method), p_precision, GRASS_KNOTS, p_config.substeps,
				p_config.iterations, p_row.ms, name, value);
	}
	std::fflush(stdout);
}

References solve_references() {
	const Config converged{ Method::DIRECT, step_scalar_double, 8, 8 };
	const Config fine{ Method::DIRECT, step_lanes, 32, 8 }; // contact is of first order
	return { transient(converged), sphere_sweep(fine), slow_pass(fine), fast_pass(fine) };
}

void measure_cpu(bool p_is_quick) {
	const References references = solve_references();
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		measure_all(method, step_lanes, p_is_quick, references,
				[](const Config &p_config, const Row &p_row) { print_rows("CPU float", p_config, p_row); });
		if (!p_is_quick) {
			measure_all(method, step_scalar_double, p_is_quick, references,
					[](const Config &p_config, const Row &p_row) { print_rows("CPU double", p_config, p_row); });
		}
	}
}

std::string file_of(const std::string &p_folder, Method p_method, const char *p_kind) {
	return p_folder + "/" + name_of(p_method) + "_" + std::to_string(GRASS_KNOTS) + "." + p_kind;
}

void record(const std::string &p_folder, bool p_is_quick) {
	const Config any{ Method::DIRECT, step_lanes, 1, 1 }; // tracks of the right length: nothing is compared yet
	const References references{ transient(any), sphere_sweep(any), slow_pass(any), fast_pass(any) };
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		Recorder recorder;
		tape = &recorder;
		measure_all(method, step_on_tape, p_is_quick, references, [](const Config &, const Row &) {});
		recorder.write(file_of(p_folder, method, "pack"));
	}
}

void play(const std::string &p_folder, bool p_is_quick) {
	const References references = solve_references();
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		Player player(file_of(p_folder, method, "result"));
		tape = &player;
		measure_all(method, step_on_tape, p_is_quick, references, [&](const Config &p_config, const Row &p_row) {
			print_rows(player.is_software() ? "GPU in software" : "GPU", p_config, p_row);
		});
		player.finish();
	}
}

} // namespace

int main(int p_count, char **p_arguments) {
	std::vector<std::string> arguments(p_arguments + 1, p_arguments + p_count);
	const bool is_quick = std::erase(arguments, "--quick") > 0;
	try {
		if (arguments.empty()) {
			measure_cpu(is_quick);
		} else if (arguments.size() == 2 && arguments[0] == "--record") {
			record(arguments[1], is_quick);
		} else if (arguments.size() == 2 && arguments[0] == "--play") {
			play(arguments[1], is_quick);
		} else {
			std::fprintf(stderr, "usage: %s [--record FOLDER | --play FOLDER] [--quick]\n", p_arguments[0]);
			return 2;
		}
	} catch (const std::runtime_error &error) {
		std::fprintf(stderr, "%s\n", error.what());
		return 1;
	}
}

// SPDX-License-Identifier: MIT
// Run time against error of both solver methods on reference problems, for GRASS_KNOTS knots: CSV to the standard
// output. `./grass bench` builds and runs it for 8, 16 and 32 knots and draws the plots.
//   accuracy_16 [--quick]                 rows of the CPU
//   accuracy_16 --record FOLDER [--quick] writes what a GPU is to compute to FOLDER/METHOD_16.pack
//   accuracy_16 --play FOLDER [--quick]   rows of the GPU that made FOLDER/METHOD_16.result of it
#include "contact.h"
#include "free_motion.h"

#include <cstdio>

using namespace grass;
using namespace grass::test;

namespace {

// Returns milliseconds that a frame of 65,536 blades takes, on one core or on the GPU.
double time_frame(BladeScene &r_scene, const Config &p_config) {
	if (p_config.step == step_on_tape) {
		step_frame(r_scene, p_config);
		return tape->milliseconds();
	}
	return frame_time(r_scene, p_config);
}

double time_swinging(const Config &p_config) {
	BladeScene scene = make_scene(p_config, Keep::TIME, 1, 0.05);
	scene.bend(1.0f);
	return time_frame(scene, p_config);
}

struct References {
	Track transient, sweep, slow_pass, fast_pass;
	std::vector<Sward> slow_ensemble, fast_ensemble;
};

struct Error {
	const char *name;
	double ms, value;
};
using Errors = std::vector<Error>;

void measure_free(const Config &p_config, const References &p_references, Errors &r_errors) {
	const double ms = time_swinging(p_config);
	double kept = 0.0;
	const double frequency = frequency_error(p_config, kept);
	r_errors.push_back({ "static_1", ms, static_error(p_config, 1.0) });
	r_errors.push_back({ "static_5", ms, static_error(p_config, 5.0) });
	r_errors.push_back({ "frequency", ms, frequency });
	r_errors.push_back({ "amplitude_lost", ms, std::max(1.0 - kept, 0.0) });
	r_errors.push_back({ "transient", ms, difference(transient(p_config), p_references.transient) });
}

void measure_contact(const Config &p_config, const References &p_references, Errors &r_errors) {
	BladeScene scene = make_swept(p_config, Keep::TIME);
	const double ms = time_frame(scene, p_config);
	r_errors.push_back({ "sphere_sweep", ms, difference(sphere_sweep(p_config), p_references.sweep) });
	r_errors.push_back({ "slow_pass", ms, difference(slow_pass(p_config), p_references.slow_pass) });
	r_errors.push_back({ "fast_pass", ms, difference(fast_pass(p_config), p_references.fast_pass) });
	r_errors.push_back({ "plate", ms, standoff(p_config, PLATE) });
	r_errors.push_back({ "post", ms, standoff(p_config, POST) });
	if (p_config.step != step_on_tape) {
		r_errors.push_back({ "tremble", ms, std::max(tremble(p_config, PLATE), tremble(p_config, POST)) });
		r_errors.push_back({ "slow_ensemble", ms, difference(slow_ensemble(p_config), p_references.slow_ensemble).height });
		r_errors.push_back({ "fast_ensemble", ms, difference(fast_ensemble(p_config), p_references.fast_ensemble).pressed });
	}
}

// Solves every problem with one configuration.
Errors measure(const Config &p_config, const References &p_references) {
	Errors errors;
	measure_free(p_config, p_references, errors);
	measure_contact(p_config, p_references, errors);
	return errors;
}

const char *name_of(Method p_method) {
	return p_method == Method::DIRECT ? "DIRECT" : "PBD";
}

// Solves everything with every configuration of a method and step function.
void measure_all(Method p_method, Step p_step, bool p_is_quick, const References &p_references,
		const std::function<void(const Config &, const Errors &)> &p_report) {
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

void print_rows(const char *p_precision, const Config &p_config, const Errors &p_errors) {
	for (const auto &[name, ms, value] : p_errors) {
		std::printf("%s,%s,%d,%d,%d,%.4g,%s,%.6g\n", name_of(p_config.method), p_precision, GRASS_KNOTS, p_config.substeps,
				p_config.iterations, ms, name, value);
	}
	std::fflush(stdout);
}

// With twice as many steps a float's rounding shows in slow motion.
constexpr int LIMIT = 128, QUICK_LIMIT = 16; // steps a frame

// What errors are measured against. Strongly bent or touched, blades converge by the first order of the step or more slowly.
References solve_references(int p_substeps) {
	const Config free{ Method::DIRECT, step_scalar_double, p_substeps, 8 }, contact{ Method::DIRECT, step_lanes, p_substeps, 8 };
	return { transient(free), sphere_sweep(contact), slow_pass(contact), fast_pass(contact), slow_ensemble(contact),
		fast_ensemble(contact) };
}

// How far references with half as many steps are from these: about as far as these are from the limit.
void print_reference_rows(const References &p_references) {
	const References half = solve_references(LIMIT / 2);
	print_rows("reference", { Method::DIRECT, step_lanes, LIMIT / 2, 8 },
			{ { "transient", 0.0, difference(half.transient, p_references.transient) },
					{ "sphere_sweep", 0.0, difference(half.sweep, p_references.sweep) },
					{ "slow_pass", 0.0, difference(half.slow_pass, p_references.slow_pass) },
					{ "fast_pass", 0.0, difference(half.fast_pass, p_references.fast_pass) },
					{ "slow_ensemble", 0.0, difference(half.slow_ensemble, p_references.slow_ensemble).height },
					{ "fast_ensemble", 0.0, difference(half.fast_ensemble, p_references.fast_ensemble).pressed } });
}

void measure_cpu(bool p_is_quick) {
	const References references = solve_references(p_is_quick ? QUICK_LIMIT : LIMIT);
	if (!p_is_quick) {
		print_reference_rows(references);
	}
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		measure_all(method, step_lanes, p_is_quick, references,
				[](const Config &p_config, const Errors &p_errors) { print_rows("CPU float", p_config, p_errors); });
		if (!p_is_quick) {
			measure_all(method, step_scalar_double, p_is_quick, references,
					[](const Config &p_config, const Errors &p_errors) { print_rows("CPU double", p_config, p_errors); });
		}
	}
}

std::string file_of(const std::string &p_folder, Method p_method, const char *p_kind) {
	return p_folder + "/" + name_of(p_method) + "_" + std::to_string(GRASS_KNOTS) + "." + p_kind;
}

void record(const std::string &p_folder, bool p_is_quick) {
	const Config any{ Method::DIRECT, step_lanes, 1, 1 }; // tracks of the right length: nothing is compared yet
	const References references{ transient(any), sphere_sweep(any), slow_pass(any), fast_pass(any), {}, {} };
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		Recorder recorder;
		tape = &recorder;
		measure_all(method, step_on_tape, p_is_quick, references, [](const Config &, const Errors &) {});
		recorder.write(file_of(p_folder, method, "pack"));
	}
}

void play(const std::string &p_folder, bool p_is_quick) {
	const References references = solve_references(p_is_quick ? QUICK_LIMIT : LIMIT);
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		Player player(file_of(p_folder, method, "result"));
		tape = &player;
		measure_all(method, step_on_tape, p_is_quick, references, [&](const Config &p_config, const Errors &p_errors) {
			print_rows(player.is_software() ? "GPU in software" : "GPU", p_config, p_errors);
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

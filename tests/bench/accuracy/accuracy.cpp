// SPDX-License-Identifier: MIT
// Run time against error of both solver methods on reference problems, for GRASS_KNOTS knots: CSV to the standard
// output. `./grass bench accuracy` builds and runs it for 8, 16 and 32 knots and draws the plots.
#include "blade_scene.h"
#include "references.h"

#include <chrono>
#include <cstdio>
#include <cstring>

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

BladeScene make_scene(const Config &p_config, double p_damping_ratio, double p_frequency = 1.2) {
	BladeScene scene;
	scene.params.method = p_config.method;
	scene.params.iterations = p_config.iterations;
	scene.params.damping_ratio = p_damping_ratio;
	scene.params.natural_frequency = p_frequency;
	scene.step_function = p_config.step;
	return scene;
}

void step_frame(BladeScene &r_scene, const Config &p_config) {
	r_scene.step_for(FRAME, p_config.substeps / FRAME);
}

// Error of the straight blade's sag under an even load across it, share.
double static_error(const Config &p_config, double p_gamma) {
	BladeScene scene = make_scene(p_config, 1.0);
	scene.params.load[0] = load_of_gamma(p_gamma, scene.params.natural_frequency, double(scene.length));
	for (int frame = 0; frame < 300; frame++) {
		step_frame(scene, p_config);
	}
	return std::abs(double(scene.knot(0, GRASS_KNOTS - 1).x() / scene.length) / elastica_drop(p_gamma) - 1.0);
}

// Error of the straight blade's first frequency, share; r_kept: amplitude kept a period.
double frequency_error(const Config &p_config, double &r_kept) {
	const double frequency = 2.5;
	BladeScene scene = make_scene(p_config, 1.0, frequency);
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
	BladeScene scene = make_scene(p_config, 0.1);
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
	BladeScene scene = make_scene(p_config, 0.5);
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

// Milliseconds that a frame of 65,536 swinging blades takes on one core.
double time_frame(const Config &p_config) {
	BladeScene scene = make_scene(p_config, 0.05);
	scene.bend(1.0f);
	double best = 1e9;
	for (int frame = 0; frame < 40; frame++) {
		const auto start = std::chrono::steady_clock::now();
		step_frame(scene, p_config);
		best = std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
	}
	return best * 65536.0 / GRASS_BLADES_PER_TILE;
}

} // namespace

int main(int p_count, char **p_arguments) {
	const bool is_quick = p_count > 1 && std::strcmp(p_arguments[1], "--quick") == 0;
	const Config converged{ Method::DIRECT, step_scalar_double, 8, 8 };
	const Track transient_reference = transient(converged), sweep_reference = sphere_sweep(converged);
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		for (const Step step : { step_lanes, step_scalar_double }) {
			for (const int substeps : { 1, 2, 4 }) {
				for (const int iterations : { 1, 2, 4 }) {
					if (is_quick && (substeps == 4 || iterations == 4 || step != step_lanes)) {
						continue;
					}
					const Config config{ method, step, substeps, iterations };
					const double ms = time_frame(config);
					double kept = 0.0;
					const double frequency = frequency_error(config, kept);
					const std::pair<const char *, double> errors[] = { { "static_1", static_error(config, 1.0) },
						{ "static_5", static_error(config, 5.0) }, { "frequency", frequency },
						{ "amplitude_lost", std::max(1.0 - kept, 0.0) },
						{ "transient", difference(transient(config), transient_reference) },
						{ "sphere_sweep", difference(sphere_sweep(config), sweep_reference) } };
					for (const auto &[name, value] : errors) {
						std::printf("%s,%s,%d,%d,%d,%.3f,%s,%.6g\n", method == Method::DIRECT ? "DIRECT" : "PBD",
								step == step_lanes ? "CPU float" : "CPU double", GRASS_KNOTS, substeps, iterations, ms, name, value);
					}
					std::fflush(stdout);
				}
			}
		}
	}
}

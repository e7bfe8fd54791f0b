// SPDX-License-Identifier: MIT
// Plays the problems of `./grass bench rods` with GRASS_KNOTS knots: a straight blade under an even load across it, and its release
// without damping. Standard input: the load that it is let go from, seconds, then the angles of the rod that the load holds, at even
// places from root to tip, radians. Standard output, a line each: what solved it, elements, steps a second, microseconds a step and
// blade, problem, load, then the tip's ways along the rod and with the load, lengths, of each frame.
#include "problem.h"
#include "references.h"

#include <cstdio>
#include <iostream>
#if GRASS_KNOTS == 16
#include "strain_scene.h"
#endif

using namespace grass;
using namespace grass::test;

namespace {

constexpr double SAGS[] = { 1.0, 5.0 };
constexpr double SAG_SECONDS = 5.0; // until it hangs still

// A row of places, named by what made them.
void print_row(const char *p_name, int p_substeps, double p_ms, const char *p_problem, double p_load, const Track &p_tips) {
	std::printf("%s,%d,%d,%.4g,%s,%g", p_name, GRASS_SEGMENTS, 60 * p_substeps, p_ms * 1000.0 / 65536.0 / p_substeps, p_problem, p_load);
	for (const Eigen::Vector3f &tip : p_tips) {
		std::printf(",%.7g,%.7g", double(tip.y()), double(tip.x()));
	}
	std::printf("\n");
}

Eigen::Vector3f tip_of(const BladeScene &p_scene) {
	return p_scene.knot(0, GRASS_KNOTS - 1) / p_scene.length;
}

struct Release {
	double load = 0.0, seconds = 0.0;
	std::vector<double> angles;

	// At a share of the length.
	double angle_at(double p_share) const {
		const double place = std::clamp(p_share, 0.0, 1.0) * double(angles.size() - 1);
		const size_t from = std::min(size_t(place), angles.size() - 2);
		return angles[from] + (angles[from + 1] - angles[from]) * (place - double(from));
	}
};

Release read_release() {
	Release release;
	std::cin >> release.load >> release.seconds;
	for (double angle; std::cin >> angle;) {
		release.angles.push_back(angle);
	}
	if (release.angles.size() < 2) {
		throw std::runtime_error("standard input holds no load, seconds and angles: `./grass bench rods` gives them");
	}
	return release;
}

// Stands blade 0 as the load holds it, each segment as steep as the rod in its middle. The clamp stays upright.
void bend_as_held(BladeScene &r_scene, const Release &p_release) {
	double passed = 0.0;
	Eigen::Vector3f place = r_scene.rest(0, 0);
	for (int k = 1; k < GRASS_KNOTS; k++) {
		const float length = (r_scene.rest(0, k) - r_scene.rest(0, k - 1)).norm();
		const double middle = (passed + 0.5 * double(length)) / double(r_scene.length);
		const float angle = k < GRASS_CLAMPED_KNOTS ? 0.0f : float(p_release.angle_at(middle));
		place += length * Eigen::Vector3f(sin_of(angle), cos_of(angle), 0.0f);
		r_scene.set_knot(0, k, place);
		passed += double(length);
	}
}

// Returns every frame's tip. p_step(seconds) takes a step.
template <class StepOnce> Track follow(const BladeScene &p_scene, double p_seconds, int p_substeps, const StepOnce &p_step) {
	Track tips;
	for (int frame = 0; frame < int(std::lround(p_seconds / FRAME)); frame++) {
		for (int i = 0; i < p_substeps; i++) {
			p_step(FRAME / p_substeps);
		}
		tips.push_back(tip_of(p_scene));
	}
	return tips;
}

void play_chain(const Config &p_config, const Release &p_release) {
	const char *name = p_config.method == Method::DIRECT ? "chain" : "PBD";
	BladeScene swinging = make_scene(p_config, Keep::TIME, 1, 0.05);
	swinging.bend(1.0f);
	const double ms = frame_time(swinging, p_config);
	for (const double load : SAGS) {
		BladeScene scene = make_scene(p_config, Keep::TIP, 1, 1.0);
		scene.params.load[0] = load_of_gamma(load, scene.params.natural_frequency, double(scene.length));
		scene.step_for(SAG_SECONDS, p_config.substeps / FRAME);
		print_row(name, p_config.substeps, ms, "sag", load, { tip_of(scene) });
	}
	BladeScene scene = make_scene(p_config, Keep::TIP, 1, 0.0);
	bend_as_held(scene, p_release);
	const auto step = [&](double p_delta) { scene.step(p_delta); };
	print_row(name, p_config.substeps, ms, "release", p_release.load, follow(scene, p_release.seconds, p_config.substeps, step));
}

#if GRASS_KNOTS == 16
// By its strains a blade is not bent as one likes: it is let go from where its own load holds it.
void play_strains(int p_substeps, const Release &p_release) {
	const auto made = [] {
		StrainScene scene = StrainScene::straight();
		scene.params().taper = 0.0;
		scene.params().width_to_thickness = 1.0;
		scene.params().natural_frequency = 1.2;
		return scene;
	};
	StrainScene swinging = made();
	swinging.params().damping_ratio = 0.05;
	swinging.hold(1.0, Eigen::Vector3d::UnitX());
	const double ms = frame_time(swinging.blades, { Method::DIRECT, step_lanes, p_substeps, 1 });
	for (const double load : SAGS) {
		StrainScene scene = made();
		scene.params().damping_ratio = 1.0;
		scene.params().load[0] = load_of_gamma(load, scene.params().natural_frequency, double(scene.blades.length));
		scene.step_for(SAG_SECONDS, p_substeps / FRAME);
		print_row("strains", p_substeps, ms, "sag", load, { tip_of(scene.blades) });
	}
	StrainScene scene = made();
	scene.params().damping_ratio = 0.0;
	scene.hold(p_release.load, Eigen::Vector3d::UnitX());
	const auto step = [&](double p_delta) { scene.step(p_delta); };
	print_row("strains", p_substeps, ms, "release", p_release.load, follow(scene.blades, p_release.seconds, p_substeps, step));
}
#endif

} // namespace

int main() {
	try {
		const Release release = read_release();
		for (const int substeps : { 1, 2, 4 }) {
			for (const Method method : { Method::DIRECT, Method::PBD }) {
				play_chain({ method, step_lanes, substeps, 2 }, release);
			}
#if GRASS_KNOTS == 16
			play_strains(substeps, release);
#endif
		}
	} catch (const std::runtime_error &error) {
		std::fprintf(stderr, "%s\n", error.what());
		return 1;
	}
}

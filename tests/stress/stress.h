// SPDX-License-Identifier: MIT
// What the stress tests have in common: size, threads, random numbers, storms of bodies.
#pragma once

#include "blade_scene.h"

#include <functional>
#include <random>
#include <string>
#include <vector>

namespace grass::test {

inline constexpr Method METHODS[] = { Method::DIRECT, Method::PBD };

// Error of a segment's length that always holds, as a share of it.
inline constexpr float MOST_STRETCH = 1e-3f;
// What counts as back at rest, blade lengths.
inline constexpr float AT_REST = 0.01f;

const char *name_of(Method p_method);

// p_full if the environment has GRASS_STRESS=full (`./grass bench stress`), else p_usual, or less of it under a sanitizer.
int sized(int p_usual, int p_full);

// Calls p_body(i) for every i below p_count, on all cores; with GRASS_STRESS_PART=2/10 in the environment for the second tenth of them,
// so that a long test can be run in pieces (`-tc="*random parameters*"` chooses one). It returns what went wrong, "" if nothing; every
// failure is a failed check, with its number, so that it can be repeated.
void check_each(int p_count, const std::function<std::string(int)> &p_body);

// Random numbers that follow from a seed.
class Dice {
public:
	explicit Dice(uint32_t p_seed) : _engine(p_seed) {}
	double uniform(double p_low, double p_high) { return std::uniform_real_distribution<double>(p_low, p_high)(_engine); }
	// As likely between 0.001 and 0.01 as between 1 and 10.
	double magnitude(double p_low, double p_high) { return std::exp(uniform(std::log(p_low), std::log(p_high))); }
	double within(const Tunable &p_tunable) { return uniform(p_tunable.minimum, p_tunable.maximum); }
	int below(int p_count) { return int(_engine() % uint32_t(p_count)); }
	Eigen::Vector3f direction();
	// From the whole range of every parameter, now and then from its ends; with a load of up to 2 g.
	SolverParams params(Method p_method);
	// Of a frame, seconds: 0, a hitch of half a second, anything up to a second, or usual.
	double delta();

private:
	std::mt19937 _engine;
};

// Bodies of all shapes that fly and spin through a box around the blades. Who leaves it is teleported.
class Storm {
public:
	// Sizes in metres, p_speed the highest, m/s.
	Storm(BladeScene &r_scene, Dice &r_dice, int p_count, double p_smallest, double p_largest, double p_speed);
	void move(double p_delta);

private:
	struct Body {
		Eigen::Vector3f centre, velocity, axis;
		float angle, spin; // radians, radians per second
	};
	void write(GrassCollider &r_collider, const Body &p_before, const Body &p_now) const;

	BladeScene &_scene;
	std::vector<Body> _bodies;
};

// Returns what is wrong with a scene after a step; "" if nothing.
std::string look_at(const BladeScene &p_scene);
// Takes all bodies and loads away; what is wrong p_seconds later, with the default parameters: blades not back at rest.
std::string calm_down(BladeScene &r_scene, double p_seconds = 4.0);

} // namespace grass::test

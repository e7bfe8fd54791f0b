// SPDX-License-Identifier: MIT
// How many floating-point operations a blade's step takes: the solver over numbers that count what is done with them. With it,
// lab/results knows the least time that a GPU of a given peak needs. Sums, products, quotients, roots and comparisons count one each. A
// card's peak counts two for a product and a sum fused into one instruction. So there are two floors: that of its peak, as if all could be
// fused, and that of its instructions, where only a sum or difference of a product is.
#include "blade_scene.h"
#include "core/solver/step_tile.h"

#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace grass {

// A float that counts.
struct Counted {
	static inline long operations = 0;
	static inline long fused = 0; // of them, sums that may take a product along: at least as many as a GPU can fuse
	float value = 0.0f;
	bool is_product = false;

	Counted() = default;
	explicit Counted(float p_value) : value(p_value) {}

	static Counted made(float p_value) {
		operations++;
		return Counted(p_value);
	}
	static bool compared(bool p_result) {
		operations++;
		return p_result;
	}
	Counted sum(float p_value, const Counted &p_b) const {
		fused += is_product || p_b.is_product ? 1 : 0;
		return made(p_value);
	}
	Counted operator-() const { // part of the next operation, on a GPU
		Counted negative(-value);
		negative.is_product = is_product;
		return negative;
	}
	Counted operator+(const Counted &p_b) const { return sum(value + p_b.value, p_b); }
	Counted operator-(const Counted &p_b) const { return sum(value - p_b.value, p_b); }
	Counted operator*(const Counted &p_b) const {
		Counted product = made(value * p_b.value);
		product.is_product = true;
		return product;
	}
	Counted operator/(const Counted &p_b) const { return made(value / p_b.value); }
	bool operator<(const Counted &p_b) const { return compared(value < p_b.value); }
	bool operator>(const Counted &p_b) const { return compared(value > p_b.value); }
	bool operator<=(const Counted &p_b) const { return compared(value <= p_b.value); }
	bool operator>=(const Counted &p_b) const { return compared(value >= p_b.value); }
	bool operator==(const Counted &p_b) const { return compared(value == p_b.value); }
	bool operator!=(const Counted &p_b) const { return compared(value != p_b.value); }
};

Counted select(bool p_mask, const Counted &p_a, const Counted &p_b) {
	return p_mask ? p_a : p_b;
}
Counted square_root(const Counted &p_a) {
	return Counted::made(std::sqrt(p_a.value));
}
void store(const Counted &p_value, float *r_to) {
	*r_to = p_value.value;
}
float largest(const Counted &p_value) {
	return p_value.value;
}

float step_counted(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_tile<Counted>(r_state, p_steps, p_blend, p_colliders);
}

} // namespace grass

using namespace grass;
using namespace grass::test;

namespace {

constexpr double BYTES_DIRECT = 748.0, BYTES_PBD = 632.0; // that a blade's step must move: bench_kernel.gd
constexpr int STEPS = 48;

// The scenes `0` and `4` of bench_kernel.gd: blades over a tile that swing, alone or among balls that go to and fro by 1 cm a step.
BladeScene play(Method p_method, int p_balls, Step p_step) {
	BladeScene scene(p_method);
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		scene.tile->root[0][b] = 0.0625f * (float(b % 8) - 3.5f);
		scene.tile->root[2][b] = 0.0625f * (float(b / 8) - 3.5f);
	}
	const auto place = [](int p_ball, int p_phase) {
		const float x = (p_ball & 1 ? 0.125f : -0.125f) + 0.01f * float(std::abs(p_phase % 8 - 4));
		return Eigen::Vector3f(x, 0.2f, p_ball & 2 ? 0.125f : -0.125f);
	};
	for (int i = 0; i < p_balls; i++) {
		scene.add(GRASS_SPHERE, place(i, 0), { 0.08f, 0.0f, 0.0f });
	}
	scene.bend(1.0f);
	const auto run = [&](int p_steps) {
		for (int step = 0; step < p_steps; step++) {
			for (int i = 0; i < p_balls; i++) {
				BladeScene::place(scene.colliders[i], place(i, step + 7), place(i, step + 8));
			}
			scene.step();
		}
	};
	run(STEPS / 2); // until all of them have met
	scene.step_function = p_step;
	Counted::operations = Counted::fused = 0;
	run(STEPS);
	return scene;
}

// Of a blade's step.
struct Count {
	double operations, instructions;
};
Count count(Method p_method, int p_balls) {
	const BladeScene plain = play(p_method, p_balls, step_scalar_float);
	const BladeScene counted = play(p_method, p_balls, step_counted);
	if (std::memcmp(plain.tile->knots, counted.tile->knots, sizeof(plain.tile->knots)) != 0) {
		throw std::logic_error("numbers that count do not move blades as plain ones do");
	}
	const double steps = STEPS * GRASS_BLADES_PER_TILE;
	return { double(Counted::operations) / steps, double(Counted::operations - Counted::fused) / steps };
}

} // namespace

// A table: of a blade's step, with the bytes that it has to move.
int main() {
	std::printf("method,scene,operations,instructions,bytes\n");
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		for (const int balls : { 0, 4 }) {
			const Count counted = count(method, balls);
			std::printf("%s,%s,%.0f,%.0f,%.0f\n", method == Method::DIRECT ? "DIRECT" : "PBD", balls == 0 ? "free" : "balls",
					counted.operations, counted.instructions, method == Method::DIRECT ? BYTES_DIRECT : BYTES_PBD);
		}
	}
}

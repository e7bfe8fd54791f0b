// SPDX-License-Identifier: MIT
// Numbers too small for a float's full precision: as if they were 0.
#include "stress.h"

#include <doctest/doctest.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

using namespace grass;
using namespace grass::test;

namespace {

constexpr float DENORMAL = 1e-41f;

// The processor takes denormals for 0 while this lives. Where it cannot, nothing changes.
class Flushed {
public:
	explicit Flushed(bool p_is_on) {
#if defined(__SSE2__)
		_before = _mm_getcsr();
		_mm_setcsr(p_is_on ? _before | 0x8040 : _before); // results and operands
#else
		(void)p_is_on;
#endif
	}
	~Flushed() {
#if defined(__SSE2__)
		_mm_setcsr(_before);
#endif
	}

private:
	unsigned _before = 0;
};

// Half the blades are away from rest by denormals only, the others bent; a body of denormal size among them.
void play(BladeScene &r_scene, bool p_is_flushed) {
	const Flushed flushed(p_is_flushed);
	r_scene.bend(1.0f);
	for (int b = 0; b < GRASS_BLADES_PER_TILE / 2; b++) {
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			r_scene.set_knot(b, k, r_scene.rest(b, k));
			r_scene.tile->knots[2][k - GRASS_CLAMPED_KNOTS][b] += DENORMAL * float(k);
			r_scene.tile->twist[k - GRASS_CLAMPED_KNOTS][b] = DENORMAL;
		}
	}
	// Beside the plane in which blades are bent: a point in it would leave to denormals to which side they go.
	r_scene.add(GRASS_SPHERE, { DENORMAL, 0.2f, 0.003f }, { DENORMAL, DENORMAL, DENORMAL });
	r_scene.step_for(4.0);
}

} // namespace

TEST_CASE("stress: denormals do what zeros do") {
	for (const Method method : METHODS) {
		INFO(name_of(method));
		BladeScene scene, flushed;
		scene.params.method = flushed.params.method = method;
		play(scene, false);
		play(flushed, true);
		CHECK(look_at(scene) == "");
		CHECK(scene.distance_from(flushed) < 1e-6f);
		CHECK(calm_down(scene) == ""); // without the body: an edge is held even by a point
	}
}

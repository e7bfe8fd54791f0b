// SPDX-License-Identifier: MIT
// A crate that slides over the ground: what its upright edges and the ground close in.
#include <doctest/doctest.h>

#include "blade_scene.h"

#include "core/base/half.h"
#include "core/blades/patch.h"

using namespace grass;
using namespace grass::test;

namespace {

// Returns blades of the patch, all over a tile.
BladeScene make_tile(const Patch &p_patch, int p_first) {
	BladeScene scene;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const auto texel = [&](int p_knot) {
			const uint16_t *halves = &p_patch.texels[Patch::texel_index(p_first + b, p_knot)];
			return Eigen::Vector3f(half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]));
		};
		scene.tile->root[0][b] = (texel(0).x() - 0.5f) * 0.5f;
		scene.tile->root[2][b] = (texel(0).y() - 0.5f) * 0.5f;
		for (int k = 0; k < GRASS_KNOTS; k++) {
			scene.set_rest(b, k, k > 0 ? texel(k) : Eigen::Vector3f::Zero());
		}
	}
	return scene;
}

} // namespace

TEST_CASE("METHOD_DIRECT: no segment stays in a crate that slides on the ground, beside its upright edges neither") {
	constexpr float HALF = 0.2f, WAY = 1.6f; // metres
	struct Slide {
		float speed, rate; // m/s, steps a second
		int iterations;
	};
	const Patch patch = generate_patch(PatchParams());
	for (const Slide &slide : { Slide{ 2.0f, 60.0f, 2 }, Slide{ 2.0f, 60.0f, 4 }, Slide{ 2.0f, 144.0f, 2 }, Slide{ 1.0f, 144.0f, 2 } }) {
		CAPTURE(slide.speed);
		CAPTURE(slide.rate);
		float deepest = 0.0f;
		for (int tile = 8; tile < 16; tile++) { // of 32: wedged blades are rare, and these have some
			BladeScene scene = make_tile(patch, tile * 509);
			scene.params.iterations = slide.iterations;
			scene.add(GRASS_BOX, { 0.0f, HALF, 0.0f }, { HALF, HALF, HALF });
			const float stride = slide.speed / slide.rate;
			for (int i = 0; i < int(WAY / stride); i++) {
				const float x = -0.5f * WAY + stride * float(i);
				BladeScene::place(scene.colliders[0], { x, HALF, 0.03f }, { x + stride, HALF, 0.03f });
				scene.step(1.0 / double(slide.rate));
				deepest = std::max(deepest, scene.edge_depth());
			}
		}
		CHECK(deepest < 1e-4f);
		MESSAGE(slide.speed << " m/s, " << slide.rate << " steps a second: " << deepest << " m");
	}
}

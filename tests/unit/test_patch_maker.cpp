// SPDX-License-Identifier: MIT
// A patch that is made on a thread of its own.
#include "core/blades/patch_maker.h"

#include <doctest/doctest.h>

using namespace grass;

TEST_CASE("patch maker: what is made aside is what is made here, also after something else was begun") {
	PatchParams params, other;
	params.seed = 3;
	other.length_max = 0.4;
	PatchMaker maker;
	CHECK_FALSE(maker.is_started());
	CHECK_FALSE(maker.is_done());
	maker.start(other);
	CHECK(maker.is_started());
	maker.start(params); // the other one is given up
	CHECK(maker.take()->texels == generate_patch(params).texels);
	CHECK_FALSE(maker.is_started());
	maker.start(other);
	CHECK(maker.take()->texels == generate_patch(other).texels);
}

TEST_CASE("patch maker: what is given up, again and again, leaves nothing") {
	PatchMaker maker;
	for (int i = 0; i < 200; i++) {
		PatchParams params;
		params.seed = uint32_t(i);
		maker.start(params);
		if (i % 3 == 0) {
			maker.stop();
			CHECK_FALSE(maker.is_started());
		}
		PatchMaker short_lived;
		short_lived.start(params);
	}
	CHECK(maker.take()->texels ==
			generate_patch([] {
				PatchParams params;
				params.seed = 199;
				return params;
			}())
					.texels);
}

TEST_CASE("patch maker: a stop before the beginning makes no blade") {
	const std::atomic<bool> stop = true;
	const Patch patch = generate_patch({}, &stop);
	CHECK(patch.max_length == 0.0f);
}

// SPDX-License-Identifier: MIT
// The scenes for libFuzzer, which chooses the bytes by the code that they reach: SCons target `fuzz`, with clang only.
#include "fuzz_scene.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *p_data, size_t p_size) {
	const std::string failure = grass::test::play_bytes({ p_data, p_size });
	if (!failure.empty()) {
		std::fprintf(stderr, "%s\n", failure.c_str());
		std::abort();
	}
	return 0;
}

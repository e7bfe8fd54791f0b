// SPDX-License-Identifier: MIT
#include "compute_shaders.gen.h"
#include "core/base/bytes.h"
#include "core/base/packed_pass.h"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using namespace grass;

TEST_CASE("packed_pass: each pass is unpacked to the words that the shader compiler wrote") {
	for (const SpirvCode &code : shader::ALL_SPIRV) {
		const std::vector<uint32_t> words = unpack_pass(code);
		REQUIRE(!words.empty());
		CHECK(words[0] == 0x07230203u);
		CHECK(checksum({ reinterpret_cast<const uint8_t *>(words.data()), 4 * words.size() }) == code.sum);
		CHECK(code.size() < 2 * words.size()); // half of their bytes; more than a third on the day of this number
	}
}

TEST_CASE("packed_pass: of damaged bytes no more is read than there is") {
	std::mt19937 random(5);
	const SpirvCode &whole = shader::GATHER_SPIRV;
	for (int round = 0; round < 2000; round++) {
		std::vector<uint8_t> bytes(whole.begin(), whole.end());
		if (round % 2) {
			bytes.resize(random() % bytes.size());
			CHECK(unpack_pass(bytes).empty());
		} else {
			bytes[random() % bytes.size()] ^= uint8_t(1u << random() % 8);
			CHECK(unpack_pass(bytes).size() <= 1u << 20);
		}
	}
}

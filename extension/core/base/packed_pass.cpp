// SPDX-License-Identifier: MIT
#include "core/base/packed_pass.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>

namespace grass {

namespace {

constexpr size_t PACKED_HEADER = 5; // words before the first operation
constexpr size_t PACKED_PLACES = 7; // words of an operation that have guesses of their own; those behind share the last one's
constexpr size_t PACKED_MOST = 1 << 20; // words of a pass; the largest has 80,000

struct PackedReader {
	std::span<const uint8_t> bytes;
	size_t at = 0;
	bool is_past_end = false;

	uint32_t number() {
		uint32_t value = 0;
		for (unsigned shift = 0; shift < 35; shift += 7) {
			is_past_end = is_past_end || at >= bytes.size();
			const uint8_t byte = is_past_end ? 0 : bytes[at++];
			value |= shift < 32 ? uint32_t(byte & 127) << shift : 0;
			if (byte < 128) {
				break;
			}
		}
		return value;
	}
	// Returns a difference of words, of which the packer wrote twice the amount, less one if it is below 0.
	uint32_t difference() {
		const uint32_t folded = number();
		return (folded >> 1) ^ (0u - (folded & 1));
	}
};

// What is known of a kind of operation.
struct PackedOperation {
	uint32_t guesses = 0;
	std::array<uint32_t, PACKED_PLACES> last{}; // words of the one before
};

} // namespace

std::vector<uint32_t> unpack_pass(std::span<const uint8_t> p_packed) {
	PackedReader reader{ p_packed };
	const size_t count = reader.number();
	if (count < PACKED_HEADER || count > PACKED_MOST) {
		return {};
	}
	std::vector<uint32_t> words(count);
	std::generate_n(words.begin(), PACKED_HEADER, [&] { return reader.number(); });
	std::map<uint32_t, PackedOperation> operations;
	for (uint32_t left = reader.number(); left > 0 && !reader.is_past_end; left--) {
		const uint32_t operation = reader.number();
		operations[operation].guesses = reader.number();
	}
	uint32_t result = 0; // of the operation before
	for (size_t at = PACKED_HEADER; at < count;) {
		const uint32_t operation = reader.number(), length = reader.number();
		if (reader.is_past_end || length == 0 || length > count - at) {
			return {};
		}
		PackedOperation &known = operations[operation];
		words[at] = length << 16 | operation;
		for (size_t i = 1; i < length; i++) {
			const size_t place = std::min(i, PACKED_PLACES) - 1;
			const uint32_t guesses[] = { 0, result, known.last[place], i > 2 ? words[at + 2] : result };
			words[at + i] = known.last[place] = guesses[known.guesses >> (2 * place) & 3] + reader.difference();
		}
		result = length > 2 ? words[at + 2] : result;
		at += length;
	}
	return reader.is_past_end ? std::vector<uint32_t>() : words;
}

} // namespace grass

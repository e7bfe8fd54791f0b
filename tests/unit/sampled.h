// SPDX-License-Identifier: MIT
// A sample of what a test would try, where each instruction is emulated, some forty times slower: the layer `arm64` sets GRASS_EMULATED,
// and shows with tests/bits that random scenes step to the same bits there as here. Everywhere else all is tried.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <vector>

namespace grass::test {

inline bool is_emulated() {
	return std::getenv("GRASS_EMULATED") != nullptr;
}
// A tenth of so many.
inline int sampled(int p_count) {
	return is_emulated() ? (p_count + 9) / 10 : p_count;
}
// The first of these.
template <class Value, size_t Count> std::vector<Value> sampled(const Value (&p_values)[Count], size_t p_first = 1) {
	return { p_values, p_values + (is_emulated() && p_first < Count ? p_first : Count) };
}

} // namespace grass::test

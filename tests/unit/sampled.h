// SPDX-License-Identifier: MIT
// A sample of what a test would try, where each instruction takes some forty times as long. The layer `arm64`, which emulates them, sets
// GRASS_EMULATED, and shows with tests/bits that random scenes step to the same bits there as here. A sanitizer looks at what is read and
// written, not at figures; dev=yes, which is as slow, samples too. Everywhere else all is tried.
#pragma once

#include "core/base/lanes.h" // GRASS_IS_SANITIZED

#include <cstddef>
#include <cstdlib>
#include <vector>

namespace grass::test {

inline bool is_slow() {
#if defined(GRASS_IS_SANITIZED)
	return true;
#else
	return std::getenv("GRASS_EMULATED") != nullptr;
#endif
}
// Returns a tenth of so many.
inline int sampled(int p_count) {
	return is_slow() ? (p_count + 9) / 10 : p_count;
}
// Returns the first of these.
template <class Value, size_t Count> std::vector<Value> sampled(const Value (&p_values)[Count], size_t p_first = 1) {
	return { p_values, p_values + (is_slow() && p_first < Count ? p_first : Count) };
}

} // namespace grass::test

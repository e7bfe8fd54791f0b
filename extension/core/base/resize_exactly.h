// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace grass {

// Changes the number of elements, and the memory with it. std::vector::shrink_to_fit() does nothing in a library without exceptions.
template <class T> void resize_exactly(std::vector<T> &r_vector, size_t p_size) {
	std::vector<T> resized(p_size);
	std::move(r_vector.begin(), r_vector.begin() + std::ptrdiff_t(std::min(p_size, r_vector.size())), resized.begin());
	r_vector.swap(resized);
}

} // namespace grass

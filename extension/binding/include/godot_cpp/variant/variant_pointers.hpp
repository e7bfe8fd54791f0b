// SPDX-License-Identifier: MIT
// Arguments as the engine's variadic functions want them: an array of pointers to Variants.
#pragma once

#include <cstddef>

namespace godot {

class Variant;

namespace internal {

const Variant *variant_at(const Variant *p_values, size_t p_index);

// T, but only known once the other types are.
template <typename T, typename...> struct Later { using Type = T; };

template <size_t COUNT> struct VariantPointers {
	const Variant *pointers[COUNT + 1] = {};

	explicit VariantPointers(const Variant *p_values) {
		for (size_t i = 0; i < COUNT; i++) {
			pointers[i] = variant_at(p_values, i);
		}
	}
};

} // namespace internal

} // namespace godot

// SPDX-License-Identifier: MIT
// Variants found by Variants, in the order of insertion, shared by reference.
#pragma once

#include <godot_cpp/variant/array.hpp>

namespace godot {

class Dictionary : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_DICTIONARY, 1> {
public:
	Dictionary() = default;

	// Inserts what is not there; the const one gives null then.
	Variant &operator[](const Variant &p_key);
	const Variant &operator[](const Variant &p_key) const;

#include <godot_cpp/variant/gen/dictionary.inc>
};

} // namespace godot

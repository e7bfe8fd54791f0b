// SPDX-License-Identifier: MIT
// Something to call: a method of an object, or code of ours (callable_mp).
#pragma once

#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/variant_pointers.hpp>

namespace godot {

class Callable : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_CALLABLE, 16 / sizeof(void *)> {
public:
	Callable() = default;
	Callable(Object *p_object, const StringName &p_method);

#include <godot_cpp/variant/gen/callable.inc>
};

} // namespace godot

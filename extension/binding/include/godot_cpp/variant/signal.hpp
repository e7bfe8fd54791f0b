// SPDX-License-Identifier: MIT
// One signal of one object.
#pragma once

#include <godot_cpp/variant/callable.hpp>

namespace godot {

class Signal : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_SIGNAL, 16 / sizeof(void *)> {
public:
	Signal() = default;
	Signal(Object *p_object, const StringName &p_signal);

#include <godot_cpp/variant/gen/signal.inc>
};

} // namespace godot

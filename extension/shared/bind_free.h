// SPDX-License-Identifier: MIT
// Binds functions outside of a class as its methods: those that need only public members of the class.
#pragma once

#include <godot_cpp/core/class_db.hpp>

namespace grass {

// The base of such a class. The engine binds only methods of the class itself, so each bound function gets one of these.
template <typename Class> class CallsFree {
public:
	template <auto FUNCTION, typename R, typename... A> R call_free(A... p_arguments) {
		return FUNCTION(static_cast<Class &>(*this), p_arguments...);
	}
	template <auto FUNCTION, typename R, typename... A> R call_free(A... p_arguments) const {
		return FUNCTION(static_cast<const Class &>(*this), p_arguments...);
	}
};

// The method that the class gets for a function of type F.
template <auto FUNCTION, typename F = decltype(FUNCTION)> struct FreeCall;
template <auto FUNCTION, typename Class, typename R, typename... A> struct FreeCall<FUNCTION, R (*)(Class &, A...)> {
	static constexpr R (Class::*METHOD)(A...) = &CallsFree<Class>::template call_free<FUNCTION, R, A...>;
};
template <auto FUNCTION, typename Class, typename R, typename... A> struct FreeCall<FUNCTION, R (*)(const Class &, A...)> {
	static constexpr R (Class::*METHOD)(A...) const = &CallsFree<Class>::template call_free<FUNCTION, R, A...>;
};

// Binds a function. p_definition: without the object, which is the function's first argument. p_defaults: of the last arguments.
template <auto FUNCTION, typename... Defaults> void bind_free(const godot::MethodDefinition &p_definition, const Defaults &...p_defaults) {
	godot::ClassDB::bind_method(p_definition, FreeCall<FUNCTION>::METHOD, p_defaults...);
}

} // namespace grass

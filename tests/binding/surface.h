// SPDX-License-Identifier: MIT
// What of godot-cpp the extension may use, stated one member at a time. It compiles against the binding, which must
// offer exactly this (check_surface.py finds what is stated nowhere), and against godot-cpp, which must offer it too.
#pragma once

#include <type_traits>
#include <utility>

namespace surface {

template <typename T, typename... A> inline constexpr bool is_made_implicitly = requires(void (*p_take)(T), A &&...p_arguments) {
	p_take({ std::forward<A>(p_arguments)... });
};

} // namespace surface

// A method, one that is static, a free function: the very parameters, constness and result. Other overloads may stand beside it.
#define METHOD(m_class, m_name, ...)                                                                                                       \
	static_assert(std::is_same_v<decltype(static_cast<std::type_identity_t<__VA_ARGS__> m_class::*>(&m_class::m_name)),                    \
			std::type_identity_t<__VA_ARGS__> m_class::*>);
#define STATIC(m_class, m_name, ...) FUNCTION(m_class::m_name, __VA_ARGS__)
#define FUNCTION(m_name, ...)                                                                                                              \
	static_assert(std::is_same_v<decltype(static_cast<std::type_identity_t<__VA_ARGS__> *>(&m_name)), std::type_identity_t<__VA_ARGS__> *>);
// The class, then the parameters.
#define CONSTRUCTOR(...) static_assert(surface::is_made_implicitly<__VA_ARGS__>);
#define EXPLICIT_CONSTRUCTOR(...) static_assert(std::is_constructible_v<__VA_ARGS__>);
#define FIELD(m_class, m_name, ...) static_assert(std::is_same_v<decltype(m_class::m_name), std::type_identity_t<__VA_ARGS__>>);
#define CONSTANT(m_name, ...) static_assert(std::is_same_v<decltype(m_name), std::type_identity_t<__VA_ARGS__>>);
#define VALUE(m_name, m_value) static_assert(int64_t(m_name) == m_value);
#define TYPE(m_name, ...) static_assert(std::is_same_v<m_name, std::type_identity_t<__VA_ARGS__>>);
// A template, by what a use of it gives: CALL(the class, the name, the result, the use).
#define CALL(m_class, m_name, m_result, ...) static_assert(std::is_same_v<decltype(__VA_ARGS__), std::type_identity_t<m_result>>);
// The same where upstream gives something and the binding nothing: only the use is stated.
#define USE(m_class, m_name, ...) using m_class##_##m_name = decltype(__VA_ARGS__);

template <typename T> T &a(); // some object, for CALL and USE

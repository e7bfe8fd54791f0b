// SPDX-License-Identifier: MIT
// Words that every header of the binding uses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#if defined(_WIN32)
#define GDE_EXPORT __declspec(dllexport)
#else
#define GDE_EXPORT __attribute__((visibility("default")))
#endif

#if defined(__GNUC__)
#define likely(m_condition) __builtin_expect(!!(m_condition), 1)
#define unlikely(m_condition) __builtin_expect(!!(m_condition), 0)
#define _ALWAYS_INLINE_ __attribute__((always_inline)) inline
#define _NO_INLINE_ __attribute__((noinline))
#else
#define likely(m_condition) (m_condition)
#define unlikely(m_condition) (m_condition)
#define _ALWAYS_INLINE_ inline
#define _NO_INLINE_
#endif

namespace godot {

namespace internal {

#ifdef REAL_T_IS_DOUBLE // the engine is built with `precision=double`
inline constexpr bool IS_DOUBLE = true;
#else
inline constexpr bool IS_DOUBLE = false;
#endif

} // namespace internal

using real_t = std::conditional_t<internal::IS_DOUBLE, double, float>;

template <typename A, typename B> constexpr auto MIN(const A p_a, const B p_b) {
	return p_a < p_b ? p_a : p_b;
}

template <typename A, typename B> constexpr auto MAX(const A p_a, const B p_b) {
	return p_a > p_b ? p_a : p_b;
}

template <typename T, typename A, typename B> constexpr auto CLAMP(const T p_value, const A p_min, const B p_max) {
	return p_value < p_min ? p_min : (p_value > p_max ? p_max : p_value);
}

template <typename T> constexpr T SIGN(const T p_value) {
	return p_value > 0 ? T(1) : (p_value < 0 ? T(-1) : T(0));
}

} // namespace godot

using godot::real_t;

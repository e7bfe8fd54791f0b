// SPDX-License-Identifier: MIT
// Numbers that one blade step may be written over: float, double, or Lanes, which holds the same number of eight
// blades side by side. A comparison gives a mask (bool, or one per lane); select() takes the place of `if`.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

// The step is one function to the compiler, so that it keeps vectors in registers and a caller compiled for a
// newer instruction set takes all of it along. Sanitizers would make that one function too long to compile.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GRASS_INLINE inline
#else
#define GRASS_INLINE inline __attribute__((always_inline))
#define GRASS_IS_ONE_FUNCTION 1
#endif
// For a lambda that apart() runs.
#define GRASS_APART __attribute__((always_inline))

namespace grass {

#if defined(__x86_64__) && defined(GRASS_IS_ONE_FUNCTION)
#define GRASS_HAS_WIDE 1
// The same arithmetic, bit for bit, in half as many instructions.
#define GRASS_WIDE __attribute__((target("avx2")))
inline bool is_wide() {
	static const bool has_avx2 = __builtin_cpu_supports("avx2");
	return has_avx2;
}
#endif

template <class Body> __attribute__((noinline)) auto run_apart(const Body &p_body) {
	return p_body();
}
#if defined(GRASS_HAS_WIDE)
template <class Body> __attribute__((noinline)) GRASS_WIDE auto run_apart_wide(const Body &p_body) {
	return p_body();
}
#endif

// Runs p_body in a function of its own: what few blades need would push the others' vectors out of their registers, and take minutes to
// compile in one function with the rest. It returns no single vector, which the two instruction sets would pass in different ways.
template <class Body> GRASS_INLINE auto apart(const Body &p_body) {
#if defined(GRASS_HAS_WIDE)
	return is_wide() ? run_apart_wide(p_body) : run_apart(p_body);
#else
	return run_apart(p_body);
#endif
}

// True or false for each of eight lanes: all bits set or none.
struct LaneMask {
	typedef int32_t Bits __attribute__((vector_size(32)));
	Bits bits;
};

GRASS_INLINE LaneMask operator&(const LaneMask &p_a, const LaneMask &p_b) {
	return { p_a.bits & p_b.bits };
}
GRASS_INLINE LaneMask operator|(const LaneMask &p_a, const LaneMask &p_b) {
	return { p_a.bits | p_b.bits };
}
GRASS_INLINE LaneMask operator!(const LaneMask &p_a) {
	return { ~p_a.bits };
}

// Eight floats. Arithmetic is lane by lane and rounds as a plain float does.
struct Lanes {
	static constexpr int COUNT = 8;
	typedef float Values __attribute__((vector_size(32)));
	Values values;

	GRASS_INLINE Lanes() : values{} {}
	GRASS_INLINE Lanes(float p_value) : values(Values{} + p_value) {}
	GRASS_INLINE explicit Lanes(const Values &p_values) : values(p_values) {}
	GRASS_INLINE float operator[](int p_lane) const { return values[p_lane]; }
	GRASS_INLINE void set(int p_lane, float p_value) { values[p_lane] = p_value; }
};

GRASS_INLINE Lanes operator+(const Lanes &p_a, const Lanes &p_b) {
	return Lanes(p_a.values + p_b.values);
}
GRASS_INLINE Lanes operator-(const Lanes &p_a, const Lanes &p_b) {
	return Lanes(p_a.values - p_b.values);
}
GRASS_INLINE Lanes operator*(const Lanes &p_a, const Lanes &p_b) {
	return Lanes(p_a.values * p_b.values);
}
GRASS_INLINE Lanes operator/(const Lanes &p_a, const Lanes &p_b) {
	return Lanes(p_a.values / p_b.values);
}
GRASS_INLINE Lanes operator-(const Lanes &p_a) {
	return Lanes(-p_a.values);
}
GRASS_INLINE LaneMask operator<(const Lanes &p_a, const Lanes &p_b) {
	return { p_a.values < p_b.values };
}
GRASS_INLINE LaneMask operator>(const Lanes &p_a, const Lanes &p_b) {
	return { p_a.values > p_b.values };
}
GRASS_INLINE LaneMask operator<=(const Lanes &p_a, const Lanes &p_b) {
	return { p_a.values <= p_b.values };
}
GRASS_INLINE LaneMask operator>=(const Lanes &p_a, const Lanes &p_b) {
	return { p_a.values >= p_b.values };
}

// p_a where the mask is true, else p_b.
GRASS_INLINE float select(bool p_mask, float p_a, float p_b) {
	return p_mask ? p_a : p_b;
}
GRASS_INLINE double select(bool p_mask, double p_a, double p_b) {
	return p_mask ? p_a : p_b;
}
GRASS_INLINE Lanes select(const LaneMask &p_mask, const Lanes &p_a, const Lanes &p_b) {
	return Lanes(p_mask.bits ? p_a.values : p_b.values);
}

// Whether any lane's mask is true: what a branch may ask.
GRASS_INLINE bool any(bool p_mask) {
	return p_mask;
}
GRASS_INLINE bool any(const LaneMask &p_mask) {
	const int64_t *quads = reinterpret_cast<const int64_t *>(&p_mask.bits);
	return (quads[0] | quads[1] | quads[2] | quads[3]) != 0;
}

GRASS_INLINE float square_root(float p_a) {
	return std::sqrt(p_a);
}
GRASS_INLINE double square_root(double p_a) {
	return std::sqrt(p_a);
}
GRASS_INLINE Lanes square_root(const Lanes &p_a) {
	Lanes root;
#if defined(__SSE2__)
	__m128 *to = reinterpret_cast<__m128 *>(&root.values);
	const __m128 *from = reinterpret_cast<const __m128 *>(&p_a.values);
	to[0] = _mm_sqrt_ps(from[0]);
	to[1] = _mm_sqrt_ps(from[1]);
#else
	for (int lane = 0; lane < Lanes::COUNT; lane++) {
		root.values[lane] = std::sqrt(p_a.values[lane]);
	}
#endif
	return root;
}

template <class T> GRASS_INLINE T minimum(const T &p_a, const T &p_b) {
	return select(p_a < p_b, p_a, p_b);
}
template <class T> GRASS_INLINE T maximum(const T &p_a, const T &p_b) {
	return select(p_a > p_b, p_a, p_b);
}
template <class T> GRASS_INLINE T absolute(const T &p_a) {
	return select(p_a < T(0.0f), -p_a, p_a);
}

} // namespace grass

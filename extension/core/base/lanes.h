// SPDX-License-Identifier: MIT
// Number types that one blade step can run on: float, double, or Lanes, which holds the same number of four or eight blades side by side
// (lanes_16.h adds sixteen). A comparison gives a mask (a bool, or one per lane); select() replaces `if`.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

// The step is a single function to the compiler. It keeps vectors in registers, and a caller compiled for a newer instruction set compiles
// all of it for that set. Under sanitizers that one function would take too long to compile.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GRASS_IS_SANITIZED 1
#elif defined(__has_feature) // clang
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GRASS_IS_SANITIZED 1
#endif
#endif
#if defined(GRASS_IS_SANITIZED)
#define GRASS_INLINE inline
#else
#define GRASS_INLINE inline __attribute__((always_inline))
#define GRASS_IS_ONE_FUNCTION 1
#endif
// Marks a lambda that apart() runs.
#define GRASS_APART __attribute__((always_inline))

namespace grass {

// Eight blades need AVX2. GRASS_WIDE enables it for a function; the caller must check first that the processor supports it.
#if defined(__x86_64__) && defined(GRASS_IS_ONE_FUNCTION)
#define GRASS_HAS_WIDE 1
#define GRASS_WIDE __attribute__((target("avx2")))
#endif

// The compiler's built-in vector types.
template <int N> struct LaneVectors;
template <> struct LaneVectors<4> {
	typedef float Floats __attribute__((vector_size(16)));
	typedef int32_t Bits __attribute__((vector_size(16)));
	typedef int64_t Quads __attribute__((vector_size(16)));
};
template <> struct LaneVectors<8> {
	typedef float Floats __attribute__((vector_size(32)));
	typedef int32_t Bits __attribute__((vector_size(32)));
	typedef int64_t Quads __attribute__((vector_size(32)));
};

// A mask for N lanes: all bits of a lane are set (true) or clear (false).
template <int N> struct LaneMask {
	using Values = typename LaneVectors<N>::Floats;
	typename LaneVectors<N>::Bits bits;

	static GRASS_INLINE LaneMask less(const Values &p_a, const Values &p_b) { return { p_a < p_b }; }
	static GRASS_INLINE LaneMask less_or_equal(const Values &p_a, const Values &p_b) { return { p_a <= p_b }; }

	friend GRASS_INLINE LaneMask operator&(const LaneMask &p_a, const LaneMask &p_b) { return { p_a.bits & p_b.bits }; }
	friend GRASS_INLINE LaneMask operator|(const LaneMask &p_a, const LaneMask &p_b) { return { p_a.bits | p_b.bits }; }
	friend GRASS_INLINE LaneMask operator!(const LaneMask &p_a) { return { ~p_a.bits }; }
};

// N floats. Arithmetic works lane by lane and rounds as a plain float does, so results have the same bits for any N.
template <int N> struct Lanes {
	static constexpr int COUNT = N;
	using Values = typename LaneVectors<N>::Floats;
	Values values;

	GRASS_INLINE Lanes() : values{} {}
	GRASS_INLINE Lanes(float p_value) : values(Values{} + p_value) {}
	GRASS_INLINE explicit Lanes(const Values &p_values) : values(p_values) {}
	GRASS_INLINE float operator[](int p_lane) const { return values[p_lane]; }

	friend GRASS_INLINE Lanes operator+(const Lanes &p_a, const Lanes &p_b) { return Lanes(p_a.values + p_b.values); }
	friend GRASS_INLINE Lanes operator-(const Lanes &p_a, const Lanes &p_b) { return Lanes(p_a.values - p_b.values); }
	friend GRASS_INLINE Lanes operator*(const Lanes &p_a, const Lanes &p_b) { return Lanes(p_a.values * p_b.values); }
	friend GRASS_INLINE Lanes operator/(const Lanes &p_a, const Lanes &p_b) { return Lanes(p_a.values / p_b.values); }
	friend GRASS_INLINE Lanes operator-(const Lanes &p_a) { return Lanes(-p_a.values); }
	friend GRASS_INLINE LaneMask<N> operator<(const Lanes &p_a, const Lanes &p_b) { return LaneMask<N>::less(p_a.values, p_b.values); }
	friend GRASS_INLINE LaneMask<N> operator>(const Lanes &p_a, const Lanes &p_b) { return p_b < p_a; }
	friend GRASS_INLINE LaneMask<N> operator<=(const Lanes &p_a, const Lanes &p_b) {
		return LaneMask<N>::less_or_equal(p_a.values, p_b.values);
	}
	friend GRASS_INLINE LaneMask<N> operator>=(const Lanes &p_a, const Lanes &p_b) { return p_b <= p_a; }
};

template <class Body> __attribute__((noinline)) auto run_apart(const Body &p_body) {
	return p_body();
}
#if defined(GRASS_HAS_WIDE)
template <class Body> __attribute__((noinline)) GRASS_WIDE auto run_apart_wide(const Body &p_body) {
	return p_body();
}
#endif

// Runs p_body, which works on T, in a separate function. Code that only a few blades need would otherwise push the others' vectors out of
// their registers, and would take minutes to compile in one function with the rest. It must not return a plain vector, since calling
// conventions for these differ between instruction sets.
template <class T, class Body> GRASS_INLINE auto apart(const Body &p_body) {
#if defined(GRASS_HAS_WIDE)
	if constexpr (std::is_same_v<T, Lanes<8>>) {
		return run_apart_wide(p_body);
	}
#endif
	return run_apart(p_body);
}

// Returns p_a where the mask is true, else p_b.
GRASS_INLINE float select(bool p_mask, float p_a, float p_b) {
	return p_mask ? p_a : p_b;
}
GRASS_INLINE double select(bool p_mask, double p_a, double p_b) {
	return p_mask ? p_a : p_b;
}
template <int N> GRASS_INLINE Lanes<N> select(const LaneMask<N> &p_mask, const Lanes<N> &p_a, const Lanes<N> &p_b) {
	return Lanes<N>(p_mask.bits ? p_a.values : p_b.values);
}

// Returns whether the mask of any lane is true: the condition of a branch.
GRASS_INLINE bool any(bool p_mask) {
	return p_mask;
}
template <int N> GRASS_INLINE bool any(const LaneMask<N> &p_mask) {
	const auto quads = typename LaneVectors<N>::Quads(p_mask.bits);
#if defined(__SSE2__)
	__m128i either = __m128i{ quads[0], quads[1] };
	if constexpr (N == 8) {
		either = either | __m128i{ quads[2], quads[3] };
	}
	return _mm_movemask_epi8(either) != 0;
#else
	int64_t either = 0;
	for (int i = 0; i < N / 2; i++) {
		either |= quads[i];
	}
	return either != 0;
#endif
}

// Return the logical "and" and "or", since lanes have no && and ||.
template <class Mask> GRASS_INLINE Mask both(const Mask &p_a, const Mask &p_b) {
	return p_a & p_b;
}
template <class Mask> GRASS_INLINE Mask either(const Mask &p_a, const Mask &p_b) {
	return p_a | p_b;
}
// Selects inside a branch that runs if any mask is true. A single blade enters it only if its own mask is true, so there is nothing to
// select.
template <class Mask, class Value> GRASS_INLINE Value in_lanes(const Mask &p_mask, const Value &p_a, const Value &p_b) {
	return select(p_mask, p_a, p_b);
}

GRASS_INLINE float square_root(float p_a) {
	return std::sqrt(p_a);
}
GRASS_INLINE double square_root(double p_a) {
	return std::sqrt(p_a);
}
template <int N> GRASS_INLINE Lanes<N> square_root(const Lanes<N> &p_a) {
	Lanes<N> root;
	for (int lane = 0; lane < N; lane++) { // one instruction with -fno-math-errno; two of half the width would wait for each other
		root.values[lane] = std::sqrt(p_a.values[lane]);
	}
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

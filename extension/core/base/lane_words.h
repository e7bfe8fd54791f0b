// SPDX-License-Identifier: MIT
// Defines, as C++ over any lane type T, the words that the texts over T in shaders/ use (shaders/base/lanes.inc explains them). A header
// includes this before such a text, and lane_words_end.h after it; so this file has no include guard.
#define GRASS_LANES template <class T> GRASS_INLINE
#define GRASS_RECORD template <class T>
#define VEC3 Vec3<T>
#define TURN Turn<T>
#define FACE Face<T>
#define MASK auto
#define OF_T(m_record) m_record<T>
#define MADE(m_record) made<m_record<T>>
#define IN(m_type) const m_type &
#define INOUT(m_type) m_type &
#define TO_T(m_value) widened<T>(m_value)
#if defined(__clang__) // before a loop over an array that should be in registers
#define GRASS_UNROLL _Pragma("unroll")
#else
#define GRASS_UNROLL _Pragma("GCC unroll 16")
#endif
#define NO_TURN Turn<T>()
#define precise // every sum is precise already, unless a compiler option relaxes it

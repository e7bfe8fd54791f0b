// SPDX-License-Identifier: MIT
// The words of the texts over T in shaders/ (shaders/base/lanes.inc says what they mean) as C++, where T is any lane type. A header that
// includes such a text includes this before it, and lane_words_end.h after it: so it has no guard.
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
#define precise // every sum is, without an option that allows more

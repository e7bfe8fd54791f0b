// SPDX-License-Identifier: MIT
// Enough of GLSL for C++ to compile the shared texts in shaders/: blades/, lod/ and map/growth.inc, which the compute passes, the blade
// shader and the core all use. Such a text uses constructors in place of swizzles, literals with an f, float() around numbers of
// constants.inc, and GRASS_FUNCTION before each function. Everything rounds as Eigen's expressions of the same form do.
#pragma once

#include "core/base/hash.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace grass::glsl {

struct vec2 {
	float x = 0.0f, y = 0.0f;
	constexpr vec2() = default;
	constexpr explicit vec2(float p_all) : x(p_all), y(p_all) {}
	constexpr vec2(float p_x, float p_y) : x(p_x), y(p_y) {}
	constexpr bool operator==(const vec2 &) const = default;
};

struct vec3 {
	float x = 0.0f, y = 0.0f, z = 0.0f;
	constexpr vec3() = default;
	constexpr explicit vec3(float p_all) : x(p_all), y(p_all), z(p_all) {}
	constexpr vec3(float p_x, float p_y, float p_z) : x(p_x), y(p_y), z(p_z) {}
	constexpr bool operator==(const vec3 &) const = default;
};

struct vec4 {
	float x = 0.0f, y = 0.0f, z = 0.0f, w = 0.0f;
	constexpr vec4() = default;
	constexpr explicit vec4(float p_all) : x(p_all), y(p_all), z(p_all), w(p_all) {}
	constexpr vec4(float p_x, float p_y, float p_z, float p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}
	constexpr bool operator==(const vec4 &) const = default;
};

struct ivec2 {
	int x = 0, y = 0;
	constexpr explicit ivec2(int p_all) : x(p_all), y(p_all) {}
	constexpr ivec2(int p_x, int p_y) : x(p_x), y(p_y) {}
	explicit ivec2(const vec2 &p_a) : x(int(p_a.x)), y(int(p_a.y)) {}
};

constexpr ivec2 operator+(const ivec2 &p_a, const ivec2 &p_b) {
	return { p_a.x + p_b.x, p_a.y + p_b.y };
}
constexpr ivec2 operator&(const ivec2 &p_a, const ivec2 &p_b) {
	return { p_a.x & p_b.x, p_a.y & p_b.y };
}

// Apply p_body component by component.
template <class Body> vec2 each(const vec2 &p_a, const vec2 &p_b, const Body &p_body) {
	return { p_body(p_a.x, p_b.x), p_body(p_a.y, p_b.y) };
}
template <class Body> vec3 each(const vec3 &p_a, const vec3 &p_b, const Body &p_body) {
	return { p_body(p_a.x, p_b.x), p_body(p_a.y, p_b.y), p_body(p_a.z, p_b.z) };
}
template <class Body> vec4 each(const vec4 &p_a, const vec4 &p_b, const Body &p_body) {
	return { p_body(p_a.x, p_b.x), p_body(p_a.y, p_b.y), p_body(p_a.z, p_b.z), p_body(p_a.w, p_b.w) };
}
template <class V>
concept Vector = std::is_same_v<V, vec2> || std::is_same_v<V, vec3> || std::is_same_v<V, vec4>;

template <Vector V> V operator+(const V &p_a, const V &p_b) {
	return each(p_a, p_b, [](float p_x, float p_y) { return p_x + p_y; });
}
template <Vector V> V operator-(const V &p_a, const V &p_b) {
	return each(p_a, p_b, [](float p_x, float p_y) { return p_x - p_y; });
}
template <Vector V> V operator*(const V &p_a, const V &p_b) {
	return each(p_a, p_b, [](float p_x, float p_y) { return p_x * p_y; });
}
template <Vector V> V operator/(const V &p_a, const V &p_b) {
	return each(p_a, p_b, [](float p_x, float p_y) { return p_x / p_y; });
}
template <Vector V> V operator*(float p_a, const V &p_b) {
	return V(p_a) * p_b;
}
template <Vector V> V operator*(const V &p_a, float p_b) {
	return p_a * V(p_b);
}
template <Vector V> V operator/(const V &p_a, float p_b) {
	return p_a / V(p_b);
}
template <Vector V> V &operator+=(V &r_a, const V &p_b) {
	return r_a = r_a + p_b;
}

// GLSL's built-in functions.

inline float floor(float p_a) {
	return std::floor(p_a);
}
inline vec2 floor(const vec2 &p_a) {
	return { std::floor(p_a.x), std::floor(p_a.y) };
}
inline vec2 abs(const vec2 &p_a) {
	return { std::abs(p_a.x), std::abs(p_a.y) };
}
inline vec3 abs(const vec3 &p_a) {
	return { std::abs(p_a.x), std::abs(p_a.y), std::abs(p_a.z) };
}
inline float sqrt(float p_a) {
	return std::sqrt(p_a);
}
inline float sin(float p_a) {
	return std::sin(p_a);
}
inline float exp(float p_a) {
	return std::exp(p_a);
}
inline float min(float p_a, float p_b) {
	return std::min(p_a, p_b);
}
inline float max(float p_a, float p_b) {
	return std::max(p_a, p_b);
}
inline float clamp(float p_a, float p_min, float p_max) {
	return std::clamp(p_a, p_min, p_max);
}

inline float dot(const vec2 &p_a, const vec2 &p_b) {
	return p_a.x * p_b.x + p_a.y * p_b.y;
}
inline float dot(const vec3 &p_a, const vec3 &p_b) {
	return p_a.x * p_b.x + (p_a.y * p_b.y + p_a.z * p_b.z);
}
inline vec3 cross(const vec3 &p_a, const vec3 &p_b) {
	return { p_a.y * p_b.z - p_a.z * p_b.y, p_a.z * p_b.x - p_a.x * p_b.z, p_a.x * p_b.y - p_a.y * p_b.x };
}
template <Vector V> float length(const V &p_a) {
	return std::sqrt(dot(p_a, p_a));
}
template <Vector V> V normalize(const V &p_a) {
	return p_a / length(p_a);
}

inline float mix(float p_a, float p_b, float p_t) {
	return p_a * (1.0f - p_t) + p_b * p_t;
}
template <Vector V> V mix(const V &p_a, const V &p_b, float p_t) {
	return p_a * (1.0f - p_t) + p_b * p_t;
}
inline float smoothstep(float p_from, float p_to, float p_a) {
	const float t = std::clamp((p_a - p_from) / (p_to - p_from), 0.0f, 1.0f);
	return t * t * (3.0f - 2.0f * t);
}
inline vec4 smoothstep(const vec4 &p_from, const vec4 &p_to, const vec4 &p_a) {
	return { smoothstep(p_from.x, p_to.x, p_a.x), smoothstep(p_from.y, p_to.y, p_a.y), smoothstep(p_from.z, p_to.z, p_a.z),
		smoothstep(p_from.w, p_to.w, p_a.w) };
}

} // namespace grass::glsl

namespace grass {

inline glsl::vec2 to_glsl(const Eigen::Vector2f &p_a) {
	return { p_a.x(), p_a.y() };
}
inline glsl::vec3 to_glsl(const Eigen::Vector3f &p_a) {
	return { p_a.x(), p_a.y(), p_a.z() };
}
inline glsl::vec4 to_glsl(const Eigen::Vector4f &p_a) {
	return { p_a.x(), p_a.y(), p_a.z(), p_a.w() };
}
inline Eigen::Vector2f from_glsl(const glsl::vec2 &p_a) {
	return { p_a.x, p_a.y };
}
inline Eigen::Vector3f from_glsl(const glsl::vec3 &p_a) {
	return { p_a.x, p_a.y, p_a.z };
}

} // namespace grass

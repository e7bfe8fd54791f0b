// SPDX-License-Identifier: MIT
// A colour: red, green, blue, opacity, 0..1 and beyond.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/forward.hpp>

namespace godot {

struct Color {
	union {
		struct {
			float r, g, b, a;
		};
		float components[4];
	};

	constexpr Color() : r(0), g(0), b(0), a(1) {}
	constexpr Color(float p_r, float p_g, float p_b, float p_a = 1) : r(p_r), g(p_g), b(p_b), a(p_a) {}
	constexpr Color(const Color &p_color, float p_a) : r(p_color.r), g(p_color.g), b(p_color.b), a(p_a) {}
	// A name or #rrggbb.
	Color(const String &p_code);
	Color(const char *p_code);

	float &operator[](int p_index) { return components[p_index]; }
	const float &operator[](int p_index) const { return components[p_index]; }

	constexpr Color operator+(const Color &p_c) const { return Color(r + p_c.r, g + p_c.g, b + p_c.b, a + p_c.a); }
	constexpr Color operator-(const Color &p_c) const { return Color(r - p_c.r, g - p_c.g, b - p_c.b, a - p_c.a); }
	constexpr Color operator*(const Color &p_c) const { return Color(r * p_c.r, g * p_c.g, b * p_c.b, a * p_c.a); }
	constexpr Color operator/(const Color &p_c) const { return Color(r / p_c.r, g / p_c.g, b / p_c.b, a / p_c.a); }
	constexpr Color operator*(float p_s) const { return Color(r * p_s, g * p_s, b * p_s, a * p_s); }
	constexpr Color operator/(float p_s) const { return Color(r / p_s, g / p_s, b / p_s, a / p_s); }
	void operator+=(const Color &p_c) { *this = *this + p_c; }
	void operator-=(const Color &p_c) { *this = *this - p_c; }
	void operator*=(const Color &p_c) { *this = *this * p_c; }
	void operator*=(float p_s) { *this = *this * p_s; }
	void operator/=(float p_s) { *this = *this / p_s; }
	constexpr bool operator==(const Color &p_c) const { return r == p_c.r && g == p_c.g && b == p_c.b && a == p_c.a; }
	constexpr bool operator!=(const Color &p_c) const { return !(*this == p_c); }
	Color lerp(const Color &p_to, float p_weight) const { return *this + (p_to - *this) * p_weight; }
	bool is_equal_approx(const Color &p_c) const {
		return Math::is_equal_approx(r, p_c.r) && Math::is_equal_approx(g, p_c.g) && Math::is_equal_approx(b, p_c.b) &&
				Math::is_equal_approx(a, p_c.a);
	}

	operator String() const;

#include <godot_cpp/variant/gen/color.inc>
};

constexpr Color operator*(float p_s, const Color &p_c) {
	return p_c * p_s;
}

} // namespace godot

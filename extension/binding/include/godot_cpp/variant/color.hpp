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

	Color() : r(0), g(0), b(0), a(1) {}
	Color(float p_r, float p_g, float p_b, float p_a) : r(p_r), g(p_g), b(p_b), a(p_a) {}
	Color(float p_r, float p_g, float p_b) : Color(p_r, p_g, p_b, 1) {}
	Color(const Color &p_color, float p_a) : Color(p_color.r, p_color.g, p_color.b, p_a) {}
	Color(const String &) = delete; // upstream has these, so a Variant is ambiguous
	Color(const String &, float) = delete;

	float &operator[](int p_index) { return components[p_index]; }
	const float &operator[](int p_index) const { return components[p_index]; }

	Color operator+(const Color &p_c) const { return Color(r + p_c.r, g + p_c.g, b + p_c.b, a + p_c.a); }
	Color operator-(const Color &p_c) const { return Color(r - p_c.r, g - p_c.g, b - p_c.b, a - p_c.a); }
	Color operator*(const Color &p_c) const { return Color(r * p_c.r, g * p_c.g, b * p_c.b, a * p_c.a); }
	Color operator*(float p_s) const { return Color(r * p_s, g * p_s, b * p_s, a * p_s); }
	Color operator/(float p_s) const { return Color(r / p_s, g / p_s, b / p_s, a / p_s); }
	void operator+=(const Color &p_c) { *this = *this + p_c; }
	void operator-=(const Color &p_c) { *this = *this - p_c; }
	void operator*=(float p_s) { *this = *this * p_s; }
	Color operator/(const Color &) const = delete; // upstream has these, so a Variant is ambiguous
	void operator*=(const Color &) = delete;
	bool operator==(const Color &p_c) const { return r == p_c.r && g == p_c.g && b == p_c.b && a == p_c.a; }
	bool operator!=(const Color &p_c) const { return !(*this == p_c); }
	Color lerp(const Color &p_to, float p_weight) const { return *this + (p_to - *this) * p_weight; }
	Color srgb_to_linear() const;
	Color linear_to_srgb() const;
	String to_html(bool p_alpha = true) const; // rrggbbaa

	operator String() const;
};

} // namespace godot

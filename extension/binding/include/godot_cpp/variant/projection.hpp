// SPDX-License-Identifier: MIT
// A 4 x 4 matrix by columns: what a camera does.
#pragma once

#include <godot_cpp/variant/vector4.hpp>

#include <algorithm>
#include <iterator>

namespace godot {

struct Projection {
	Vector4 columns[4] = { Vector4(1, 0, 0, 0), Vector4(0, 1, 0, 0), Vector4(0, 0, 1, 0), Vector4(0, 0, 0, 1) };

	constexpr Projection() = default;
	constexpr Projection(const Vector4 &p_x, const Vector4 &p_y, const Vector4 &p_z, const Vector4 &p_w) : columns{ p_x, p_y, p_z, p_w } {}

	bool operator==(const Projection &p_other) const { return std::equal(columns, std::end(columns), p_other.columns); }
	bool operator!=(const Projection &p_other) const { return !(*this == p_other); }

	operator String() const;
};

} // namespace godot

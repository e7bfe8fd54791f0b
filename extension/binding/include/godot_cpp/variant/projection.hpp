// SPDX-License-Identifier: MIT
// A camera's map of space to clip space, by columns.
#pragma once

#include <godot_cpp/variant/vector4.hpp>

namespace godot {

struct Projection {
	Vector4 columns[4] = { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } };

	Projection() = default;
	Projection(const Vector4 &p_x, const Vector4 &p_y, const Vector4 &p_z, const Vector4 &p_w) : columns{ p_x, p_y, p_z, p_w } {}

	bool operator==(const Projection &p_p) const {
		return columns[0] == p_p.columns[0] && columns[1] == p_p.columns[1] && columns[2] == p_p.columns[2] && columns[3] == p_p.columns[3];
	}
	bool operator!=(const Projection &p_p) const { return !(*this == p_p); }

	operator String() const;
};

} // namespace godot

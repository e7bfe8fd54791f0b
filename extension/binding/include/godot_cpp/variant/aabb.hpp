// SPDX-License-Identifier: MIT
// An axis-aligned box: a corner and a size. Sizes are taken to be non-negative.
#pragma once

#include <godot_cpp/variant/plane.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

struct AABB {
	Vector3 position;
	Vector3 size;

	constexpr AABB() = default;
	constexpr AABB(const Vector3 &p_position, const Vector3 &p_size) : position(p_position), size(p_size) {}

	const Vector3 &get_position() const { return position; }
	void set_position(const Vector3 &p_position) { position = p_position; }
	const Vector3 &get_size() const { return size; }
	void set_size(const Vector3 &p_size) { size = p_size; }
	Vector3 get_end() const { return position + size; }
	void set_end(const Vector3 &p_end) { size = p_end - position; }
	Vector3 get_center() const { return position + size * 0.5f; }
	real_t get_volume() const { return size.x * size.y * size.z; }
	bool has_volume() const { return size.x > 0 && size.y > 0 && size.z > 0; }
	bool has_surface() const { return size.x > 0 || size.y > 0 || size.z > 0; }
	AABB abs() const { return AABB(position + size.min(Vector3()), size.abs()); }

	bool has_point(const Vector3 &p_point) const {
		const Vector3 end = get_end();
		return p_point.x >= position.x && p_point.y >= position.y && p_point.z >= position.z && p_point.x <= end.x && p_point.y <= end.y &&
				p_point.z <= end.z;
	}
	bool intersects(const AABB &p_box) const {
		const Vector3 end = get_end();
		const Vector3 other = p_box.get_end();
		return position.x < other.x && end.x > p_box.position.x && position.y < other.y && end.y > p_box.position.y &&
				position.z < other.z && end.z > p_box.position.z;
	}
	bool intersects_inclusive(const AABB &p_box) const {
		const Vector3 end = get_end();
		const Vector3 other = p_box.get_end();
		return position.x <= other.x && end.x >= p_box.position.x && position.y <= other.y && end.y >= p_box.position.y &&
				position.z <= other.z && end.z >= p_box.position.z;
	}
	// Where the line enters and the side of the box there, if asked for. A ray has one direction, a segment two ends.
	bool intersects_segment(const Vector3 &p_from, const Vector3 &p_to, Vector3 *r_point = nullptr, Vector3 *r_normal = nullptr) const {
		return clip(p_from, p_to - p_from, 1, r_point, r_normal);
	}
	bool intersects_ray(const Vector3 &p_from, const Vector3 &p_direction) const {
		return clip(p_from, p_direction, std::numeric_limits<real_t>::max(), nullptr, nullptr);
	}
	bool intersects_plane(const Plane &p_plane) const {
		const Vector3 half = size * 0.5f;
		return Math::abs(p_plane.distance_to(get_center())) <= p_plane.normal.abs().dot(half);
	}
	bool encloses(const AABB &p_box) const {
		const Vector3 end = get_end();
		const Vector3 other = p_box.get_end();
		return position.x <= p_box.position.x && position.y <= p_box.position.y && position.z <= p_box.position.z && end.x >= other.x &&
				end.y >= other.y && end.z >= other.z;
	}
	AABB merge(const AABB &p_box) const {
		const Vector3 low = position.min(p_box.position);
		return AABB(low, get_end().max(p_box.get_end()) - low);
	}
	void merge_with(const AABB &p_box) { *this = merge(p_box); }
	AABB intersection(const AABB &p_box) const {
		const Vector3 low = position.max(p_box.position);
		const Vector3 high = get_end().min(p_box.get_end());
		return low.x > high.x || low.y > high.y || low.z > high.z ? AABB() : AABB(low, high - low);
	}
	AABB expand(const Vector3 &p_point) const {
		const Vector3 low = position.min(p_point);
		return AABB(low, get_end().max(p_point) - low);
	}
	void expand_to(const Vector3 &p_point) { *this = expand(p_point); }
	AABB grow(real_t p_by) const { return AABB(position - Vector3(p_by, p_by, p_by), size + Vector3(p_by, p_by, p_by) * 2); }
	void grow_by(real_t p_by) { *this = grow(p_by); }
	Vector3 get_endpoint(int p_index) const {
		return Vector3(
				position.x + (p_index & 4 ? size.x : 0), position.y + (p_index & 2 ? size.y : 0), position.z + (p_index & 1 ? size.z : 0));
	}
	Vector3 get_support(const Vector3 &p_direction) const {
		return Vector3(position.x + (p_direction.x > 0 ? size.x : 0), position.y + (p_direction.y > 0 ? size.y : 0),
				position.z + (p_direction.z > 0 ? size.z : 0));
	}
	int get_longest_axis_index() const { return size.max_axis_index(); }
	real_t get_longest_axis_size() const { return MAX(size.x, MAX(size.y, size.z)); }
	real_t get_shortest_axis_size() const { return MIN(size.x, MIN(size.y, size.z)); }
	bool is_equal_approx(const AABB &p_box) const { return position.is_equal_approx(p_box.position) && size.is_equal_approx(p_box.size); }
	bool is_finite() const { return position.is_finite() && size.is_finite(); }
	bool operator==(const AABB &p_box) const { return position == p_box.position && size == p_box.size; }
	bool operator!=(const AABB &p_box) const { return !(*this == p_box); }

	operator String() const;

#include <godot_cpp/variant/gen/aabb.inc>

private:
	bool clip(const Vector3 &p_from, const Vector3 &p_direction, real_t p_length, Vector3 *r_point, Vector3 *r_normal) const;
};

// The stretch of the line, in units of its direction, that lies between each pair of sides.
inline bool AABB::clip(const Vector3 &p_from, const Vector3 &p_direction, real_t p_length, Vector3 *r_point, Vector3 *r_normal) const {
	real_t enter = 0;
	real_t leave = p_length;
	int axis = 0;
	for (int i = 0; i < 3; i++) {
		const real_t low = position[i] - p_from[i];
		const real_t high = low + size[i];
		if (p_direction[i] == 0) {
			if (low > 0 || high < 0) {
				return false;
			}
			continue;
		}
		const real_t a = MIN(low / p_direction[i], high / p_direction[i]);
		const real_t b = MAX(low / p_direction[i], high / p_direction[i]);
		if (a > enter) {
			enter = a;
			axis = i;
		}
		leave = MIN(leave, b);
	}
	if (enter > leave) {
		return false;
	}
	if (r_point) {
		*r_point = p_from + p_direction * enter;
	}
	if (r_normal) {
		*r_normal = Vector3();
		(*r_normal)[axis] = -SIGN(p_direction[axis]);
	}
	return true;
}

} // namespace godot

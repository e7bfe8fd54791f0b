// SPDX-License-Identifier: MIT
// The triangles of a height map or trimesh, from a resource or as the physics server has it.
#pragma once

#include "core/map/ground_grid.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/shape3d.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <functional>
#include <optional>

namespace grass {

class GroundTriangles {
public:
	using Visit = std::function<void(const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b, const Eigen::Vector3d &p_c)>;

	// Takes a shape's triangles; shapes of other kinds have none.
	explicit GroundTriangles(const godot::Ref<godot::Shape3D> &p_shape);
	explicit GroundTriangles(const godot::RID &p_shape);

	bool is_empty() const { return count() == 0; }
	int64_t count() const { return _faces.size() / 3 + 2 * int64_t(std::max(_width - 1, 0)) * std::max(_depth - 1, 0); }
	// Visits those from p_first to p_end - 1; p_to_field: from the shape's space.
	void visit(const Eigen::Affine3d &p_to_field, int64_t p_first, int64_t p_end, const Visit &p_visit) const;
	// Returns the grid on which they have their corners in the field, if there is one.
	std::optional<GroundGrid> find_grid(const Eigen::Affine3d &p_to_field) const;

private:
	void set_map(int p_width, int p_depth, const godot::PackedRealArray &p_heights);
	Eigen::Vector3d corner(int64_t p_i, int64_t p_j) const;

	int _width = 0, _depth = 0; // corners of a height map; 0: it is a trimesh
	godot::PackedRealArray _heights; // a NaN is a hole
	godot::PackedVector3Array _faces;
};

} // namespace grass

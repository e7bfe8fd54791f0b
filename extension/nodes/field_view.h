// SPDX-License-Identifier: MIT
// The cameras and lights in which a field is seen in this frame.
#pragma once

#include "core/detail/view.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/node3d.hpp>

namespace grass {

// All cameras whose picture this frame shows of p_node's world, in the space of p_field (orthonormal): of the window, of each
// SubViewport, of the editor's views.
std::vector<ViewCamera> find_cameras(godot::Node3D *p_node, const Eigen::Affine3d &p_field);

// Whether one of their pictures is made with motion vectors: for TAA, FSR 2, or an effect that reads them.
bool are_motion_vectors_read(godot::Node3D *p_node);

// Where the shadow of a point p_height metres above the field ends, from there, for each directional light of p_node's world that
// casts shadows down on it. At most p_farthest metres long; field space.
std::vector<Eigen::Vector3f> find_falls(godot::Node3D *p_node, const Eigen::Affine3d &p_field, double p_height, double p_farthest);

} // namespace grass

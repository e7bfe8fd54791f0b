// SPDX-License-Identifier: MIT
// The cameras and lights by which a field is seen in this frame.
#pragma once

#include "core/field/field.h"
#include "core/lod/view.h"
#include "field/field_properties.h"

#include <godot_cpp/classes/geometry_instance3d.hpp>

namespace grass {

// Returns all cameras that show p_node's world and layers in this frame (the window's, each SubViewport's, a headset's eyes, the editor's
// views) and the suns in whose light it casts shadows, in the space of p_field, which is at p_transform (orthonormal).
FieldView find_view(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform, const FieldProperties &p_properties,
		const Field &p_field);

// Returns the positions of the cameras that see p_layers of p_node's world, in metres in the space of p_field (orthonormal).
std::vector<Eigen::Vector3d> find_eyes(const godot::Node3D *p_node, uint32_t p_layers, const Eigen::Affine3d &p_field);
// Returns the x and z of these positions.
std::vector<Eigen::Vector2d> find_eyes_on_ground(const godot::Node3D *p_node, uint32_t p_layers, const Eigen::Affine3d &p_field);

} // namespace grass

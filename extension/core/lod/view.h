// SPDX-License-Identifier: MIT
// Where a field is seen from, and how finely it is drawn.
#pragma once

#include "core/lod/lod.h"

#include <Eigen/Geometry>

#include <vector>

namespace grass {

// A camera that sees the field. Field space, metres.
struct ViewCamera {
	Frustum planes = {}; // n.x <= d inside
	Eigen::Vector3f eye = Eigen::Vector3f::Zero();
	float near = 0.05f; // distance of its near plane
	float pixel = 0.0f, pixel_slope = 0.0f; // metres in a pixel at a distance: pixel + pixel_slope * distance

	float pixel_at(float p_distance) const { return pixel + pixel_slope * p_distance; }
	bool operator==(const ViewCamera &) const = default;
};

// What the six planes of a projection hold. p_clip: from the planes' space to clip space (OpenGL's: -w <= x, y, z <= w is seen).
Frustum frustum_of(const Eigen::Matrix4d &p_clip);

// One eye of a headset. p_projection: from its own space to clip space; p_eye: its pose in field space (orthonormal); p_near: metres;
// p_pixels: height of its picture. A field that two eyes see has two cameras: no plane of one eye takes away what the other sees, and
// the eye that is nearer decides how fine a tile is drawn.
ViewCamera view_of_eye(const Eigen::Matrix4d &p_projection, const Eigen::Affine3d &p_eye, double p_near, double p_pixels);

// Where the field is seen from in a frame, and how finely it is drawn. Field space, metres.
struct FieldView {
	std::vector<ViewCamera> cameras; // all whose picture this frame shows, and that see the field's layers; two of a headset
	bool is_watched = false; // a picture of the field's world is shown, whatever layers it leaves out; else nobody knows who looks at it
	LodParams lod;
	float shadow_distance = 0.0f; // tiles farther from every camera cast no shadow; 0: none does
	float shadow_margin = 0.0f; // how far outside of a frustum a tile still casts its shadow, whatever the light
	std::vector<Eigen::Vector3f> falls; // of each directional light: from the tallest tip to where its shadow ends
	bool has_motion = false; // somebody reads the picture's motion vectors

	bool operator==(const FieldView &) const = default;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// From where a field is seen, and how finely it is drawn.
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
	float pixel = 0.0f, pixel_slope = 0.0f; // size of a pixel at a distance, metres: pixel + pixel_slope * distance

	float pixel_at(float p_distance) const { return pixel + pixel_slope * p_distance; }
	bool operator==(const ViewCamera &) const = default;
};

// Returns the six planes of a projection. p_clip: from the planes' space to clip space (OpenGL's: -w <= x, y, z <= w is visible).
Frustum frustum_of(const Eigen::Matrix4d &p_clip);

// Returns the camera of one eye of a headset. p_projection: from its own space to clip space; p_eye: its pose in field space (orthonormal);
// p_near: metres; p_pixels: height of its picture. A field seen by two eyes has two cameras: no plane of one eye culls what the other sees,
// and the nearer eye decides how finely a tile is drawn.
ViewCamera view_of_eye(const Eigen::Matrix4d &p_projection, const Eigen::Affine3d &p_eye, double p_near, double p_pixels);

// From where the field is seen in a frame, and how finely it is drawn. Field space, metres.
struct FieldView {
	std::vector<ViewCamera> cameras; // all that render in this frame and see the field's layers; a headset has two
	bool is_watched = false; // a picture of the field's world is rendered, whatever its layers; otherwise it is unknown what sees the field
	bool is_drawn = true; // the engine renders frames; a headless one does not, whatever cameras it has
	LodParams lod;
	float plant_reach = 1.0f; // share of its distance up to which a plant is drawn with its mesh
	float shadow_distance = 0.0f; // tiles farther from every camera cast no shadow; 0: none do
	float shadow_margin = 0.0f; // how far outside a frustum a tile still casts its shadow, for any light
	std::vector<Eigen::Vector3f> falls; // for each directional light: from the tallest tip to the end of its shadow
	bool has_motion = false; // something reads the picture's motion vectors

	bool operator==(const FieldView &) const = default;
};

} // namespace grass

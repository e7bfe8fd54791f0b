// SPDX-License-Identifier: MIT
#include "core/lod/view.h"

#include <algorithm>

namespace grass {

Frustum frustum_of(const Eigen::Matrix4d &p_clip) {
	Frustum planes;
	for (int i = 0; i < 6; i++) {
		const double sign = i % 2 == 0 ? 1.0 : -1.0;
		const Eigen::RowVector4d outward = sign * p_clip.row(i / 2) - p_clip.row(3); // positive: beyond w
		const double length = outward.head<3>().norm();
		// An infinitely distant far plane has no direction: everything is inside.
		planes[size_t(i)] = length > 1e-12 * p_clip.row(3).norm()
				? Eigen::Vector4f(Eigen::Vector4d(outward.x(), outward.y(), outward.z(), -outward.w()).cast<float>() / float(length))
				: Eigen::Vector4f(0.0f, 0.0f, 0.0f, 1.0f);
	}
	return planes;
}

ViewCamera view_of_eye(const Eigen::Matrix4d &p_projection, const Eigen::Affine3d &p_eye, double p_near, double p_pixels) {
	ViewCamera view;
	view.planes = frustum_of(p_projection * p_eye.inverse(Eigen::Isometry).matrix());
	view.eye = p_eye.translation().cast<float>();
	view.near = float(p_near);
	view.pixel_slope = float(2.0 / (p_projection(1, 1) * std::max(p_pixels, 1.0)));
	return view;
}

} // namespace grass

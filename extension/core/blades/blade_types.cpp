// SPDX-License-Identifier: MIT
#include "core/blades/blade_types.h"

#include "core/base/functions.h"

#include <algorithm>

namespace grass {

namespace {

using Controls = std::array<double, BladeType::CONTROLS>;

// Interpolates the control numbers with a Catmull-Rom spline. p_along: 0 = root, 1 = tip.
double control_at(const Controls &p_controls, double p_along) {
	const double place = p_along * (BladeType::CONTROLS - 1);
	const int i = std::clamp(int(place), 0, BladeType::CONTROLS - 2);
	const double t = place - i;
	const double b = p_controls[i];
	const double c = p_controls[i + 1];
	const double a = i > 0 ? p_controls[i - 1] : 2.0 * b - c;
	const double d = i + 2 < BladeType::CONTROLS ? p_controls[i + 2] : 2.0 * c - b;
	return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

} // namespace

BladeCurve blade_curve(const BladeType &p_type, double p_bend, double p_twist) {
	BladeCurve curve;
	curve.knots[0].setZero();
	curve.twist[0] = 0.0;
	for (int k = 1; k < GRASS_KNOTS; ++k) {
		// Each segment takes the direction at its middle. Laid end to end, all have the right length by construction.
		const double middle = 0.5 * (knot_share(k - 1) + knot_share(k));
		const double inclination = DEGREE * p_bend * control_at(p_type.inclination, middle);
		const double bearing = DEGREE * control_at(p_type.bearing, middle);
		const Eigen::Vector3d direction(sine(inclination) * cosine(bearing), cosine(inclination), sine(inclination) * sine(bearing));
		curve.knots[k] = curve.knots[k - 1] + direction * segment_share(k - 1);
		curve.twist[k] = DEGREE * p_twist * control_at(p_type.twist, knot_share(k));
	}
	return curve;
}

} // namespace grass

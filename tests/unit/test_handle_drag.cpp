// SPDX-License-Identifier: MIT
// A handle follows the cursor along its axis.
#include "core/paint/handle_drag.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace grass;

TEST_CASE("handle drag: the place on the axis under the cursor, or nothing") {
	const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), eye(2.0, 3.0, 5.0);
	for (const double place : { -40.0, 0.5, 7.0 }) {
		CHECK(drag_along(x, eye, 0.3 * (place * x - eye)).value_or(0.0) == doctest::Approx(place)); // right at it
	}
	// Past the axis by 1 m: the closest point, by trying.
	const Eigen::Vector3d way = Eigen::Vector3d(6.0, 1.0, 0.0) - eye;
	const double found = drag_along(x, eye, way).value_or(0.0);
	const auto distance = [&](double p_place) {
		const Eigen::Vector3d to = p_place * x - eye;
		return (to - way * (to.dot(way) / way.squaredNorm())).norm();
	};
	CHECK(distance(found) < distance(found - 0.01));
	CHECK(distance(found) < distance(found + 0.01));
	CHECK_FALSE(drag_along(x, eye, x)); // along it
	CHECK_FALSE(drag_along(x, eye, eye)); // away from it
	CHECK_FALSE(drag_along(x, eye, Eigen::Vector3d::Constant(std::nan(""))));
}

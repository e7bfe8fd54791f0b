// SPDX-License-Identifier: MIT
// A rod that bends and twists and does not stretch, clamped at one end, under an even acceleration: where its tip is, by shooting.
// In double precision and without a chain, to hold the solver against.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <functional>

namespace grass::test {

// Of length 1. Its frame's columns are its tangent, its width and their normal.
struct KirchhoffRod {
	std::function<Eigen::Vector3d(double)> curvature; // at rest, about the frame's columns, by the place along the rod
	Eigen::Matrix3d clamp; // the frame at the root
	Eigen::Vector3d stiffness = Eigen::Vector3d::Ones(); // at the root, about the columns
	std::function<Eigen::Vector3d(double)> section; // factors on it along the rod
	std::function<double(double)> mass; // beyond a place
	Eigen::Vector3d load; // acceleration; a mass of 1 a length at the root

	struct State {
		Eigen::Vector3d place = Eigen::Vector3d::Zero(), moment;
		Eigen::Matrix3d frame;
	};
	State slope(double p_s, const State &p_y) const {
		const Eigen::Vector3d own = p_y.frame.transpose() * p_y.moment;
		const Eigen::Vector3d turn = p_y.frame * (curvature(p_s) + own.cwiseQuotient(stiffness.cwiseProduct(section(p_s))));
		State slope;
		slope.place = p_y.frame.col(0);
		slope.moment = load.cross(slope.place) * mass(p_s);
		for (int c = 0; c < 3; c++) {
			slope.frame.col(c) = turn.cross(p_y.frame.col(c));
		}
		return slope;
	}
	static State on(const State &p_y, const State &p_slope, double p_way) {
		State y;
		y.place = p_y.place + p_slope.place * p_way;
		y.moment = p_y.moment + p_slope.moment * p_way;
		y.frame = p_y.frame + p_slope.frame * p_way;
		return y;
	}
	// Returns the tip, where the moment at the root is p_moment.
	State shoot(const Eigen::Vector3d &p_moment) const {
		constexpr int STEPS = 400;
		constexpr double H = 1.0 / STEPS;
		State y;
		y.moment = p_moment;
		y.frame = clamp;
		for (int i = 0; i < STEPS; i++) { // Runge-Kutta, fourth order
			const double s = i * H;
			const State a = slope(s, y), b = slope(s + H / 2, on(y, a, H / 2)), c = slope(s + H / 2, on(y, b, H / 2)),
						d = slope(s + H, on(y, c, H));
			y = on(on(on(on(y, a, H / 6), b, H / 3), c, H / 3), d, H / 6);
		}
		return y;
	}
	// The moment at the tip is none. The load grows in steps, so that each start is near.
	Eigen::Vector3d tip() const {
		constexpr int LOADS = 40;
		KirchhoffRod rod = *this;
		Eigen::Vector3d moment = Eigen::Vector3d::Zero();
		for (int i = 1; i <= LOADS; i++) {
			rod.load = load * (double(i) / LOADS);
			for (int round = 0; round < 8; round++) { // Newton
				const Eigen::Vector3d found = rod.shoot(moment).moment;
				if (found.norm() < 1e-10) {
					break;
				}
				Eigen::Matrix3d change;
				for (int c = 0; c < 3; c++) {
					constexpr double SMALL = 1e-6;
					change.col(c) = (rod.shoot(moment + Eigen::Vector3d::Unit(c) * SMALL).moment - found) / SMALL;
				}
				moment -= change.inverse() * found;
			}
		}
		return rod.shoot(moment).place;
	}
};

// Returns a rod that rests as an arc towards x, by p_turn radians from root to tip, with the section that [Eq 44] and [Eq 45] give a blade.
inline KirchhoffRod leaf(double p_turn, double p_taper, double p_wide, const Eigen::Vector3d &p_load) {
	KirchhoffRod rod;
	rod.curvature = [p_turn](double) { return Eigen::Vector3d(0.0, -p_turn, 0.0); };
	rod.clamp.col(0) = Eigen::Vector3d::UnitY();
	rod.clamp.col(1) = Eigen::Vector3d::UnitZ();
	rod.clamp.col(2) = Eigen::Vector3d::UnitX();
	rod.section = [p_taper, p_wide](double p_s) {
		const double width = 1.0 - p_taper * p_s;
		return Eigen::Vector3d(width, width, width * (1.0 + (p_wide * p_wide - 1.0) * width * width));
	};
	rod.mass = [p_taper](double p_s) { return (1.0 - p_s) - 0.5 * p_taper * (1.0 - p_s * p_s); };
	rod.load = p_load;
	return rod;
}

} // namespace grass::test

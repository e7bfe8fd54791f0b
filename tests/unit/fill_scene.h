// SPDX-License-Identifier: MIT
// Rules on a square of 128 m, for their tests.
#pragma once

#include "core/fill/fill.h"

#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace grass::test {

inline constexpr double PI = std::numbers::pi;
inline constexpr double NAN_VALUE = std::numeric_limits<double>::quiet_NaN();

inline const MapRegion AREA{ { -64.0, -64.0 }, { 64.0, 64.0 } }; // four chunks

inline FillRule rule_of(std::initializer_list<std::pair<FillParamId, double>> p_params) {
	FillRule rule;
	for (const auto &[param, value] : p_params) {
		rule.params[size_t(param)] = value;
	}
	return rule;
}

inline FillResult fill_all(PaintMap &r_map, const FillRule &p_rule, const FillSources &p_sources = {}, const MapRegion &p_area = AREA) {
	return fill(r_map, chunks_in(p_area), p_area, &p_rule, p_sources);
}

// Square metres of full grass.
inline double filled(const FillRule &p_rule, const FillSources &p_sources = {}) {
	PaintMap map;
	return fill_all(map, p_rule, p_sources).amount;
}

inline FillSources sources_of(std::vector<FillObstacle> p_obstacles) {
	FillSources sources;
	for (const FillObstacle &obstacle : p_obstacles) {
		sources.obstacles.push_back(std::make_shared<const FillObstacle>(obstacle));
	}
	return sources;
}

// Ground of a height and a slope along x and z at each place.
inline void lay(PaintMap &r_map, const std::function<double(const Eigen::Vector2d &)> &p_height) {
	constexpr double STEP = 1e-4;
	for (int j = -70; j < 70; j++) {
		for (int i = -70; i < 70; i++) {
			const Eigen::Vector2d at(i + 0.5, j + 0.5);
			const auto slope = [&](const Eigen::Vector2d &p_way) {
				return (p_height(at + STEP * p_way) - p_height(at - STEP * p_way)) / (2.0 * STEP);
			};
			const Eigen::Vector3d normal = Eigen::Vector3d(-slope({ 1, 0 }), 1.0, -slope({ 0, 1 })).normalized();
			r_map.set_code(MAP_GROUND, 0, i, j, info_of(MAP_GROUND).code(p_height(at)));
			r_map.set_code(MAP_NORMAL, 0, i, j, info_of(MAP_NORMAL).code(normal.x()));
			r_map.set_code(MAP_NORMAL, 1, i, j, info_of(MAP_NORMAL).code(normal.z()));
		}
	}
}

inline ColliderShape shape_of(int p_type, const Eigen::Vector3d &p_size) {
	ColliderShape shape;
	shape.type = p_type;
	shape.size = p_size;
	return shape;
}

inline Eigen::Affine3d pose_of(const Eigen::Vector3d &p_at, double p_turn = 0.0, const Eigen::Vector3d &p_scale = Eigen::Vector3d::Ones()) {
	return Eigen::Translation3d(p_at) * Eigen::AngleAxisd(p_turn, Eigen::Vector3d::UnitY()) * Eigen::Scaling(p_scale);
}

inline double density_at(const PaintMap &p_map, double p_x, double p_z) {
	return p_map.sample(MAP_DENSITY, 0, { p_x, p_z });
}

} // namespace grass::test

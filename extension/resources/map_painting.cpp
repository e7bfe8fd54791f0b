// SPDX-License-Identifier: MIT
#include "resources/map_painting.h"

#include "core/paint/lay_ground.h"
#include "shared/convert.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Returns whether it can be used, and reports an error if not.
bool is_region(const GrassMap &p_map, const char *p_use, const Rect2 &p_region) {
	const String problem = problem_of_region(p_use, p_region);
	ERR_FAIL_COND_V_MSG(!problem.is_empty(), false, vformat("%s: %s", p_map.label(), problem));
	return true;
}

} // namespace

String problem_of_region(const char *p_use, const Rect2 &p_region) {
	if (!p_region.is_finite() || !p_region.has_area()) {
		return vformat("%s needs a region with a width and a depth, in metres.", p_use);
	}
	constexpr double REACH = PaintMap::REACH * MAP_CHUNK_SIZE, LARGEST = double(PaintMap::MAX_CHUNKS) * MAP_CHUNK_SIZE * MAP_CHUNK_SIZE;
	const Vector2 end = p_region.get_end();
	const bool is_within = p_region.position.x >= -REACH && p_region.position.y >= -REACH && end.x <= REACH && end.y <= REACH &&
			p_region.size.x * p_region.size.y <= LARGEST;
	return is_within ? String()
					 : vformat("the region of %s must lie within 16,384 m to each side and have at most %d square kilometres, the area "
							   "that a map can hold.",
							   p_use, int64_t(LARGEST * 1e-6));
}

bool set_ground(GrassMap &r_map, const Ref<Image> &p_heights, const Rect2 &p_region) {
	ERR_FAIL_COND_V_MSG(p_heights.is_null() || p_heights->is_empty(), false,
			vformat("%s: set_ground() needs an image of heights in metres, in its red channel.", r_map.label()));
	ERR_FAIL_COND_V_MSG(p_heights->is_compressed(), false,
			vformat("%s: set_ground() cannot read a compressed image. Call decompress() on it, or use FORMAT_RF.", r_map.label()));
	if (!is_region(r_map, "set_ground()", p_region)) {
		return false;
	}
	const int32_t width = p_heights->get_width(), depth = p_heights->get_height();
	const auto texel = [&](double p_i, double p_j) {
		return double(p_heights->get_pixel(int32_t(std::clamp(p_i, 0.0, width - 1.0)), int32_t(std::clamp(p_j, 0.0, depth - 1.0))).r);
	};
	const auto height = [&](const Eigen::Vector2d &p_place) {
		const Eigen::Array2d share = (p_place - to_eigen(p_region.position)).array() / to_eigen(p_region.size).array();
		const Eigen::Array2d at = share * Eigen::Array2d(width, depth) - 0.5, corner = at.floor(), t = at - corner;
		const double near_row = texel(corner.x(), corner.y()) * (1.0 - t.x()) + texel(corner.x() + 1.0, corner.y()) * t.x();
		const double far_row = texel(corner.x(), corner.y() + 1.0) * (1.0 - t.x()) + texel(corner.x() + 1.0, corner.y() + 1.0) * t.x();
		return near_row * (1.0 - t.y()) + far_row * t.y();
	};
	const MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	const bool is_finer =
			std::min(region.max.x() - region.min.x(), region.max.y() - region.min.y()) < GROUND_TEXEL * std::max(width, depth);
	const LedgeSearch search{ is_finer ? HeightAt(height) : nullptr };
	const LaidGround laid =
			r_map.change([&](PaintMap &r_changed) { return lay_ground(r_changed, region, height, MissingGround::STAYS, nullptr, search); });
	return laid.sampled > laid.missing;
}

String problem_of_stroke(const Ref<GrassBrush> &p_brush, const Vector2 &p_from, const Vector2 &p_to) {
	if (p_brush.is_null()) {
		return "a stroke needs a GrassBrush.";
	}
	if (!p_from.is_finite() || !p_to.is_finite()) {
		return "the ends of a stroke must be finite numbers.";
	}
	const double length = (to_eigen(p_to) - to_eigen(p_from)).norm();
	return length <= MapShape::MAX_EXTENT ? String()
										  : vformat("the ends of a stroke are %d m apart; at most %d m can be painted at once. Paint it in "
													"pieces.",
													int64_t(std::min(length, 1e15)), int64_t(MapShape::MAX_EXTENT));
}

double stroke(GrassMap &r_map, const Ref<GrassBrush> &p_brush, const Vector2 &p_from, const Vector2 &p_to) {
	return stroke_within(r_map, p_brush, p_from, p_to, Brush().area);
}

double stroke_within(GrassMap &r_map, const Ref<GrassBrush> &p_brush, const Vector2 &p_from, const Vector2 &p_to, const MapRegion &p_area) {
	const String problem = problem_of_stroke(p_brush, p_from, p_to);
	ERR_FAIL_COND_V_MSG(!problem.is_empty(), 0.0, vformat("%s: %s", r_map.label(), problem));
	const Eigen::Vector2d from = to_eigen(p_from), to = to_eigen(p_to);
	Brush brush = p_brush->get_brush(from, to);
	brush.area = p_area;
	return r_map.apply(p_brush->get_stroke(from, to), brush).amount;
}

double fill_map(GrassMap &r_map, const Ref<GrassFillRule> &p_rule, const Rect2 &p_region) {
	if (!is_region(r_map, "fill()", p_region)) {
		return 0.0;
	}
	const MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	const FillRule rule = p_rule.is_valid() ? p_rule->get_rule(region) : FillRule();
	const FillRule *asked = p_rule.is_valid() ? &rule : nullptr;
	return r_map.change([&](PaintMap &r_changed) { return fill(r_changed, chunks_in(region), region, asked, {}); }).amount;
}

} // namespace grass

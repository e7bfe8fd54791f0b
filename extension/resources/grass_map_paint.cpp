// SPDX-License-Identifier: MIT
// How scripts and the editor paint a GrassMap: strokes, ground, fills; and what it has at a place.
#include "resources/grass_map.h"

#include "shared/convert.h"

#include <algorithm>

using namespace godot;

namespace grass {

// Returns what is wrong with p_region, for p_use: it needs a size, and a place where a map can hold it. Empty: nothing.
String GrassMap::problem_of_region(const char *p_use, const Rect2 &p_region) const {
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

bool GrassMap::is_region(const char *p_use, const Rect2 &p_region) const {
	const String problem = problem_of_region(p_use, p_region);
	ERR_FAIL_COND_V_MSG(!problem.is_empty(), false, vformat("%s: %s", label(), problem));
	return true;
}

BrushResult GrassMap::apply(const MapShape &p_shape, const Brush &p_brush) {
	return change([&](PaintMap &r_map) { return apply_brush(r_map, p_shape, p_brush); });
}

bool GrassMap::set_ground(const Ref<Image> &p_heights, const Rect2 &p_region) {
	ERR_FAIL_COND_V_MSG(p_heights.is_null() || p_heights->is_empty(), false,
			vformat("%s: set_ground() needs an image of heights in metres, in its red channel.", label()));
	ERR_FAIL_COND_V_MSG(p_heights->is_compressed(), false,
			vformat("%s: set_ground() cannot read a compressed image. Call decompress() on it, or use FORMAT_RF.", label()));
	if (!is_region("set_ground()", p_region)) {
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
			change([&](PaintMap &r_map) { return lay_ground(r_map, region, height, MissingGround::STAYS, nullptr, search); });
	return laid.sampled > laid.missing;
}

String GrassMap::problem_of_stroke(const Ref<GrassBrush> &p_brush, const Vector2 &p_from, const Vector2 &p_to) {
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

double GrassMap::stroke(const Ref<GrassBrush> &p_brush, const Vector2 &p_from, const Vector2 &p_to) {
	return stroke_within(p_brush, p_from, p_to, Brush().area);
}

double GrassMap::stroke_within(const Ref<GrassBrush> &p_brush, const Vector2 &p_from, const Vector2 &p_to, const MapRegion &p_area) {
	const String problem = problem_of_stroke(p_brush, p_from, p_to);
	ERR_FAIL_COND_V_MSG(!problem.is_empty(), 0.0, vformat("%s: %s", label(), problem));
	const Eigen::Vector2d from = to_eigen(p_from), to = to_eigen(p_to);
	Brush brush = p_brush->get_brush(from, to);
	brush.area = p_area;
	return apply(p_brush->get_stroke(from, to), brush).amount;
}

double GrassMap::sample(Channel p_channel, const Vector2 &p_place, int64_t p_component) const {
	ERR_FAIL_INDEX_V_MSG(
			int64_t(p_channel), int(MAP_CHANNELS), 0.0, label() + String(": no such channel. Use one of the CHANNEL_* constants."));
	ERR_FAIL_INDEX_V_MSG(
			p_component, int64_t(info_of(MapChannel(p_channel)).components), 0.0, label() + String(": the channel has fewer components."));
	std::lock_guard lock(_lock);
	return _map.sample(MapChannel(p_channel), int(p_component), to_eigen(p_place));
}

double GrassMap::fill(const Ref<GrassFillRule> &p_rule, const Rect2 &p_region) {
	if (!is_region("fill()", p_region)) {
		return 0.0;
	}
	const MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	const FillRule rule = p_rule.is_valid() ? p_rule->get_rule(region) : FillRule();
	const FillRule *asked = p_rule.is_valid() ? &rule : nullptr;
	return change([&](PaintMap &r_map) { return grass::fill(r_map, chunks_in(region), region, asked, {}); }).amount;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "core/field/bare_cause.h"

#include "core/paint/hand_paint.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

// Difference in codes between a rule's result and the map up to which the rule still counts as the cause: neighbours blend, and filling may
// be some frames late.
constexpr int32_t SAME = 4;

BareCause density_cause(const PaintMap &p_map, const FillRule *p_rule, const FillSources &p_sources, const Eigen::Vector2d &p_at) {
	constexpr const MapChannelInfo &INFO = info_of(MAP_DENSITY);
	const Eigen::Array2i texel = (p_at.array() / INFO.texel_size()).floor().cast<int>();
	const auto code = [&](MapChannel p_channel, int p_component) { return p_map.get_code(p_channel, p_component, texel.x(), texel.y()); };
	const int32_t density = code(MAP_DENSITY, 0);
	const HandPaint hand{ code(MAP_PAINT, 0), code(MAP_PAINT, 1) };
	BareCause cause{ BareKind::MAP, INFO.value(density), 0.0, {} };
	if (2 * hand.cover > HandPaint::FULL) {
		cause.kind = BareKind::PAINTED;
	} else if (p_rule != nullptr) {
		cause.rule = find_fill_cause(p_map, *p_rule, p_sources, p_at);
		const bool is_rule = !p_rule->only_at_obstacles || cause.rule.condition == FillCondition::OBSTACLE;
		if (is_rule && std::abs(hand.over(INFO.code(cause.rule.density)) - density) <= SAME) {
			cause.kind = BareKind::RULE;
		}
	}
	return cause;
}

} // namespace

BareCause find_bare_cause(
		const PaintMap &p_map, const FillRule *p_rule, const FillSources &p_sources, const Eigen::Vector2d &p_at, double p_height) {
	BareCause least;
	if (p_map.sample(MAP_HOLE, 0, p_at) != 0.0) {
		return { BareKind::HOLE, 0.0, 0.0, {} };
	}
	if (p_map.sample(MAP_LEDGE, 0, p_at) == 0.0) {
		return { BareKind::LEDGE, 0.0, 0.0, {} };
	}
	const auto weigh = [&least](const BareCause &p_cause) {
		if (p_cause.share < least.share) {
			least = p_cause;
		}
	};
	const double wear = p_map.sample(MAP_WEAR, 0, p_at), cut = p_map.sample(MAP_CUT, 0, p_at);
	weigh(density_cause(p_map, p_rule, p_sources, p_at));
	weigh({ BareKind::WORN, 1.0 - wear * wear, 0.0, {} });
	weigh({ BareKind::SHORT, p_map.sample(MAP_HEIGHT, 0, p_at), 0.0, {} });
	weigh({ BareKind::CUT, cut < MAP_UNCUT && p_height > 0.0 ? std::min(1.0, cut / p_height) : 1.0, cut, {} });
	return least;
}

} // namespace grass

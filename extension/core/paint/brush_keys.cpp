// SPDX-License-Identifier: MIT
#include "core/paint/brush_keys.h"

namespace grass {

namespace {

constexpr double GROWTH = 1.15; // factor on a radius for each notch
constexpr double STEPS = 5.0; // steps for each notch, for all other numbers

} // namespace

Brush opposite_of(const Brush &p_brush) {
	Brush brush = p_brush;
	switch (p_brush.tool) {
		case MapTool::PAINT:
		case MapTool::DENSITY:
			brush.tool = MapTool::ERASE;
			break;
		case MapTool::ERASE:
			brush.tool = MapTool::PAINT;
			brush.target = 1.0;
			break;
		case MapTool::HEIGHT:
			brush.target = info_of(MAP_HEIGHT).value(info_of(MAP_HEIGHT).initial[0]);
			break;
		case MapTool::SPECIES:
		case MapTool::TINT:
		case MapTool::COMB:
			brush.target = 0.0;
			break;
		case MapTool::CUT:
			brush.tool = MapTool::REGROW;
			brush.target = MAP_UNCUT;
			break;
		case MapTool::REGROW:
			brush.tool = MapTool::CUT;
			break;
		case MapTool::FLATTEN:
			brush.tool = MapTool::RECOVER;
			brush.target = 1.0;
			break;
		case MapTool::RECOVER:
			brush.tool = MapTool::FLATTEN;
			break;
		case MapTool::SMOOTH:
		case MapTool::COUNT:
			break;
	}
	return brush;
}

Brush smoothing_of(const Brush &p_brush) {
	const MapChannel channel = channel_of(p_brush);
	Brush brush = p_brush;
	if (info_of(channel).blends) {
		brush.tool = MapTool::SMOOTH;
		brush.channel = channel;
	}
	return brush;
}

double nudged(const Tunable &p_tunable, double p_value, int p_notches) {
	const double value = p_tunable.clamp(p_value);
	double next = value + STEPS * p_tunable.step * p_notches;
	if (p_tunable.minimum > 0.0) {
		const double least = value + p_tunable.step * p_notches; // small values must change too
		next = value * std::pow(GROWTH, p_notches);
		next = p_notches > 0 ? std::max(next, least) : std::min(next, least);
	}
	return p_tunable.clamp(std::round(next / p_tunable.step) * p_tunable.step);
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "core/paint/brush.h"

#include "core/base/hash.h"
#include "core/paint/changed_texels.h"
#include "core/paint/fine_wear.h"
#include "core/paint/hand_paint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace grass {

namespace {

using Codes = std::array<int32_t, 4>; // of a texel's components; for wear, the second is MAP_WEAR_REST

// Returns the texel's random number, 0 <= h < 1.
double texel_hash(int p_i, int p_j) {
	return double(grass_hash(uint32_t(p_i) ^ grass_hash(uint32_t(p_j)))) / 4294967296.0;
}

// One step of a brush on one channel.
class Dab {
public:
	Dab(const PaintMap &p_map, const Brush &p_brush) :
			_brush(p_brush),
			_channel(channel_of(p_brush)),
			_info(info_of(_channel)),
			_texels(p_map, _channel),
			_paint(p_map, MAP_PAINT),
			_rest(p_map, MAP_WEAR_REST) {
		const Eigen::Vector2d direction = p_brush.direction.stableNormalized();
		_target.fill(_info.code(p_brush.target));
		if (p_brush.tool == MapTool::COMB) {
			_target = { _info.code(direction.x() * p_brush.target), _info.code(direction.y() * p_brush.target), 0, 0 };
		} else if (p_brush.tool == MapTool::TINT) {
			for (int c = 0; c < 3; c++) {
				_target[size_t(c)] = _info.code(p_brush.color[c]);
			}
		}
	}

	Codes read(int p_i, int p_j) {
		Codes codes{};
		for (int c = 0; c < _info.components; c++) {
			codes[size_t(c)] = _texels.code(c, p_i, p_j);
		}
		codes[1] = wears() ? _rest.code(0, p_i, p_j) : codes[1];
		return codes;
	}

	// Returns what the texel holds after the step.
	Codes changed(const Codes &p_now, int p_i, int p_j, double p_weight) {
		Codes codes = p_now;
		switch (_brush.tool) {
			case MapTool::SPECIES:
				codes[0] = texel_hash(p_i, p_j) < p_weight ? _target[0] : p_now[0];
				break;
			case MapTool::TINT:
				for (size_t c = 0; c < 3; c++) { // a colour that was not visible leaves no trace
					codes[c] = p_now[3] == 0 ? _target[c] : toward(p_now[c], _target[c], p_weight);
				}
				codes[3] = toward(p_now[3], _target[3], p_weight);
				break;
			case MapTool::CUT:
				codes[0] = p_weight >= 0.5 * std::min(_brush.strength, 1.0) ? std::min(p_now[0], _target[0]) : p_now[0];
				break;
			case MapTool::REGROW:
				codes[0] = p_now[0] + grown(p_weight);
				break;
			case MapTool::FLATTEN:
				return codes_of(FineWear::of_codes(p_now[0], p_now[1]).raised(_target[0], p_weight));
			case MapTool::RECOVER:
				return codes_of(FineWear::of_codes(p_now[0], p_now[1]).lowered(p_weight * _target[0]));
			default:
				for (int c = 0; c < _info.components; c++) {
					codes[size_t(c)] = toward(p_now[size_t(c)], aim(p_now, c, p_i, p_j), p_weight);
				}
		}
		for (int c = 0; c < _info.components; c++) {
			codes[size_t(c)] = std::clamp(codes[size_t(c)], _info.lowest, _info.highest);
		}
		return codes;
	}

	// Returns the weight of a texel. A boot has its full effect wherever it is on the grid, since each texel counts its most trodden point.
	double weight_at(const MapShape &p_shape, const Eigen::Vector2d &p_centre) const {
		return _brush.tool == MapTool::FLATTEN ? p_shape.get_most_weight(p_centre, 0.5 * _info.texel_size()) : p_shape.get_weight(p_centre);
	}

	bool wears() const { return _channel == MAP_WEAR; }
	bool paints() const { return _channel == MAP_DENSITY; }
	HandPaint read_paint(int p_i, int p_j) {
		return paints() ? HandPaint{ _paint.code(0, p_i, p_j), _paint.code(1, p_i, p_j) } : HandPaint();
	}
	// Returns the paint by hand after a step: it records what the brush changed, and also what it met and left unchanged.
	HandPaint painted(const HandPaint &p_paint, const Codes &p_now, int p_i, int p_j, double p_weight) {
		return paints() ? p_paint.brushed(aim(p_now, 0, p_i, p_j), p_weight) : p_paint;
	}

	MapChannel channel() const { return _channel; }

private:
	// Returns the code that the step moves towards.
	int32_t aim(const Codes &p_now, int p_component, int p_i, int p_j) {
		const size_t c = size_t(p_component);
		switch (_brush.tool) {
			case MapTool::PAINT:
				return std::max(p_now[c], _target[c]);
			case MapTool::ERASE:
				return 0;
			case MapTool::SMOOTH:
				return mean(p_component, p_i, p_j);
			default: // DENSITY, HEIGHT, COMB
				return _target[c];
		}
	}

	// Returns the mean of the 3 x 3 texels around, weighted 1 2 1 along both axes.
	int32_t mean(int p_component, int p_i, int p_j) {
		double sum = 0.0;
		for (int dj = -1; dj <= 1; dj++) {
			for (int di = -1; di <= 1; di++) {
				sum += double((2 - std::abs(di)) * (2 - std::abs(dj))) * _texels.code(p_component, p_i + di, p_j + dj);
			}
		}
		return int32_t(std::round(sum / 16.0));
	}

	static Codes codes_of(const FineWear &p_wear) { return { p_wear.wear(), p_wear.rest() }; }
	int32_t grown(double p_weight) const { return int32_t(std::round(p_weight * (_target[0] - _info.zero))); }

	const Brush &_brush;
	MapChannel _channel;
	const MapChannelInfo &_info;
	MapReader _texels, _paint, _rest;
	Codes _target{};
};

struct Edit {
	int i, j;
	Codes before, after;
	HandPaint paint; // only for density
};

} // namespace

bool MapLimits::allows(MapReader &r_ground, MapReader &r_normal, const Eigen::Vector2d &p_place) const {
	if (is_everywhere()) {
		return true;
	}
	const double height = r_ground.sample(0, p_place);
	const double tilt = std::min(1.0, std::hypot(r_normal.sample(0, p_place), r_normal.sample(1, p_place))); // sine of the slope
	const double slope = std::asin(tilt) * 180.0 / std::numbers::pi;
	return height >= height_min && height <= height_max && slope >= slope_min && slope <= slope_max;
}

MapChannel channel_of(const Brush &p_brush) {
	switch (p_brush.tool) {
		case MapTool::SMOOTH:
			return p_brush.channel;
		case MapTool::HEIGHT:
			return MAP_HEIGHT;
		case MapTool::SPECIES:
			return MAP_SPECIES;
		case MapTool::TINT:
			return MAP_TINT;
		case MapTool::COMB:
			return MAP_LEAN;
		case MapTool::CUT:
		case MapTool::REGROW:
			return MAP_CUT;
		case MapTool::FLATTEN:
		case MapTool::RECOVER:
			return MAP_WEAR;
		default:
			return MAP_DENSITY;
	}
}

BrushResult apply_brush(PaintMap &r_map, const MapShape &p_shape, const Brush &p_brush) {
	BrushResult result;
	const double strength = std::clamp(p_brush.strength, 0.0, 1.0);
	if (p_shape.is_empty() || !(strength > 0.0)) {
		return result;
	}
	Dab dab(r_map, p_brush);
	MapReader ground(r_map, MAP_GROUND), normal(r_map, MAP_NORMAL);
	const MapChannelInfo &info = info_of(dab.channel());
	const double size = info.texel_size(), reach = PaintMap::REACH * double(info.side);
	// The texels that the shape may contain. All are read before any is written, so that their order does not matter.
	const Eigen::Array2d min = p_shape.get_min().array().max(p_brush.area.min.array()),
						 max = p_shape.get_max().array().min(p_brush.area.max.array());
	const Eigen::Array2d low = (min / size).floor(), high = (max / size).ceil() - 1.0;
	result.out_of_room = (low < -reach).any() || (high >= reach).any();
	const Eigen::Array2i first = low.max(-reach).min(reach).cast<int>(), last = high.max(-reach - 1.0).min(reach - 1.0).cast<int>();
	std::vector<Edit> edits;
	for (int j = first.y(); j <= last.y(); j++) {
		for (int i = first.x(); i <= last.x(); i++) {
			const Eigen::Vector2d centre((i + 0.5) * size, (j + 0.5) * size);
			const double weight = strength * dab.weight_at(p_shape, centre);
			if (weight > 0.0 && p_brush.limits.allows(ground, normal, centre)) {
				const Codes now = dab.read(i, j), after = dab.changed(now, i, j, weight);
				const HandPaint paint_now = dab.read_paint(i, j), paint = dab.painted(paint_now, now, i, j, weight);
				if (after != now || !(paint == paint_now)) {
					edits.push_back({ i, j, now, after, paint });
				}
			}
		}
	}
	ChangedTexels changed(dab.channel());
	for (const Edit &edit : edits) {
		bool written = true;
		for (int c = 0; c < info.components && written; c++) {
			written = r_map.set_code(dab.channel(), c, edit.i, edit.j, edit.after[size_t(c)]);
		}
		if (written && dab.wears()) {
			written = r_map.set_code(MAP_WEAR_REST, 0, edit.i, edit.j, edit.after[1]);
		}
		if (written && dab.paints()) {
			written = r_map.set_code(MAP_PAINT, 0, edit.i, edit.j, edit.paint.density) &&
					r_map.set_code(MAP_PAINT, 1, edit.i, edit.j, edit.paint.cover);
		}
		result.out_of_room = result.out_of_room || !written;
		if (written) {
			const double rest = dab.wears() ? double(edit.after[1] - edit.before[1]) / FineWear::PARTS : 0.0;
			result.amount += (edit.after[0] - edit.before[0] + rest) * info.unit * size * size;
			changed.add(edit.i, edit.j);
		}
	}
	changed.report(result);
	return result;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "core/paint/lay_ground.h"

#include "core/paint/changed_texels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace grass {

namespace {

constexpr double GROUND_TEXEL = info_of(MAP_GROUND).texel_size();
static_assert(GROUND_TEXEL == info_of(MAP_NORMAL).texel_size() && GROUND_TEXEL == info_of(MAP_HOLE).texel_size());

// Heights of a block of texels, a border of one texel around it included.
class Heights {
public:
	Heights(const Eigen::Array2i &p_first, const Eigen::Array2i &p_last, const HeightAt &p_height) :
			_first(p_first - 1), _width(p_last.x() - p_first.x() + 3) {
		for (int j = _first.y(); j <= p_last.y() + 1; j++) {
			for (int i = _first.x(); i <= p_last.x() + 1; i++) {
				_heights.push_back(p_height({ (i + 0.5) * GROUND_TEXEL, (j + 0.5) * GROUND_TEXEL }));
			}
		}
	}
	double at(int p_i, int p_j) const { return _heights[size_t(p_j - _first.y()) * size_t(_width) + size_t(p_i - _first.x())]; }
	int64_t count() const { return int64_t(_heights.size()); }

	// The mean of those beside a texel; not finite where there is none.
	double beside(int p_i, int p_j) const {
		double sum = 0.0;
		int count = 0;
		for (int j = p_j - 1; j <= p_j + 1; j++) {
			for (int i = p_i - 1; i <= p_i + 1; i++) {
				const double height = at(i, j);
				sum += std::isfinite(height) ? height : 0.0;
				count += std::isfinite(height) ? 1 : 0;
			}
		}
		return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
	}

	Eigen::Vector3d normal(int p_i, int p_j) const {
		const auto slope = [&](int p_di, int p_dj) {
			const double ahead = at(p_i + p_di, p_j + p_dj), behind = at(p_i - p_di, p_j - p_dj), here = at(p_i, p_j);
			const int sides = (std::isfinite(ahead) ? 1 : 0) + (std::isfinite(behind) ? 1 : 0);
			return sides == 0 ? 0.0
							  : ((std::isfinite(ahead) ? ahead : here) - (std::isfinite(behind) ? behind : here)) / (sides * GROUND_TEXEL);
		};
		return Eigen::Vector3d(-slope(1, 0), 1.0, -slope(0, 1)).normalized();
	}

private:
	Eigen::Array2i _first;
	int _width;
	std::vector<double> _heights;
};

// Writes a texel's channels and remembers what changed.
class GroundWriter {
public:
	GroundWriter(PaintMap &r_map, LaidGround &r_result) : _map(r_map), _result(r_result), _changed(MAP_GROUND) {}

	void lay(int p_i, int p_j, double p_height, const Eigen::Vector3d &p_normal) {
		bool differs = write(MAP_GROUND, 0, p_i, p_j, info_of(MAP_GROUND).code(p_height));
		differs = write(MAP_NORMAL, 0, p_i, p_j, info_of(MAP_NORMAL).code(p_normal.x())) || differs;
		differs = write(MAP_NORMAL, 1, p_i, p_j, info_of(MAP_NORMAL).code(p_normal.z())) || differs;
		differs = write(MAP_HOLE, 0, p_i, p_j, 0) || differs;
		note(differs, p_i, p_j);
	}
	// p_rim: height of the ground beside it, which blades at its rim would else leave for 0.
	void open(int p_i, int p_j, double p_rim) {
		bool differs = std::isfinite(p_rim) && write(MAP_GROUND, 0, p_i, p_j, info_of(MAP_GROUND).code(p_rim));
		differs = write(MAP_HOLE, 0, p_i, p_j, 1) || differs;
		note(differs, p_i, p_j);
	}
	void report() { _changed.report(_result); }

private:
	bool write(MapChannel p_channel, int p_component, int p_i, int p_j, int32_t p_code) {
		if (_map.get_code(p_channel, p_component, p_i, p_j) == p_code) {
			return false;
		}
		const bool written = _map.set_code(p_channel, p_component, p_i, p_j, p_code);
		_result.out_of_room = _result.out_of_room || !written;
		return written;
	}
	void note(bool p_differs, int p_i, int p_j) {
		if (p_differs) {
			_changed.add(p_i, p_j);
		}
	}

	PaintMap &_map;
	LaidGround &_result;
	ChangedTexels _changed;
};

} // namespace

LaidGround lay_ground(
		PaintMap &r_map, const MapRegion &p_region, const HeightAt &p_height, MissingGround p_missing, const NormalAt &p_normal) {
	LaidGround result;
	const double reach = PaintMap::REACH * double(info_of(MAP_GROUND).side);
	const Eigen::Array2d low = (p_region.min.array() / GROUND_TEXEL - 0.5).ceil(),
						 high = (p_region.max.array() / GROUND_TEXEL - 0.5).floor();
	if (!low.allFinite() || !high.allFinite() || (low > high).any()) {
		return result;
	}
	result.out_of_room = (low < -reach).any() || (high >= reach).any();
	const Eigen::Array2i first = low.max(-reach).min(reach).cast<int>(), last = high.max(-reach - 1.0).min(reach - 1.0).cast<int>();
	if ((first > last).any()) {
		return result;
	}
	const Heights heights(first, last, p_height);
	result.sampled = heights.count();
	GroundWriter writer(r_map, result);
	for (int j = first.y(); j <= last.y(); j++) {
		for (int i = first.x(); i <= last.x(); i++) {
			if (!std::isfinite(heights.at(i, j))) {
				result.missing++;
				if (p_missing == MissingGround::HOLE) {
					writer.open(i, j, heights.beside(i, j));
				}
				continue;
			}
			const Eigen::Vector3d given =
					p_normal ? p_normal({ (i + 0.5) * GROUND_TEXEL, (j + 0.5) * GROUND_TEXEL }).normalized() : Eigen::Vector3d::Zero();
			const bool is_given = given.allFinite() && given.y() > 0.0;
			writer.lay(i, j, heights.at(i, j), is_given ? given : heights.normal(i, j));
		}
	}
	writer.report();
	return result;
}

} // namespace grass

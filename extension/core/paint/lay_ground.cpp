// SPDX-License-Identifier: MIT
#include "core/paint/lay_ground.h"

#include "core/paint/changed_texels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace grass {

namespace {

constexpr double GROUND_TEXEL = info_of(MAP_GROUND).texel_size();
static_assert(GROUND_TEXEL == info_of(MAP_NORMAL).texel_size());

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

} // namespace

LaidGround lay_ground(PaintMap &r_map, const MapRegion &p_region, const HeightAt &p_height) {
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
	ChangedTexels changed(MAP_GROUND);
	for (int j = first.y(); j <= last.y(); j++) {
		for (int i = first.x(); i <= last.x(); i++) {
			if (!std::isfinite(heights.at(i, j))) {
				result.missing++;
				continue;
			}
			const Eigen::Vector3d normal = heights.normal(i, j);
			const int32_t codes[] = { info_of(MAP_GROUND).code(heights.at(i, j)), info_of(MAP_NORMAL).code(normal.x()),
				info_of(MAP_NORMAL).code(normal.z()) };
			bool differs = false;
			for (int n = 0; n < 3; n++) {
				const MapChannel channel = n == 0 ? MAP_GROUND : MAP_NORMAL;
				const int component = n == 2 ? 1 : 0;
				if (r_map.get_code(channel, component, i, j) != codes[n]) {
					const bool written = r_map.set_code(channel, component, i, j, codes[n]);
					result.out_of_room = result.out_of_room || !written;
					differs = differs || written;
				}
			}
			if (differs) {
				changed.add(i, j);
			}
		}
	}
	changed.report(result);
	return result;
}

} // namespace grass

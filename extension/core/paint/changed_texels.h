// SPDX-License-Identifier: MIT
// Collects the texels that a tool has changed, as a BrushResult reports them: by chunk, and by the rectangle around them.
#pragma once

#include "core/paint/brush.h"

#include <limits>
#include <set>

namespace grass {

class ChangedTexels {
public:
	explicit ChangedTexels(MapChannel p_channel) : _channel(p_channel) {}

	void add(int p_i, int p_j) {
		_chunks.insert(key_of(_channel, p_i, p_j));
		_low = _low.min(Eigen::Array2i(p_i, p_j));
		_high = _high.max(Eigen::Array2i(p_i + 1, p_j + 1));
	}
	void report(BrushResult &r_result) const {
		r_result.changed.assign(_chunks.begin(), _chunks.end());
		if (!_chunks.empty()) {
			r_result.min = _low.cast<double>() * info_of(_channel).texel_size();
			r_result.max = _high.cast<double>() * info_of(_channel).texel_size();
		}
	}

private:
	MapChannel _channel;
	std::set<MapKey> _chunks;
	Eigen::Array2i _low = Eigen::Array2i::Constant(std::numeric_limits<int>::max());
	Eigen::Array2i _high = Eigen::Array2i::Constant(std::numeric_limits<int>::min());
};

} // namespace grass

// SPDX-License-Identifier: MIT
// Places at which the ground is read, and how many more may be.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <limits>

namespace grass {

// Height of the ground at a place (x, z in metres), metres above the field; not finite where there is none.
using HeightAt = std::function<double(const Eigen::Vector2d &p_place)>;

class GroundPlaces {
public:
	static constexpr int64_t ALL = std::numeric_limits<int64_t>::max();

	// p_texel: heights at the centres of texels. p_between: anywhere; null where the ground is one sheet. Both are called for places
	// p_offset metres from those that are passed. p_most: places.
	GroundPlaces(const HeightAt &p_texel, const HeightAt &p_between, const Eigen::Vector2d &p_offset, int64_t p_most) :
			_texel(p_texel), _between(p_between), _offset(p_offset), _most(p_most) {}

	bool has(int64_t p_places) const { return _most - _read >= p_places; }
	int64_t get_read() const { return _read; }
	double texel(const Eigen::Vector2d &p_place) {
		_read++;
		return _texel(p_place + _offset);
	}
	double between(const Eigen::Vector2d &p_place) {
		_read++;
		return _between(p_place + _offset);
	}

private:
	const HeightAt &_texel, &_between;
	Eigen::Vector2d _offset;
	int64_t _most, _read = 0;
};

} // namespace grass

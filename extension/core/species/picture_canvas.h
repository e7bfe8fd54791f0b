// SPDX-License-Identifier: MIT
// What small pictures for the editor are drawn on: finer than the picture, which smooths edges.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace grass {

inline float from_srgb(uint8_t p_byte) {
	return std::pow(float(p_byte) / 255.0f, 2.2f);
}

inline uint8_t to_srgb(float p_value) {
	return uint8_t(std::lround(255.0f * std::pow(std::clamp(p_value, 0.0f, 1.0f), 1.0f / 2.2f)));
}

class PictureCanvas {
public:
	static constexpr int FINER = 2; // drawn texels for each texel of the picture, along a side

	explicit PictureCanvas(int p_side) : _side(FINER * p_side), _texels(size_t(_side) * size_t(_side), Eigen::Vector4f::Zero()) {}

	int get_side() const { return _side; }

	void put(int p_x, int p_y, const Eigen::Vector3f &p_color) {
		if (p_x >= 0 && p_x < _side && p_y >= 0 && p_y < _side) {
			_texels[size_t(p_y) * size_t(_side) + size_t(p_x)] << p_color, 1.0f;
		}
	}

	void put_disc(const Eigen::Vector2f &p_middle, float p_radius, const Eigen::Vector3f &p_color) {
		const int reach = int(std::ceil(p_radius));
		const int x = int(std::floor(p_middle.x())), y = int(std::floor(p_middle.y()));
		put(x, y, p_color);
		for (int dy = -reach; dy <= reach; dy++) {
			for (int dx = -reach; dx <= reach; dx++) {
				const Eigen::Vector2f texel(float(x + dx) + 0.5f, float(y + dy) + 0.5f);
				if ((texel - p_middle).norm() <= p_radius) {
					put(x + dx, y + dy, p_color);
				}
			}
		}
	}

	// Returns the picture: each texel is the mean of FINER x FINER.
	std::vector<uint8_t> shrunk() const {
		std::vector<uint8_t> bytes;
		for (int y = 0; y < _side; y += FINER) {
			for (int x = 0; x < _side; x += FINER) {
				Eigen::Vector4f sum = Eigen::Vector4f::Zero();
				for (int i = 0; i < FINER * FINER; i++) {
					sum += _texels[size_t(y + i / FINER) * size_t(_side) + size_t(x + i % FINER)];
				}
				const Eigen::Vector3f color = sum.head<3>() / std::max(sum.w(), 1.0f);
				const float alpha = sum.w() / float(FINER * FINER);
				bytes.insert(
						bytes.end(), { to_srgb(color.x()), to_srgb(color.y()), to_srgb(color.z()), uint8_t(std::lround(255.0f * alpha)) });
			}
		}
		return bytes;
	}

private:
	int _side;
	std::vector<Eigen::Vector4f> _texels; // linear colour, and 1 where anything is drawn
};

} // namespace grass

// SPDX-License-Identifier: MIT
// The terrain's colours as a picture that spans the field. Roots of blades, soil and distant grass use it.
#pragma once

#include "core/map/map_layers.h"

namespace grass {

struct TerrainColor {
	uint8_t red = 255, green = 255, blue = 255; // sRGB
	uint8_t alpha = 0; // weight of this colour; 0: none reported, grass keeps its own

	// Makes a colour of components 0..1, clamped. If one is not a number, the result is no colour.
	static TerrainColor of(double p_red, double p_green, double p_blue, double p_alpha);
	bool operator==(const TerrainColor &) const = default;
};

class TerrainColors {
public:
	static constexpr int LARGEST = 2048; // texels along a side; larger fields show larger texels

	// Sets the area that it spans, metres. Clears all colours.
	void set_area(const MapRegion &p_area);
	void clear();
	// Sets the colour of the square metre around a place (x, z in metres); ignores places outside the area.
	void set(const Eigen::Vector2d &p_place, const TerrainColor &p_color);

	int get_width() const { return _size.x(); }
	int get_depth() const { return _size.y(); }
	std::span<const TerrainColor> get_texels() const { return _texels; } // row by row along x
	bool take_changed() { return std::exchange(_has_changed, false); } // whether it changed since the last call
	size_t get_memory_usage() const { return _texels.size() * sizeof(TerrainColor); } // bytes

private:
	MapRegion _area;
	Eigen::Array2i _size = Eigen::Array2i::Zero();
	std::vector<TerrainColor> _texels;
	bool _has_changed = false;
};

} // namespace grass

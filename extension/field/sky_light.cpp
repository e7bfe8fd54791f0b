// SPDX-License-Identifier: MIT
#include "field/sky_light.h"

#include <godot_cpp/classes/texture2d.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace godot;

namespace grass {

namespace {
constexpr int COARSE_ROWS = 8, COLUMNS = 8; // as coarse as what the renderer gathers light from
constexpr int ROWS = 8 * COARSE_ROWS; // from the zenith to the nadir
constexpr int RINGS = 32; // of equal weight for level ground
constexpr double CURVE = 0.6; // the engine's exponent over 1 / sky_curve

Color scaled(const Color &p_color, double p_factor) {
	return Color(p_color.r * float(p_factor), p_color.g * float(p_factor), p_color.b * float(p_factor), p_color.a);
}
} // namespace

Color SkyLight::Half::color_at(double p_height) const {
	return end.lerp(horizon, float(std::pow(1.0 - p_height, exponent)));
}

SkyLight::SkyLight(const Ref<Material> &p_material) {
	if (p_material.is_null()) {
		return;
	}
	if (p_material->is_class("ProceduralSkyMaterial")) {
		_sky = _read_half(**p_material, "sky_", "top_color");
		_ground = _read_half(**p_material, "ground_", "bottom_color");
		_read_picture(p_material->get("sky_cover"));
		_picture_rows = ROWS / 2;
		_picture_light = p_material->get("sky_cover_modulate");
		_picture_light.a *= float(p_material->get("sky_energy_multiplier"));
		_energy = p_material->get("energy_multiplier");
	} else if (p_material->is_class("PanoramaSkyMaterial")) {
		_read_picture(p_material->get("panorama"));
		_picture_rows = ROWS;
		_energy = p_material->get("energy_multiplier");
		if (_picture.is_valid()) {
			_picture->convert(Image::FORMAT_RGB8); // the renderer takes no heed of its alpha
		}
	}
}

SkyLight::Half SkyLight::_read_half(const Material &p_material, const String &p_prefix, const String &p_end) {
	const double energy = p_material.get(p_prefix + String("energy_multiplier"));
	const double curve = p_material.get(p_prefix + String("curve"));
	return { scaled(p_material.get(p_prefix + p_end), energy), scaled(p_material.get(p_prefix + String("horizon_color")), energy),
		CURVE / std::max(curve, 1e-3) };
}

void SkyLight::_read_picture(const Variant &p_texture) {
	const Ref<Texture2D> texture = p_texture;
	const Ref<Image> image = texture.is_valid() ? texture->get_image() : Ref<Image>();
	const bool is_read = image.is_valid() && image->get_format() <= Image::FORMAT_RGBA8;
	if (is_read) {
		_picture = image->duplicate();
		_picture->resize(COLUMNS, ROWS, Image::INTERPOLATE_LANCZOS);
	}
	_is_known = is_read || texture.is_null();
}

Color SkyLight::_color_at(int p_row, int p_column) const {
	const double height = std::cos(std::numbers::pi * (p_row + 0.5) / ROWS);
	const Color clear = height > 0.0 ? _sky.color_at(height) : _ground.color_at(-height);
	if (_picture.is_null() || p_row >= _picture_rows) {
		return clear;
	}
	const Color seen = _picture->get_pixel(p_column, p_row);
	return clear + scaled(seen * _picture_light, seen.a * _picture_light.a);
}

Color SkyLight::_coarse_color_at(int p_row, int p_column, double p_energy) const {
	constexpr int EACH = ROWS / COARSE_ROWS;
	Color sum(0.0f, 0.0f, 0.0f);
	for (int row = p_row * EACH; row < (p_row + 1) * EACH; row++) {
		const Color color = scaled(_color_at(row, p_column), _energy * p_energy);
		sum += Color(std::min(color.r, 1.0f), std::min(color.g, 1.0f), std::min(color.b, 1.0f));
	}
	return scaled(sum, 1.0 / EACH);
}

Color SkyLight::find(double p_energy) const {
	Color sum(0.0f, 0.0f, 0.0f);
	for (int column = 0; column < COLUMNS; column++) {
		std::array<Color, COARSE_ROWS> colors;
		for (int row = 0; row < COARSE_ROWS; row++) {
			colors[row] = _coarse_color_at(row, column, p_energy);
		}
		for (int ring = 0; ring < RINGS; ring++) {
			const double angle = std::acos(std::sqrt((ring + 0.5) / RINGS)); // from the zenith
			const double place = std::max(angle / std::numbers::pi * COARSE_ROWS - 0.5, 0.0);
			const int row = int(place);
			sum += colors[row].lerp(colors[row + 1], float(place - row)).srgb_to_linear();
		}
	}
	return scaled(sum, 1.0 / (RINGS * COLUMNS));
}

} // namespace grass

// SPDX-License-Identifier: MIT
// The light of the Compatibility renderer's sky on level ground, computed from its material.
#pragma once

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/variant/color.hpp>

namespace grass {

// The renderer mixes and scales the colours of a sky in sRGB, keeps nothing above 1, and gathers their light from a coarse picture.
class SkyLight {
public:
	// Reads a ProceduralSkyMaterial or a PanoramaSkyMaterial.
	explicit SkyLight(const godot::Ref<godot::Material> &p_material);

	// Returns whether the material is one of these, and its picture could be read.
	bool is_known() const { return _is_known; }
	// Returns the light in linear colours, without that of suns in the sky; black for any other material. p_energy: the environment's.
	godot::Color find(double p_energy) const;

private:
	// The colours above or below the horizon.
	struct Half {
		godot::Color end{ 0.0f, 0.0f, 0.0f }, horizon{ 0.0f, 0.0f, 0.0f };
		double exponent = 1.0;

		godot::Color color_at(double p_height) const; // the sine of the angle from the horizon
	};

	static Half _read_half(const godot::Material &p_material, const godot::String &p_prefix, const godot::String &p_end);
	void _read_picture(const godot::Variant &p_texture);
	godot::Color _color_at(int p_row, int p_column) const;
	godot::Color _coarse_color_at(int p_row, int p_column, double p_energy) const;

	Half _sky, _ground;
	godot::Ref<godot::Image> _picture; // small; it is added
	int _picture_rows = 0; // of it, from the zenith on, that are seen
	godot::Color _picture_light{ 1.0f, 1.0f, 1.0f };
	double _energy = 0.0;
	bool _is_known = false;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// Draws a small picture of a plant's mesh for the editor.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace grass {

struct PictureSurface {
	std::vector<Eigen::Vector3f> normals; // of the vertices; draw_plant() reads none
	std::vector<Eigen::Vector3f> places, colors; // of the vertices: metres or any other unit, y up; linear
	std::vector<Eigen::Vector2f> uvs; // of the vertices, in the texture
	std::vector<int32_t> indices; // three a triangle
	std::vector<uint8_t> texture; // RGBA8, sRGB, texture_width * texture_height texels, which multiply the colours; empty: none
	int texture_width = 0, texture_height = 0;
	float scissor = 0.0f; // alpha of the texture below which nothing is drawn
};

// Returns the texture's colour at a place, linear; w: alpha.
Eigen::Vector4f texel_of(const PictureSurface &p_surface, const Eigen::Vector2f &p_uv);

// Returns RGBA8, sRGB, p_side squared texels, transparent beside the plant, which fills the picture. Even the thinnest stem is drawn.
std::vector<uint8_t> draw_plant(std::span<const PictureSurface> p_surfaces, int p_side);

} // namespace grass

// SPDX-License-Identifier: MIT
#include "core/species/species_picture.h"

#include "core/base/half.h"
#include "core/base/hash.h"
#include "core/species/picture_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace grass {

namespace {

constexpr int SHOWN_BLADES = 90;
constexpr int SEGMENT_STEPS = 6; // least number of steps along a segment
constexpr float FILLED = 0.9f; // share of the height that the tallest blade fills
constexpr float DEEP = 0.12f; // height of the hindmost roots above the foremost, as a share of the picture's height
// A flower is at least this share of the picture's side, or nobody would know it; where it is larger than in nature, fewer blades have one,
// but so many at least.
constexpr float LEAST_HEAD = 0.2f;
constexpr float LEAST_HEADS = 5.0f;
constexpr float WIDER = 1.5f; // factor on the width: thin blades would be lost in a small picture

// A blade on the canvas.
struct DrawnBlade {
	std::array<Eigen::Vector2f, GRASS_KNOTS> knots; // texels
	float width; // at the root, texels
	float depth; // 0 in front, 1 behind
	uint32_t hash;

	float chance(int p_which) const { return float(grass_hash(hash + uint32_t(p_which)) >> 8) / float(1 << 24); }
};

// p_texels: number of texels in a metre.
DrawnBlade make_blade(const Patch &p_patch, int p_blade, int p_side, float p_texels) {
	const auto knot = [&](int p_knot) { return &p_patch.texels[Patch::texel_index(p_blade, p_knot)]; };
	DrawnBlade blade;
	blade.hash = uint32_t(p_blade) * 8;
	blade.depth = half_to_float(knot(0)[1]);
	blade.width = WIDER * half_to_float(knot(0)[3]) * p_texels;
	const float side = float(p_side);
	const Eigen::Vector2f root(side * (0.08f + 0.84f * half_to_float(knot(0)[0])), side * (0.99f - DEEP * blade.depth));
	blade.knots[0] = root;
	for (int k = 1; k < GRASS_KNOTS; k++) {
		blade.knots[size_t(k)] = root + p_texels * Eigen::Vector2f(half_to_float(knot(k)[0]), -half_to_float(knot(k)[1]));
	}
	return blade;
}

Eigen::Vector3f color_of(const PictureLook &p_look, const DrawnBlade &p_blade, float p_along) {
	const float place = p_along * float(p_look.colors.size() - 1);
	const size_t first = std::min(size_t(place), p_look.colors.size() - 1), second = std::min(first + 1, p_look.colors.size() - 1);
	const float part = place - float(first);
	Eigen::Vector3f color = (1.0f - part) * p_look.colors[first] + part * p_look.colors[second];
	const float straw = p_blade.chance(1) > 1.0f - 0.3f * p_look.dry ? 0.8f : 0.6f * p_look.dry * std::max(0.0f, 4.0f * p_along - 3.0f);
	color = (1.0f - straw) * color + straw * p_look.dry_color;
	const float light = (0.45f + 0.55f * p_along) * (1.0f - 0.45f * p_blade.depth) * (0.85f + 0.3f * p_blade.chance(2));
	return 1.3f * light * color;
}

// Draws a flower or a leaf. p_texels: RGBA8, sRGB, p_side squared; p_tint multiplies them; p_width, p_height: texels on the canvas.
void draw_card(PictureCanvas &r_canvas, const DrawnBlade &p_blade, std::span<const uint8_t> p_texels, int p_side,
		const Eigen::Vector3f &p_tint, float p_width, float p_height) {
	const Eigen::Vector2f middle = p_blade.knots.back();
	const float width = p_width, height = p_height;
	for (int y = int(-0.5f * height); y <= int(0.5f * height); y++) {
		for (int x = int(-0.5f * width); x <= int(0.5f * width); x++) {
			const auto place = [&](float p_at, float p_size) {
				return size_t(std::clamp(p_at / std::max(p_size, 1.0f) + 0.5f, 0.0f, 0.999f) * float(p_side));
			};
			const uint8_t *texel = &p_texels[4 * (place(float(y), height) * size_t(p_side) + place(float(x), width))];
			if (texel[3] >= 128) {
				const Eigen::Vector3f color(from_srgb(texel[0]), from_srgb(texel[1]), from_srgb(texel[2]));
				r_canvas.put(int(middle.x()) + x, int(middle.y()) + y, (1.0f - 0.3f * p_blade.depth) * color.cwiseProduct(p_tint));
			}
		}
	}
}

// How much larger than in nature flowers are drawn, and which share of the blades has one.
struct Heads {
	float larger, share;
	bool has(const DrawnBlade &p_blade) const { return p_blade.chance(3) < share; }
};

// p_texels: number of texels in a metre; p_side: of the picture, texels.
Heads find_heads(const PictureLook &p_look, float p_texels, int p_side) {
	if (p_look.card.empty()) {
		return { 1.0f, 0.0f };
	}
	const float own = std::max(p_look.card_width, p_look.card_height) * p_texels;
	const float larger = std::max(LEAST_HEAD * float(p_side) / std::max(own, 1e-3f), 1.0f);
	const float least = std::min(p_look.card_share, LEAST_HEADS / float(SHOWN_BLADES));
	return { larger, std::max(p_look.card_share / (larger * larger), least) };
}

void draw_blade(PictureCanvas &r_canvas, const PictureLook &p_look, const Heads &p_heads, const DrawnBlade &p_blade, float p_texels) {
	for (int k = 0; k < GRASS_SEGMENTS; k++) {
		const Eigen::Vector2f from = p_blade.knots[size_t(k)], way = p_blade.knots[size_t(k + 1)] - from;
		const int steps = std::max(SEGMENT_STEPS, int(std::ceil(way.norm())));
		for (int i = 0; i < steps; i++) {
			const float part = float(i) / float(steps), along = float(knot_share(k) + part * segment_share(k));
			const float width = p_blade.width * std::sqrt(1.0f - along);
			r_canvas.put_disc(from + part * way, 0.5f * width, color_of(p_look, p_blade, along));
		}
	}
	if (!p_look.leaf.empty() && !p_heads.has(p_blade)) {
		const float side = p_look.leaf_size * p_texels;
		const float grey = 1.5f; // a leaf's texels multiply its blade's colour
		draw_card(r_canvas, p_blade, p_look.leaf, p_look.card_side, grey * color_of(p_look, p_blade, 1.0f), side, 0.6f * side);
	}
}

} // namespace

std::vector<uint8_t> draw_species(const PatchParams &p_patch, const PictureLook &p_look, int p_side) {
	const Patch patch = generate_patch(p_patch);
	PictureCanvas canvas(p_side);
	if (!patch.is_empty() && !p_look.colors.empty()) {
		const float tallest = patch.max_height + (p_look.card.empty() ? 0.0f : 0.5f * p_look.card_height);
		const float texels = (FILLED - 0.5f * DEEP) * float(canvas.get_side()) / std::max(tallest, 1e-3f);
		const Heads heads = find_heads(p_look, texels, canvas.get_side());
		std::vector<DrawnBlade> blades;
		for (int i = 0; i < SHOWN_BLADES; i++) {
			blades.push_back(make_blade(patch, i * (GRASS_PATCH_BLADES / SHOWN_BLADES), canvas.get_side(), texels));
		}
		std::sort(blades.begin(), blades.end(), [](const DrawnBlade &p_a, const DrawnBlade &p_b) { return p_a.depth > p_b.depth; });
		for (const DrawnBlade &blade : blades) {
			draw_blade(canvas, p_look, heads, blade, texels);
		}
		for (const DrawnBlade &blade : blades) { // leaves would hide them
			if (heads.has(blade)) {
				const float larger = heads.larger * texels;
				draw_card(canvas, blade, p_look.card, p_look.card_side, p_look.card_color, larger * p_look.card_width,
						larger * p_look.card_height);
			}
		}
	}
	return canvas.shrunk();
}

} // namespace grass

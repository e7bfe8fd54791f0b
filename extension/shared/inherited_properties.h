// SPDX-License-Identifier: MIT
// Properties that a GrassField inherits and that do nothing on it: they reach the node's own instance in the renderer, which draws
// nothing, while the grass is drawn by instances that culling and levels of detail of our own feed. The inspector hides them.
// Most of them refer to the bounds of the whole field, which say little about the grass in view.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace grass {

inline constexpr std::array<std::string_view, 16> PROPERTIES_WITHOUT_EFFECT = {
	"material_override",
	"material_overlay",
	"extra_cull_margin",
	"custom_aabb",
	"lod_bias",
	"ignore_occlusion_culling",
	"gi_lightmap_texel_scale",
	"gi_lightmap_scale",
	"visibility_range_begin",
	"visibility_range_begin_margin",
	"visibility_range_end",
	"visibility_range_end_margin",
	"visibility_range_fade_mode",
	"visibility_parent",
	"sorting_offset",
	"sorting_use_aabb_center",
};

constexpr bool has_no_effect(std::string_view p_property) {
	return std::ranges::find(PROPERTIES_WITHOUT_EFFECT, p_property) != PROPERTIES_WITHOUT_EFFECT.end();
}

} // namespace grass

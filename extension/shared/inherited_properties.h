// SPDX-License-Identifier: MIT
// Properties that a GrassField inherits and that have no effect on it: they affect the node's own instance in the renderer, which draws
// nothing. The grass is drawn by other instances, with culling and levels of detail of our own. The inspector hides these properties. Most
// of them depend on the bounds of the whole field, which say little about the grass in view.
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

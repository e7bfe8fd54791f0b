// SPDX-License-Identifier: MIT
#include "field/sun_map.h"

#include "core/base/glsl.h"
#include "shared/scene_watch.h"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

bool shines_on(const DirectionalLight3D *p_sun, const VisualInstance3D *p_node) {
	return p_sun->is_visible_in_tree() && p_sun->get_world_3d() == p_node->get_world_3d() &&
			p_sun->get_sky_mode() != DirectionalLight3D::SKY_MODE_SKY_ONLY && (p_sun->get_cull_mask() & p_node->get_layer_mask()) != 0;
}

// Returns how far the engine draws shadows, metres: not beyond what the camera sees.
double reach_of(const DirectionalLight3D *p_sun, const Node *p_node) {
	const Camera3D *camera = p_node->get_viewport()->get_camera_3d();
	const double sight = camera != nullptr ? camera->get_far() : 4000.0;
	const double reach = p_sun->get_param(Light3D::PARAM_SHADOW_MAX_DISTANCE);
	return reach > 0.0 ? std::min(reach, sight) : sight;
}

} // namespace

bool casts_for(const DirectionalLight3D *p_sun, const VisualInstance3D *p_node) {
	return p_sun->has_shadow() && p_sun->is_visible_in_tree() && p_sun->get_world_3d() == p_node->get_world_3d() &&
			(p_sun->get_shadow_caster_mask() & p_node->get_layer_mask()) != 0;
}

SunMap find_sun_map(const GeometryInstance3D *p_node) {
	constexpr double WHOLE = 0.999; // the engine fades over a thousandth at least
	constexpr real_t NO_MAP = 1e6f; // metres
	SunMap found;
	Vector4 &map = found.map =
			Vector4(NO_MAP, 2 * NO_MAP, p_node->get_cast_shadows_setting() == GeometryInstance3D::SHADOW_CASTING_SETTING_OFF ? 0 : 1, 0);
	for (const DirectionalLight3D *sun : SceneWatch::get_singleton()->get_suns()) {
		if (!shines_on(sun, p_node)) {
			continue;
		}
		if (!casts_for(sun, p_node)) {
			found.bare.push_back(sun->get_global_transform().basis.get_column(2).normalized());
			continue;
		}
		const double reach = reach_of(sun, p_node);
		if (reach < map.y) {
			map.x = real_t(reach * std::min(double(sun->get_param(Light3D::PARAM_SHADOW_FADE_START)), WHOLE));
			map.y = real_t(reach);
		}
		map.w = std::max(map.w, real_t(0.01 * sun->get_param(Light3D::PARAM_SHADOW_BIAS) * sun->get_param(Light3D::PARAM_SHADOW_BLUR)));
	}
	const bool has_map = map.x < NO_MAP;
	if (!has_map || found.bare.size() > GRASS_MAX_SUNS) {
		found.bare.clear(); // which each pixel would compare with its light
		map.z = 0;
	}
	return found;
}

} // namespace grass

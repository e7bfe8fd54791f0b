// SPDX-License-Identifier: MIT
#include "field/other_light.h"

#include "field/sky_light.h"
#include "shared/scene_watch.h"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/sky.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>

using namespace godot;

namespace grass {

namespace {
constexpr int FRAMES_A_LOOK = 30; // at least: a look waits for the GPU
constexpr int LOOKS = 2;

bool is_shining(const DirectionalLight3D *p_sun, const Node3D *p_node) {
	return p_sun->is_visible_in_tree() && p_sun->get_sky_mode() != DirectionalLight3D::SKY_MODE_SKY_ONLY &&
			p_sun->get_world_3d() == p_node->get_world_3d();
}

// Returns the environment in which the renderer draws: the camera's own one comes first.
Ref<Environment> find_environment(const Node3D *p_node) {
	const Camera3D *camera = p_node->get_viewport()->get_camera_3d();
	if (camera != nullptr && camera->get_environment().is_valid()) {
		return camera->get_environment();
	}
	const Ref<World3D> world = p_node->get_world_3d();
	return world->get_environment().is_valid() ? world->get_environment() : world->get_fallback_environment();
}

// Returns the light of any sky, as the renderer has it now. Waits for the GPU.
Color bake(const Ref<Sky> &p_sky) {
	constexpr int HEIGHTS = 64; // from the zenith to the nadir: the first is nearly the zenith
	const Ref<Image> column = RenderingServer::get_singleton()->sky_bake_panorama(p_sky->get_rid(), 1.0, true, Vector2i(1, HEIGHTS));
	return column.is_valid() ? column->get_pixel(0, 0) : Color(0.0f, 0.0f, 0.0f);
}
} // namespace

Vector4 OtherLight::find(Node3D *p_node) {
	SceneWatch::get_singleton()->start(p_node);
	std::vector<double> seen;
	bool is_any = false, are_all = true;
	for (const DirectionalLight3D *sun : SceneWatch::get_singleton()->get_suns()) {
		if (is_shining(sun, p_node)) {
			is_any = true;
			are_all = are_all && sun->has_shadow();
			const Vector3 from = sun->get_global_transform().basis.get_column(2);
			const Color color = sun->get_color() * sun->get_param(Light3D::PARAM_ENERGY);
			seen.insert(seen.end(), { from.x, from.y, from.z, color.r, color.g, color.b });
		}
	}
	const Ref<Environment> environment = find_environment(p_node);
	if (!is_any || !are_all || environment.is_null()) {
		return Vector4(0, 0, 0, is_any && are_all ? 1 : 0);
	}
	const Ref<Sky> sky = environment->get_sky();
	seen.insert(seen.end(), { sky.is_valid() ? double(sky->get_instance_id()) : 0.0, environment->get_bg_energy_multiplier() });
	_frames++;
	if (seen != _seen) {
		_seen = seen;
		_looks_left = LOOKS;
	}
	const Color ambient = _ambient(environment);
	return Vector4(ambient.r, ambient.g, ambient.b, 1);
}

// Returns the ambient light as the renderer makes it.
Color OtherLight::_ambient(const Ref<Environment> &p_environment) {
	const Environment::AmbientSource source = p_environment->get_ambient_source();
	const Environment::BGMode background = p_environment->get_background();
	const bool is_background = source == Environment::AMBIENT_SOURCE_BG;
	if (is_background && (background == Environment::BG_CLEAR_COLOR || background == Environment::BG_COLOR)) {
		const Color color = background == Environment::BG_COLOR ? p_environment->get_bg_color()
																: RenderingServer::get_singleton()->get_default_clear_color();
		return color.srgb_to_linear() * p_environment->get_bg_energy_multiplier();
	}
	const bool is_sky = source == Environment::AMBIENT_SOURCE_SKY || (is_background && background == Environment::BG_SKY);
	const Color own = p_environment->get_ambient_light_color().srgb_to_linear() * p_environment->get_ambient_light_energy();
	if (is_sky && p_environment->get_sky().is_valid()) {
		return own.lerp(_of_sky(p_environment), p_environment->get_ambient_light_sky_contribution());
	}
	return source == Environment::AMBIENT_SOURCE_COLOR ? own : Color(0.0f, 0.0f, 0.0f);
}

// Returns what falls on level ground. The renderer applies the background's energy twice: to the sky, and to its light.
Color OtherLight::_of_sky(const Ref<Environment> &p_environment) {
	const double energy = p_environment->get_bg_energy_multiplier();
	if (_looks_left > 0 && _frames >= FRAMES_A_LOOK) {
		_looks_left--;
		_frames = 0;
		const Ref<Sky> sky = p_environment->get_sky();
		const SkyLight light(sky->get_material());
		_sky = light.is_known() ? light.find(energy) : bake(sky);
		if (!(_sky.r + _sky.g + _sky.b > 0.0f)) { // browsers read no floats back
			_sky = light.find(energy);
		}
	}
	return _sky * float(energy);
}

} // namespace grass

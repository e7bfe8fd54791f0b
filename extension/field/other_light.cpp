// SPDX-License-Identifier: MIT
#include "field/other_light.h"

#include "shared/scene_watch.h"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/sky.hpp>
#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

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

// The colours of a ProceduralSkyMaterial, linear, by the way from the zenith: 0 to 1 at the horizon.
class Gradient {
public:
	explicit Gradient(const Material &p_material) :
			_top(Color(p_material.get("sky_top_color")).srgb_to_linear()),
			_horizon(Color(p_material.get("sky_horizon_color")).srgb_to_linear()),
			_cover_light(Color(p_material.get("sky_cover_modulate")).srgb_to_linear()),
			_exponent(CURVE / std::max(double(p_material.get("sky_curve")), 1e-3)) {
		const Ref<Texture2D> cover = p_material.get("sky_cover");
		const Ref<Image> image = cover.is_valid() ? cover->get_image() : Ref<Image>();
		if (image.is_valid() && !image->is_compressed()) {
			_cover = image->duplicate();
			_cover->resize(1, 2 * ROWS, Image::INTERPOLATE_LANCZOS);
		}
	}

	Color color_at(double p_from_zenith) const {
		const Color clear = _horizon.lerp(_top, float(1.0 - std::pow(p_from_zenith, _exponent)));
		if (_cover.is_null()) {
			return clear;
		}
		const Color cloud = _cover->get_pixel(0, std::min(int(p_from_zenith * ROWS), ROWS - 1));
		return clear + cloud.srgb_to_linear() * _cover_light * (cloud.a * _cover_light.a); // the engine adds clouds
	}

private:
	static constexpr double CURVE = 0.6; // the engine's exponent over 1 / sky_curve
	static constexpr int ROWS = 32; // of the mean of its clouds around, above the horizon

	Color _top, _horizon, _cover_light;
	double _exponent;
	Ref<Image> _cover;
};

// Returns what a ProceduralSkyMaterial sends to level ground; black for any other material.
Color light_of_gradient(const Ref<Material> &p_material) {
	constexpr int RINGS = 32; // of equal weight for level ground
	if (p_material.is_null() || !p_material->is_class("ProceduralSkyMaterial")) {
		return Color(0.0f, 0.0f, 0.0f);
	}
	const Gradient gradient(**p_material);
	Color sum(0.0f, 0.0f, 0.0f);
	for (int ring = 0; ring < RINGS; ring++) {
		const double sine = std::sqrt((ring + 0.5) / RINGS); // of the height above the horizon
		sum += gradient.color_at(std::acos(sine) / (0.5 * std::numbers::pi)) / float(RINGS);
	}
	return sum * float(double(p_material->get("sky_energy_multiplier")) * double(p_material->get("energy_multiplier")));
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
	seen.push_back(sky.is_valid() ? double(sky->get_instance_id()) : 0.0);
	_frames++;
	if (seen != _seen) {
		_seen = seen;
		_looks_left = LOOKS;
	}
	const Color ambient = _ambient(environment);
	return Vector4(ambient.r, ambient.g, ambient.b, 1);
}

// As the renderer makes it.
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

// Returns what falls on level ground.
Color OtherLight::_of_sky(const Ref<Environment> &p_environment) {
	if (_looks_left > 0 && _frames >= FRAMES_A_LOOK) {
		_looks_left--;
		_frames = 0;
		const Ref<Image> around =
				RenderingServer::get_singleton()->sky_bake_panorama(p_environment->get_sky()->get_rid(), 1.0, true, Vector2i(8, 8));
		_sky = around.is_valid() ? around->get_pixel(0, 0) : Color(0.0f, 0.0f, 0.0f);
		if (!(_sky.r + _sky.g + _sky.b > 0.0f)) { // browsers read no floats back
			_sky = light_of_gradient(p_environment->get_sky()->get_material());
		}
	}
	return _sky * p_environment->get_bg_energy_multiplier();
}

} // namespace grass

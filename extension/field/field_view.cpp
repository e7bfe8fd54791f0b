// SPDX-License-Identifier: MIT
#include "field/field_view.h"

#include "field/sun_map.h"
#include "shared/convert.h"
#include "shared/frames.h"
#include "shared/scene_watch.h"

#include <godot_cpp/classes/compositor.hpp>
#include <godot_cpp/classes/compositor_effect.hpp>
#include <godot_cpp/classes/sub_viewport.hpp>
#include <godot_cpp/classes/sub_viewport_container.hpp>
#include <godot_cpp/classes/viewport_texture.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/classes/xr_interface.hpp>
#include <godot_cpp/classes/xr_server.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

// Returns whether a viewport's picture is drawn at all. Where only the renderer knows, it counts as drawn.
bool is_drawn(Viewport *p_viewport) {
	if (p_viewport->is_3d_disabled()) {
		return false;
	}
	if (const Window *window = Object::cast_to<Window>(p_viewport)) {
		return window->is_visible();
	}
	if (const SubViewport *sub = Object::cast_to<SubViewport>(p_viewport)) {
		const SubViewport::UpdateMode mode = sub->get_update_mode();
		const SubViewportContainer *container = Object::cast_to<SubViewportContainer>(sub->get_parent());
		const bool hidden = mode == SubViewport::UPDATE_WHEN_VISIBLE && container != nullptr && !container->is_visible_in_tree();
		return mode != SubViewport::UPDATE_DISABLED && !hidden;
	}
	return true;
}

// Metres in a pixel: p_camera.pixel + p_camera.pixel_slope * distance.
void set_pixel(const Camera3D *p_camera, Viewport *p_viewport, ViewCamera &r_camera) {
	const Vector2 size = p_viewport->get_texture()->get_size() * p_viewport->get_scaling_3d_scale();
	const real_t pixels = std::max(p_camera->get_keep_aspect_mode() == Camera3D::KEEP_WIDTH ? size.x : size.y, real_t(1));
	switch (p_camera->get_projection()) {
		case Camera3D::PROJECTION_ORTHOGONAL:
			r_camera.pixel = float(p_camera->get_size() / pixels);
			break;
		case Camera3D::PROJECTION_FRUSTUM:
			r_camera.pixel_slope = float(p_camera->get_size() / p_camera->get_near() / pixels);
			break;
		default:
			r_camera.pixel_slope = float(2.0 * std::tan(0.5 * Math::deg_to_rad(double(p_camera->get_fov()))) / pixels);
	}
}

ViewCamera view_camera(const Camera3D *p_camera, Viewport *p_viewport, const Eigen::Affine3d &p_field) {
	ViewCamera view;
	const TypedArray<Plane> planes = p_camera->get_frustum();
	for (int i = 0; i < 6 && i < planes.size(); i++) {
		const Eigen::Vector4d plane = to_eigen(Plane(planes[i]));
		const Eigen::Vector3d normal = plane.head<3>();
		view.planes[size_t(i)].head<3>() = (p_field.linear().transpose() * normal).cast<float>();
		view.planes[size_t(i)].w() = float(plane.w() - normal.dot(p_field.translation()));
	}
	view.eye = (p_field.inverse(Eigen::Isometry) * to_eigen(p_camera->get_camera_transform().origin)).cast<float>();
	view.near = float(p_camera->get_near());
	set_pixel(p_camera, p_viewport, view);
	return view;
}

// Adds a headset's eyes as the renderer finds them: layers, near and far are the camera's, and the headset knows where the eyes are.
void add_eyes(XRInterface &p_headset, const Camera3D *p_camera, Viewport *p_viewport, const Eigen::Affine3d &p_field,
		std::vector<ViewCamera> &r_views) {
	const Vector2 size = p_headset.get_render_target_size();
	const double aspect = size.y > 0.0f ? double(size.x) / size.y : 1.0, near = p_camera->get_near();
	const Transform3D origin = XRServer::get_singleton()->get_world_origin();
	for (uint32_t eye = 0; eye < p_headset.get_view_count(); eye++) {
		const Eigen::Affine3d pose = to_eigen(p_headset.get_transform_for_view(eye, origin).orthonormalized());
		const Eigen::Matrix4d projection = to_eigen(p_headset.get_projection_for_view(eye, aspect, near, p_camera->get_far()));
		const double pixels = double(size.y) * p_viewport->get_scaling_3d_scale();
		r_views.push_back(view_of_eye(projection, p_field.inverse(Eigen::Isometry) * pose, near, pixels));
	}
}

// Returns the headset that shows a viewport's picture, if any. Engines that are built with `disable_xr=yes` have no viewport that could say
// so.
Ref<XRInterface> find_headset(Viewport *p_viewport) {
	static const bool has_xr = p_viewport->has_method("is_using_xr");
	if (!has_xr || !p_viewport->is_using_xr()) {
		return {};
	}
	const Ref<XRInterface> headset = XRServer::get_singleton()->get_primary_interface();
	return headset.is_valid() && headset->is_initialized() ? headset : Ref<XRInterface>();
}

// Returns the pose of p_field for a camera that is drawn between two ticks: its planes and its place are those of the last tick.
Eigen::Affine3d seen_from(Camera3D *p_camera, const Eigen::Affine3d &p_field) {
	const Transform3D told = p_camera->get_global_transform(), drawn = p_camera->get_global_transform_interpolated();
	if (told == drawn || !drawn.is_finite()) {
		return p_field;
	}
	const Eigen::Isometry3d back(to_eigen(drawn.orthonormalized()).matrix());
	return to_eigen(told.orthonormalized()) * back.inverse() * p_field;
}

bool has_motion_effect(const Ref<Compositor> &p_compositor) {
	if (p_compositor.is_null()) {
		return false;
	}
	const TypedArray<CompositorEffect> effects = p_compositor->get_compositor_effects();
	for (int64_t i = 0; i < effects.size(); i++) {
		const CompositorEffect *effect = Object::cast_to<CompositorEffect>(effects[i]);
		if (effect != nullptr && effect->get_enabled() && effect->get_needs_motion_vectors()) {
			return true;
		}
	}
	return false;
}

// Returns whether the picture of a viewport is made with motion vectors.
bool has_motion(const Camera3D *p_camera, Viewport *p_viewport) {
	const Viewport::Scaling3DMode scaling = p_viewport->get_scaling_3d_mode();
	return p_viewport->is_using_taa() || scaling == Viewport::SCALING_3D_MODE_FSR2 ||
			scaling == Viewport::SCALING_3D_MODE_METALFX_TEMPORAL || p_viewport->get_debug_draw() == Viewport::DEBUG_DRAW_MOTION_VECTORS ||
			has_motion_effect(p_camera->get_compositor());
}

// Returns whether this frame shows what the camera sees of the node's world, of whatever layers. Not by is_current(), which the editor's
// cameras and those of the edited scene return differently.
bool is_watching(const Camera3D *p_camera, const Node3D *p_node) {
	Viewport *viewport = p_camera->get_viewport();
	return viewport != nullptr && viewport->get_camera_3d() == p_camera && p_camera->get_world_3d() == p_node->get_world_3d() &&
			is_drawn(viewport);
}

// Returns the same of some layers: the renderer draws nothing else for the camera, neither in its picture nor in the shadows there.
bool is_seeing(const Camera3D *p_camera, const Node3D *p_node, uint32_t p_layers) {
	return (p_camera->get_cull_mask() & p_layers) != 0 && is_watching(p_camera, p_node);
}

void find_cameras(const VisualInstance3D *p_node, const Eigen::Affine3d &p_field, FieldView &r_view) {
	for (Camera3D *camera : SceneWatch::get_singleton()->get_cameras()) {
		r_view.is_watched = r_view.is_watched || is_watching(camera, p_node);
		if (!is_seeing(camera, p_node, p_node->get_layer_mask())) {
			continue;
		}
		Viewport *viewport = camera->get_viewport();
		if (const Ref<XRInterface> headset = find_headset(viewport); headset.is_valid()) {
			add_eyes(**headset, camera, viewport, p_field, r_view.cameras);
		} else {
			r_view.cameras.push_back(view_camera(camera, viewport, seen_from(camera, p_field)));
		}
	}
}

// Returns whether a picture is made with motion vectors: for TAA, FSR 2, or an effect that reads them.
bool are_motion_vectors_read(const VisualInstance3D *p_node) {
	const SceneWatch &scene = *SceneWatch::get_singleton();
	const bool in_world = std::ranges::any_of(scene.get_environments(), [p_node](const WorldEnvironment *p_environment) {
		return p_environment->get_viewport() != nullptr && p_environment->get_viewport()->find_world_3d() == p_node->get_world_3d() &&
				has_motion_effect(p_environment->get_compositor());
	});
	return in_world || std::ranges::any_of(scene.get_cameras(), [p_node](const Camera3D *p_camera) {
		return is_seeing(p_camera, p_node, p_node->get_layer_mask()) && has_motion(p_camera, p_camera->get_viewport());
	});
}

// Where the shadow of a point p_height metres above the field ends, from there, for each directional light that casts its shadows down on
// it. At most p_farthest metres long; field space.
std::vector<Eigen::Vector3f> find_falls(
		const VisualInstance3D *p_node, const Eigen::Affine3d &p_field, double p_height, double p_farthest) {
	std::vector<Eigen::Vector3f> falls;
	for (const DirectionalLight3D *sun : SceneWatch::get_singleton()->get_suns()) {
		if (!casts_for(sun, p_node) || falls.size() == GRASS_MAX_SUNS) {
			continue;
		}
		const Eigen::Vector3d shining = to_eigen(-sun->get_global_transform().basis.get_column(2));
		const Eigen::Vector3d down = (p_field.linear().transpose() * shining).normalized();
		if (down.allFinite() && down.y() < 0.0) { // from below, the ground is in the way
			falls.push_back((std::min(p_height / -down.y(), p_farthest) * down).cast<float>());
		}
	}
	return falls;
}

} // namespace

std::vector<Eigen::Vector3d> find_eyes(const Node3D *p_node, uint32_t p_layers, const Eigen::Affine3d &p_field) {
	std::vector<Eigen::Vector3d> eyes;
	for (const Camera3D *camera : SceneWatch::get_singleton()->get_cameras()) {
		if (is_seeing(camera, p_node, p_layers)) {
			eyes.push_back(p_field.inverse(Eigen::Isometry) * to_eigen(camera->get_camera_transform().origin));
		}
	}
	return eyes;
}

std::vector<Eigen::Vector2d> find_eyes_on_ground(const Node3D *p_node, uint32_t p_layers, const Eigen::Affine3d &p_field) {
	std::vector<Eigen::Vector2d> places;
	for (const Eigen::Vector3d &eye : find_eyes(p_node, p_layers, p_field)) {
		places.emplace_back(eye.x(), eye.z());
	}
	return places;
}

FieldView find_view(GeometryInstance3D *p_node, const Transform3D &p_transform, const FieldProperties &p_properties, const Field &p_field) {
	SceneWatch::get_singleton()->start(p_node);
	FieldView view;
	const Eigen::Affine3d field = to_eigen(p_transform);
	find_cameras(p_node, field, view);
	view.is_drawn = draws_frames();
	if (view.cameras.empty()) {
		return view;
	}
	view.lod = p_properties.lod();
	view.lod.is_carried = p_properties.has_soil;
	view.plant_reach = float(p_properties.quality.factor(QUALITY_PLANT_DISTANCE));
	view.has_motion = are_motion_vectors_read(p_node);
	if (p_node->get_cast_shadows_setting() != GeometryInstance3D::SHADOW_CASTING_SETTING_OFF) {
		const double distance = p_properties.scaled(PARAM_SHADOW_DISTANCE);
		view.shadow_distance = float(distance);
		view.shadow_margin = float(p_properties.param(PARAM_SHADOW_MARGIN));
		view.falls = find_falls(p_node, field, p_field.get_setup().blade_height() + p_field.ground_range(), distance);
	}
	return view;
}

} // namespace grass

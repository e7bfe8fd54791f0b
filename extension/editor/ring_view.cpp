// SPDX-License-Identifier: MIT
#include "editor/ring_view.h"

#include "core/paint/brush_ring.h"
#include "draw/shared_shader.h"
#include "render_shaders.gen.h"
#include "shared/convert.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/packed_color_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

constexpr int POINTS = 64; // of a ring
constexpr double OUTER_PIXELS = 3.0, INNER_PIXELS = 1.5; // width
constexpr double INNER_ALPHA = 0.6;
constexpr int VEIL_RINGS = 6, VEIL_POINTS = 32; // each costs a ray; fewer: the veil cuts through hills
constexpr double VEIL_LEAST = 0.06, VEIL_MOST = 0.2; // its alpha at strength 0 and 1
constexpr uint32_t TOOL_LAYER = 1 << 24; // visible only to the 3D editor's own cameras

// The eye, and the width of a pixel per distance from the eye.
struct Sight {
	Eigen::Vector3d eye; // in PaintedFields::space
	double pixel;
};

Sight sight_of(const Camera3D *p_camera, const Eigen::Isometry3d &p_space, const Eigen::Vector3d &p_centre) {
	const double height = std::max(1.0, double(p_camera->get_viewport()->get_visible_rect().size.y));
	const double scale = EditorInterface::get_singleton()->get_editor_scale();
	if (p_camera->get_projection() == Camera3D::PROJECTION_ORTHOGONAL) { // an eye so far away that all distances are equal
		const double far = 1e4 * p_camera->get_size();
		const Eigen::Vector3d back = p_space.linear().transpose() * to_eigen(p_camera->get_camera_transform().basis.get_column(2));
		return { p_centre + far * back, scale * p_camera->get_size() / (height * far) };
	}
	const Eigen::Vector3d eye = p_space.inverse() * to_eigen(p_camera->get_camera_transform().origin);
	return { eye, scale * 2.0 * std::tan(0.5 * Math::deg_to_rad(double(p_camera->get_fov()))) / height };
}

} // namespace

void RingView::create() {
	RenderingServer *server = RenderingServer::get_singleton();
	_mesh = server->mesh_create();
	_instance = server->instance_create();
	server->instance_set_base(_instance, _mesh);
	server->instance_set_layer_mask(_instance, TOOL_LAYER);
	server->instance_geometry_set_cast_shadows_setting(_instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
	_material.instantiate();
	_material->set_shader(shared_shader({ shader::BRUSH_RING_GDSHADER, VertexKind::GROUND }));
	server->instance_geometry_set_material_override(_instance, _material->get_rid());
}

void RingView::show(const PaintedFields &p_painted, const Camera3D *p_camera, const GroundPoint &p_centre, const Look &p_look) {
	if (!_instance.is_valid()) {
		create();
	}
	const Transform3D transform = to_godot(Eigen::Affine3d(p_painted.space));
	const Sight sight = sight_of(p_camera, p_painted.space, p_centre.position);
	const Color color = p_look.color.srgb_to_linear();
	PackedVector3Array vertices;
	PackedColorArray colors;
	const auto add = [&](const Eigen::Vector3d &p_vertex, double p_alpha) {
		vertices.push_back(to_godot(Eigen::Vector3d(p_vertex - p_centre.position)));
		colors.push_back(Color(color.r, color.g, color.b, float(p_alpha)));
	};
	const auto add_ring = [&](double p_radius, double p_pixels, double p_alpha) {
		const std::vector<Eigen::Vector2d> places = circle_places(p_centre.place(), p_radius, POINTS);
		const std::vector<Eigen::Vector3d> loop = drape(p_painted, p_centre, places, p_look.radius);
		for (const Eigen::Vector3d &vertex : ring_band(loop, sight.eye, p_pixels * sight.pixel)) {
			add(vertex, p_alpha);
		}
	};
	if (p_look.strength > 0.0) {
		const std::vector<Eigen::Vector2d> places = disc_places(p_centre.place(), p_look.radius, VEIL_RINGS, VEIL_POINTS);
		const std::vector<Eigen::Vector3d> disc = drape(p_painted, p_centre, places, p_look.radius);
		for (const int place : disc_triangles(VEIL_RINGS, VEIL_POINTS)) {
			const double weight = p_look.shape.get_weight(places[size_t(place)]);
			add(disc[size_t(place)], weight * (VEIL_LEAST + (VEIL_MOST - VEIL_LEAST) * p_look.strength));
		}
	}
	add_ring(p_look.radius, OUTER_PIXELS, 1.0);
	if (p_look.hardness > 0.0 && p_look.hardness < 1.0) {
		add_ring(p_look.radius * p_look.hardness, INNER_PIXELS, INNER_ALPHA);
	}
	Array arrays;
	arrays.resize(Mesh::ARRAY_MAX);
	arrays[Mesh::ARRAY_VERTEX] = vertices;
	arrays[Mesh::ARRAY_COLOR] = colors;
	RenderingServer *server = RenderingServer::get_singleton();
	server->mesh_clear(_mesh);
	server->mesh_add_surface_from_arrays(_mesh, RenderingServer::PRIMITIVE_TRIANGLES, arrays);
	server->instance_set_scenario(_instance, p_painted.chosen->get_world_3d()->get_scenario());
	server->instance_set_transform(_instance, transform.translated_local(to_godot(p_centre.position)));
	server->instance_set_visible(_instance, true);
	_shown = true;
}

void RingView::hide() {
	if (_shown) {
		RenderingServer::get_singleton()->instance_set_visible(_instance, false);
		RenderingServer::get_singleton()->instance_set_scenario(_instance, RID()); // so that its world can be freed
	}
	_shown = false;
}

void RingView::free() {
	if (_instance.is_valid()) {
		RenderingServer::get_singleton()->free_rid(_instance);
		RenderingServer::get_singleton()->free_rid(_mesh);
	}
	_instance = _mesh = RID();
	_material.unref();
	_shown = false;
}

} // namespace grass

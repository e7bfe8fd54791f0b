// SPDX-License-Identifier: MIT
#include "resources/grass_exclusion_3d.h"

#include "shared/bind_property.h"
#include "shared/params.h"
#include "shared/watch_resource.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

const Color GIZMO_COLOR(0.99f, 0.5f, 0.5f);
// Metres from the shape's centre. For points farther away the engine never finishes making the hull.
constexpr real_t FARTHEST_POINT = 1e5f;

// Returns whether the engine can draw the shape. It accepts any points, and hangs or crashes with those that are not numbers.
bool is_drawable(const Ref<Shape3D> &p_shape) {
	const char *held = p_shape->is_class("ConvexPolygonShape3D") ? "points" : "data";
	const bool is_polygon = p_shape->is_class("ConvexPolygonShape3D") || p_shape->is_class("ConcavePolygonShape3D");
	const PackedVector3Array points = is_polygon ? PackedVector3Array(p_shape->get(held)) : PackedVector3Array();
	return std::all_of(points.ptr(), points.ptr() + points.size(),
			[](const Vector3 &p_point) { return p_point.is_finite() && p_point.length() <= FARTHEST_POINT; });
}

} // namespace

void GrassExclusion3D::changed() {
	_nodes.change(
			*this, [this] { return make_picture(); }, GIZMO_COLOR, _picture);
}

void GrassExclusion3D::set_shape(const Ref<Shape3D> &p_shape) {
	if (watch_instead(_shape, p_shape, callable_mp(this, &GrassExclusion3D::changed))) {
		changed();
	}
}

void GrassExclusion3D::set_outline(const PackedVector2Array &p_outline) {
	for (int64_t i = 0; i < p_outline.size(); i++) {
		ERR_FAIL_COND_MSG(!p_outline[i].is_finite(), label() + String(": `outline` must have finite numbers only."));
	}
	if (replace(_outline, p_outline)) {
		changed();
	}
}

void GrassExclusion3D::set_fade(double p_fade) {
	if (replace(_fade, checked(FADE, p_fade, label()))) {
		changed();
	}
}

void GrassExclusion3D::set_enabled(bool p_enabled) {
	if (replace(_enabled, p_enabled)) {
		changed();
	}
}

PackedStringArray GrassExclusion3D::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (_shape.is_null() && _outline.size() < 3) {
		warnings.push_back("This node excludes nothing: set `shape`, or at least three corners as `outline`.");
	}
	if (_shape.is_valid()) {
		const int64_t type = PhysicsServer3D::get_singleton()->shape_get_type(_shape->get_rid());
		if (type == PhysicsServer3D::SHAPE_HEIGHTMAP || type == PhysicsServer3D::SHAPE_WORLD_BOUNDARY ||
				type == PhysicsServer3D::SHAPE_SEPARATION_RAY) {
			warnings.push_back(
					"`shape` is a ground shape or a ray, which excludes nothing. Use a box, sphere, capsule, cylinder or polygon.");
		}
		if (!is_drawable(_shape)) {
			warnings.push_back(vformat("`shape` has points that are not finite, or farther than %d m away, so it is not drawn. Correct its "
									   "points.",
					int64_t(FARTHEST_POINT)));
		}
	}
	return warnings;
}

void GrassExclusion3D::_notification(int p_what) {
	if (_nodes.notify(*this, p_what, _picture)) {
		changed();
	}
}

// Returns the lines of the outline, closed, or those of the shape.
Ref<ArrayMesh> GrassExclusion3D::make_picture() const {
	if (_shape.is_valid()) {
		return is_drawable(_shape) ? _shape->get_debug_mesh() : Ref<ArrayMesh>();
	}
	PackedVector3Array lines;
	for (int64_t i = 0; i < _outline.size(); i++) {
		for (const Vector2 &corner : { _outline[i], _outline[(i + 1) % _outline.size()] }) {
			lines.push_back(Vector3(corner.x, 0, corner.y));
		}
	}
	return EditorPicture::mesh_of(lines);
}

void GrassExclusion3D::_bind_methods() {
	GRASS_BIND_PROPERTY(GrassExclusion3D, PropertyInfo(Variant::BOOL, "enabled"), set_enabled, is_enabled);
	GRASS_BIND_PROPERTY(
			GrassExclusion3D, PropertyInfo(Variant::OBJECT, "shape", PROPERTY_HINT_RESOURCE_TYPE, "Shape3D"), set_shape, get_shape);
	GRASS_BIND_PROPERTY(GrassExclusion3D, PropertyInfo(Variant::PACKED_VECTOR2_ARRAY, "outline", PROPERTY_HINT_NONE, "suffix:m"),
			set_outline, get_outline);
	GRASS_BIND_PROPERTY(GrassExclusion3D, property_of(FADE), set_fade, get_fade);
}

} // namespace grass

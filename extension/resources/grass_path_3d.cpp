// SPDX-License-Identifier: MIT
#include "resources/grass_path_3d.h"

#include "shared/bind_property.h"
#include "shared/params.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

// A piece of the curve between two of its points is halved up to this often, until it bends by less than this angle: a metre of a curve of
// 10 m is off by some millimetres.
constexpr int HALVINGS = 6;
constexpr float BEND = 2.0f; // degrees

const Color CLEAR_COLOR(0.99f, 0.5f, 0.5f), PLANT_COLOR(0.56f, 0.94f, 0.59f);

} // namespace

GrassPath3D::GrassPath3D() {
	connect("curve_changed", callable_mp(this, &GrassPath3D::_changed));
}

PackedVector3Array GrassPath3D::get_points() const {
	const Ref<Curve3D> curve = get_curve();
	if (curve.is_null() || curve->get_point_count() < 2) {
		return PackedVector3Array();
	}
	return curve->tessellate(HALVINGS, BEND);
}

bool GrassPath3D::concerns(const Node *p_field) const {
	return String(_field_group).is_empty() || p_field->is_in_group(_field_group);
}

void GrassPath3D::_changed() {
	_nodes.change(
			*this, [this] { return make_picture(); }, _mode == MODE_PLANT ? PLANT_COLOR : CLEAR_COLOR, _picture);
}

void GrassPath3D::set_mode(Mode p_mode) {
	ERR_FAIL_INDEX_MSG(int64_t(p_mode), int64_t(MODE_PLANT) + 1, label() + String(": `mode` must be MODE_CLEAR or MODE_PLANT."));
	if (replace(_mode, p_mode)) {
		_picture.free(); // to change its colour
		_changed();
	}
}

void GrassPath3D::set_width(double p_width) {
	if (replace(_width, checked(WIDTH, p_width, label()))) {
		_changed();
	}
}

void GrassPath3D::set_fade(double p_fade) {
	if (replace(_fade, checked(FADE, p_fade, label()))) {
		_changed();
	}
}

void GrassPath3D::set_field_group(const StringName &p_group) {
	if (replace(_field_group, p_group)) {
		_changed();
	}
}

void GrassPath3D::set_enabled(bool p_enabled) {
	if (replace(_enabled, p_enabled)) {
		_changed();
	}
}

PackedStringArray GrassPath3D::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (get_points().is_empty()) {
		warnings.push_back("This node changes no grass: give its `curve` at least two points.");
	}
	return warnings;
}

void GrassPath3D::_notification(int p_what) {
	if (_nodes.notify(*this, p_what, _picture)) {
		_changed();
	}
}

// Returns the lines along the path's sides where the grass begins to change back.
Ref<ArrayMesh> GrassPath3D::make_picture() const {
	const PackedVector3Array points = get_points();
	PackedVector3Array lines;
	for (int64_t i = 1; i < points.size(); i++) {
		const Vector3 way = points[i] - points[i - 1];
		const Vector3 side = Vector3(way.z, 0, -way.x).normalized() * real_t(0.5 * _width);
		for (const Vector3 &end : { points[i - 1] + side, points[i] + side, points[i - 1] - side, points[i] - side }) {
			lines.push_back(end);
		}
	}
	return EditorPicture::mesh_of(lines);
}

void GrassPath3D::_bind_methods() {
	GRASS_BIND_PROPERTY(GrassPath3D, PropertyInfo(Variant::BOOL, "enabled"), set_enabled, is_enabled);
	GRASS_BIND_PROPERTY(GrassPath3D, PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Clear,Plant"), set_mode, get_mode);
	GRASS_BIND_PROPERTY(GrassPath3D, property_of(WIDTH), set_width, get_width);
	GRASS_BIND_PROPERTY(GrassPath3D, property_of(FADE), set_fade, get_fade);
	GRASS_BIND_PROPERTY(GrassPath3D, PropertyInfo(Variant::STRING_NAME, "field_group"), set_field_group, get_field_group);
	BIND_ENUM_CONSTANT(MODE_CLEAR);
	BIND_ENUM_CONSTANT(MODE_PLANT);
}

} // namespace grass

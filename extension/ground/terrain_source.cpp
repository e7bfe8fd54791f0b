// SPDX-License-Identifier: MIT
#include "ground/terrain_source.h"

#include "shared/convert.h"

#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>

using namespace godot;

namespace grass {

AABB moved(const Transform3D &p_by, const AABB &p_box) {
	Eigen::AlignedBox3d box;
	for (const Vector3 &corner : { p_box.position, p_box.get_end() }) { // a size may be negative
		box.extend(to_eigen(corner));
	}
	box = box.transformed(to_eigen(p_by));
	return AABB(to_godot(box.min()), to_godot(Eigen::Vector3d(box.sizes())));
}

TerrainSource::TerrainSource(Node *p_node, Object *p_data) : _node(p_node->get_instance_id()), _data(p_data->get_instance_id()) {}

Node *TerrainSource::get_node() const {
	return Object::cast_to<Node>(ObjectDB::get_instance(_node));
}

Object *TerrainSource::get_data() const {
	return ObjectDB::get_instance(_data);
}

bool TerrainSource::is_alive() const {
	const Node *node = get_node();
	return node != nullptr && node->is_inside_tree() && get_data() != nullptr;
}

namespace {

// Describes a value for a message: its type, and for an array the number of its elements.
String describe(const Variant &p_value) {
	const String type = Variant::get_type_name(p_value.get_type());
	return p_value.get_type() >= Variant::ARRAY ? vformat("%s of %d", type, Array(p_value).size()) : type;
}

} // namespace

Transform3D TerrainSource::get_transform() const {
	return Transform3D();
}

std::optional<GroundGrid> TerrainSource::grid_of(const Transform3D &p_field, const Transform3D &p_cells) {
	const Transform3D cells = p_field.affine_inverse() * p_cells;
	const auto flat = [](const Vector3 &p_at) { return Eigen::Vector2d(p_at.x, p_at.z); };
	return GroundGrid::of_cells(flat(cells.origin), flat(cells.basis.get_column(0)), flat(cells.basis.get_column(2)));
}

std::optional<GroundGrid> TerrainSource::find_grid(const Transform3D &p_field) {
	static constexpr const char *SPACING = "get_vertex_spacing";
	const Node *node = get_node();
	if (node == nullptr || !node->has_method(SPACING)) {
		return {};
	}
	const double spacing = to_number(ask_node(SPACING), SPACING);
	if (!(spacing > 0.0) || !std::isfinite(spacing)) {
		return {};
	}
	const real_t side = real_t(spacing);
	return grid_of(p_field, Transform3D(Basis(Vector3(side, 0, 0), Vector3(0, side, 0), Vector3(0, 0, side)), Vector3()));
}

AABB TerrainSource::to_area(const Vector2 &, const Vector2 &) const {
	return AABB();
}

Variant TerrainSource::ask_node(const StringName &p_method) {
	Node *node = get_node();
	if (node == nullptr) {
		return Variant();
	}
	_calls++;
	return node->call(p_method);
}

void TerrainSource::complain(const Variant &p_value, const char *p_method, const String &p_wanted) {
	if (_problem.is_empty() && is_alive()) { // otherwise its answer does not count
		_problem = vformat("%s() of '%s' returned %s, not %s. See docs/guide/terrain.md for what it must return.", p_method,
				get_node()->get_name(), describe(p_value), p_wanted);
	}
}

PackedFloat32Array TerrainSource::to_numbers(const Variant &p_value, const char *p_method, int64_t p_count) {
	if (p_value.get_type() == Variant::PACKED_FLOAT32_ARRAY || p_value.get_type() == Variant::PACKED_FLOAT64_ARRAY ||
			p_value.get_type() == Variant::ARRAY) {
		PackedFloat32Array numbers = p_value;
		if (numbers.size() == p_count) {
			return numbers;
		}
	}
	complain(p_value, p_method, vformat("a PackedFloat32Array of %d numbers, one for each place", p_count));
	return PackedFloat32Array();
}

double TerrainSource::to_number(const Variant &p_value, const char *p_method) {
	if (p_value.get_type() == Variant::FLOAT || p_value.get_type() == Variant::INT) {
		return p_value;
	}
	complain(p_value, p_method, "a number");
	return std::numeric_limits<double>::quiet_NaN();
}

Vector3 TerrainSource::to_vector(const Variant &p_value, const char *p_method) {
	if (p_value.get_type() == Variant::VECTOR3) {
		return p_value;
	}
	complain(p_value, p_method, "a Vector3");
	return Vector3();
}

TerrainColor TerrainSource::to_color(const Variant &p_value, const char *p_method) {
	if (p_value.get_type() == Variant::COLOR) {
		const Color color = p_value;
		return TerrainColor::of(color.r, color.g, color.b, color.a);
	}
	complain(p_value, p_method, "a Color");
	return {};
}

TerrainTexel TerrainSource::to_texture(const Variant &p_value, const char *p_method) {
	if (p_value.get_type() == Variant::VECTOR3) {
		const Vector3 shown = p_value;
		return TerrainTexel::of(shown.x, shown.y, shown.z);
	}
	if (p_value.get_type() == Variant::FLOAT || p_value.get_type() == Variant::INT) {
		const double number = p_value;
		return TerrainTexel::of(number, number, 0.0);
	}
	complain(p_value, p_method, "a number or a Vector3");
	return {};
}

} // namespace grass

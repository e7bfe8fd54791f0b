// SPDX-License-Identifier: MIT
#include "editor/painted_fields.h"

#include "editor/field_owner.h"
#include "editor/species_drop.h"
#include "nodes/field_monitors.h"
#include "shared/convert.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cmath>

using namespace godot;

namespace grass {

namespace {

constexpr double FACING = 0.7071; // cosine of 45 degrees, between the upward axes of two fields that one stroke paints

bool holds_middle_of(const GrassField &p_field, const GrassField &p_other) {
	return is_ground_of(p_field, to_field_of(p_field) * to_eigen(p_other.field_transform().origin), 0.0);
}

bool faces_as(const GrassField &p_field, const GrassField &p_other) {
	return p_field.field_transform().basis.get_column(1).dot(p_other.field_transform().basis.get_column(1)) >= real_t(FACING);
}

bool is_neighbour(const GrassField &p_field, const GrassField &p_chosen, const Node *p_root) {
	return is_saved_by(*p_root, p_field) && !find_foreign(p_field) && p_field.is_visible_in_tree() && !p_field.has_meta("_edit_lock_") &&
			p_field.get_world_3d() == p_chosen.get_world_3d() && faces_as(p_field, p_chosen) && !holds_middle_of(p_field, p_chosen) &&
			!holds_middle_of(p_chosen, p_field);
}

// Returns the resource's own name, or the name of its file.
String name_of_species(const Ref<GrassSpecies> &p_species) {
	if (p_species.is_null()) {
		return String();
	}
	const String path = p_species->get_path();
	return p_species->get_name().is_empty() && has_own_file(**p_species) ? path.get_file().get_basename() : p_species->get_name();
}

} // namespace

Eigen::Isometry3d to_field_of(const GrassField &p_field) {
	return Eigen::Isometry3d(to_eigen(p_field.field_transform()).inverse(Eigen::Isometry).matrix());
}

bool is_reached(const GrassField &p_field, const Eigen::Vector2d &p_place, double p_radius) {
	const Eigen::Array2d half = 0.5 * to_eigen(p_field.get_parts().settings.get_size()).array();
	return ((p_place.array().abs() - half).max(0.0)).matrix().norm() <= p_radius;
}

bool is_ground_of(const GrassField &p_field, const Eigen::Vector3d &p_place, double p_margin) {
	const Eigen::Array2d limit = 0.5 * to_eigen(p_field.get_parts().settings.get_size()).array() + p_margin;
	return p_place.allFinite() && std::abs(p_place.x()) <= limit.x() && std::abs(p_place.z()) <= limit.y() &&
			p_field.get_parts().settings.get_ground_band().contains(p_place.y());
}

PaintedFields painted_field(GrassField *p_field) {
	return { p_field, to_field_of(*p_field).inverse(), { p_field } };
}

PaintedFields painted_neighbours(GrassField *p_chosen) {
	PaintedFields painted = painted_field(p_chosen);
	const Node *root = EditorInterface::get_singleton()->get_edited_scene_root();
	if (root == nullptr) {
		return painted;
	}
	for (GrassField *field : FieldMonitors::get_fields()) {
		if (field != p_chosen && is_neighbour(*field, *p_chosen, root)) {
			painted.fields.push_back(field);
		}
	}
	return painted;
}

std::optional<PaintedFields> painted_plots(GrassWorld *p_world) {
	PaintedFields painted{ p_world, Eigen::Isometry3d(to_eigen(p_world->world_transform()).matrix()), {}, p_world };
	const TypedArray<GrassField> fields = p_world->get_fields();
	for (int64_t i = 0; i < fields.size(); i++) {
		painted.fields.push_back(Object::cast_to<GrassField>(fields[i]));
	}
	return painted.fields.empty() ? std::nullopt : std::optional<PaintedFields>(painted);
}

std::optional<int64_t> find_species(const GrassField &p_chosen, int64_t p_species, const GrassField &p_field) {
	return &p_chosen == &p_field ? p_species : find_species(find_grown_species(p_chosen), p_species, find_grown_species(p_field));
}

std::optional<int64_t> find_species(const TypedArray<GrassSpecies> &p_ours, int64_t p_species, const TypedArray<GrassSpecies> &p_theirs) {
	if (p_species == 0) {
		return p_species;
	}
	const Ref<GrassSpecies> wanted = p_species <= p_ours.size() ? Ref<GrassSpecies>(p_ours[p_species - 1]) : Ref<GrassSpecies>();
	if (wanted.is_null()) {
		return {};
	}
	if (const int64_t place = p_theirs.find(wanted); place >= 0) {
		return place + 1;
	}
	const String name = name_of_species(wanted);
	for (int64_t i = 0; i < p_theirs.size() && !name.is_empty(); i++) {
		if (name_of_species(p_theirs[i]) == name) {
			return i + 1;
		}
	}
	return {};
}

} // namespace grass

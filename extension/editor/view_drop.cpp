// SPDX-License-Identifier: MIT
#include "editor/view_drop.h"

#include "editor/ground_picker.h"
#include "editor/species_drop.h"
#include "nodes/field_monitors.h"
#include "shared/convert.h"

#include <godot_cpp/classes/sub_viewport.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <limits>

using namespace godot;

namespace grass {

ViewDrop *ViewDrop::create(int32_t p_view) {
	ViewDrop *drop = memnew(ViewDrop);
	drop->_view = p_view;
	drop->set_anchors_and_offsets_preset(PRESET_FULL_RECT);
	const Node *view = EditorInterface::get_singleton()->get_editor_viewport_3d(p_view);
	view->get_parent()->get_parent()->add_child(drop); // the container of the picture, and the view around it
	return drop;
}

GrassField *ViewDrop::find_field(const Vector2 &p_place) const {
	const Camera3D *camera = EditorInterface::get_singleton()->get_editor_viewport_3d(_view)->get_camera_3d();
	const Node *root = EditorInterface::get_singleton()->get_edited_scene_root();
	GrassField *nearest = nullptr;
	double distance = std::numeric_limits<double>::infinity();
	for (GrassField *field : FieldMonitors::get_fields()) {
		if (camera == nullptr || root == nullptr || (field != root && field->get_owner() != root) || !field->is_visible_in_tree()) {
			continue;
		}
		if (const auto point = pick_ground(painted_field(field), camera, p_place, 0.0)) {
			const Vector3 place = field->field_transform().xform(to_godot(point->position));
			const double here = double((camera->get_global_position() - place).length());
			if (here < distance) {
				distance = here;
				nearest = field;
			}
		}
	}
	return nearest;
}

bool ViewDrop::_can_drop_data(const Vector2 &p_place, const Variant &p_dragged) const {
	return !find_dragged_species(p_dragged).is_empty() && find_field(p_place) != nullptr;
}

void ViewDrop::_drop_data(const Vector2 &p_place, const Variant &p_dragged) {
	if (GrassField *field = find_field(p_place)) {
		emit_signal("species_dropped", field, find_dragged_species(p_dragged));
	}
}

void ViewDrop::_bind_methods() {
	ADD_SIGNAL(MethodInfo("species_dropped", PropertyInfo(Variant::OBJECT, "field"), PropertyInfo(Variant::ARRAY, "species")));
}

} // namespace grass

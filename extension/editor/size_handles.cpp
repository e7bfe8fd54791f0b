// SPDX-License-Identifier: MIT
#include "editor/size_handles.h"

#include "core/paint/handle_drag.h"
#include "nodes/grass_field.h"
#include "shared/convert.h"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_undo_redo_manager.hpp>
#include <godot_cpp/classes/standard_material3d.hpp>

#include <cmath>

using namespace godot;

namespace grass {

namespace {

constexpr double STEP = 0.01; // rounding of sizes, metres, unless the editor snaps
const Color BORDER(0.56f, 0.94f, 0.59f);

GrassField *field_of(const Ref<EditorNode3DGizmo> &p_gizmo) {
	return Object::cast_to<GrassField>(p_gizmo->get_node_3d());
}

double snapped(double p_size) {
	const EditorInterface *editor = EditorInterface::get_singleton();
	const double step = editor->is_node_3d_snap_enabled() ? double(editor->get_node_3d_translate_snap()) : STEP;
	return step > 0.0 ? std::round(p_size / step) * step : p_size;
}

} // namespace

void SizeHandles::create_materials() {
	create_material("border", BORDER);
	create_handle_material("handles");
}

bool SizeHandles::_has_gizmo(Node3D *p_node) const {
	return Object::cast_to<GrassField>(p_node) != nullptr;
}

// Draws border and handles. The gizmo has the node's transform with its scale; the field ignores scale.
void SizeHandles::_redraw(const Ref<EditorNode3DGizmo> &p_gizmo) {
	p_gizmo->clear();
	const GrassField *field = field_of(p_gizmo);
	if (field == nullptr || !field->is_inside_tree()) {
		return;
	}
	const Transform3D to_node = field->get_global_transform().affine_inverse() * field->field_transform();
	const Vector2 half = field->get_parts().settings.get_size() / real_t(2);
	const auto place = [&](real_t p_x, real_t p_z) { return to_node.xform(Vector3(p_x * half.x, 0, p_z * half.y)); };
	PackedVector3Array lines, handles;
	const Vector3 corners[] = { place(-1, -1), place(1, -1), place(1, 1), place(-1, 1) };
	for (int n = 0; n < 4; n++) {
		lines.push_back(corners[n]);
		lines.push_back(corners[(n + 1) % 4]);
	}
	for (const Vector3 &handle : { place(1, 0), place(-1, 0), place(0, 1), place(0, -1) }) {
		handles.push_back(handle);
	}
	p_gizmo->add_lines(lines, get_material("border", p_gizmo));
	p_gizmo->add_handles(handles, get_material("handles", p_gizmo), PackedInt32Array());
}

String SizeHandles::_get_handle_name(const Ref<EditorNode3DGizmo> &, int32_t p_handle, bool) const {
	return p_handle < 2 ? "Size X" : "Size Z";
}

Variant SizeHandles::_get_handle_value(const Ref<EditorNode3DGizmo> &p_gizmo, int32_t, bool) const {
	const GrassField *field = field_of(p_gizmo);
	return field == nullptr ? Vector2() : field->get_parts().settings.get_size();
}

// Moves both sides, since the map is relative to the centre: what was painted stays where it is.
void SizeHandles::_set_handle(const Ref<EditorNode3DGizmo> &p_gizmo, int32_t p_handle, bool, Camera3D *p_camera, const Vector2 &p_mouse) {
	GrassField *field = field_of(p_gizmo);
	if (field == nullptr || p_camera == nullptr) {
		return;
	}
	const Eigen::Isometry3d to_field(to_eigen(field->field_transform()).inverse(Eigen::Isometry).matrix());
	const Eigen::Vector3d axis = (p_handle % 2 == 0 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(p_handle < 2 ? 0 : 2);
	const auto place = drag_along(axis, to_field * to_eigen(p_camera->project_ray_origin(p_mouse)),
			to_field.linear() * to_eigen(p_camera->project_ray_normal(p_mouse)));
	const double size = place ? snapped(2.0 * *place) : 0.0;
	if (size > 0.0) { // a handle dragged past the centre has no effect
		Vector2 changed = field->get_parts().settings.get_size();
		(p_handle < 2 ? changed.x : changed.y) = real_t(size);
		field->get_parts().settings.set_size(changed);
	}
}

void SizeHandles::_commit_handle(const Ref<EditorNode3DGizmo> &p_gizmo, int32_t, bool, const Variant &p_before, bool p_cancel) {
	GrassField *field = field_of(p_gizmo);
	if (field == nullptr) {
		return;
	}
	if (p_cancel) {
		field->get_parts().settings.set_size(p_before);
		return;
	}
	EditorUndoRedoManager *history = EditorInterface::get_singleton()->get_editor_undo_redo();
	history->create_action("Resize Grass Field", UndoRedo::MERGE_DISABLE, field);
	history->add_do_property(field, "size", field->get_parts().settings.get_size());
	history->add_undo_property(field, "size", p_before);
	history->commit_action();
}

} // namespace grass

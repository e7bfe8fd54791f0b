// SPDX-License-Identifier: MIT
// The border of a GrassField in the 3D editor, and handles on its sides that change its size.
#pragma once

#include <godot_cpp/classes/editor_node3d_gizmo.hpp>
#include <godot_cpp/classes/editor_node3d_gizmo_plugin.hpp>

namespace grass {

class SizeHandles : public godot::EditorNode3DGizmoPlugin {
	GDCLASS(SizeHandles, godot::EditorNode3DGizmoPlugin)

public:
	void create_materials();

	bool _has_gizmo(godot::Node3D *p_node) const override;
	godot::String _get_gizmo_name() const override { return "GrassField"; }
	void _redraw(const godot::Ref<godot::EditorNode3DGizmo> &p_gizmo) override;
	// Returns the name of a handle. 0 and 1 are at the sides along x, 2 and 3 along z.
	godot::String _get_handle_name(const godot::Ref<godot::EditorNode3DGizmo> &p_gizmo, int32_t p_handle, bool p_secondary) const override;
	godot::Variant _get_handle_value(
			const godot::Ref<godot::EditorNode3DGizmo> &p_gizmo, int32_t p_handle, bool p_secondary) const override;
	void _set_handle(const godot::Ref<godot::EditorNode3DGizmo> &p_gizmo, int32_t p_handle, bool p_secondary, godot::Camera3D *p_camera,
			const godot::Vector2 &p_mouse) override;
	void _commit_handle(const godot::Ref<godot::EditorNode3DGizmo> &p_gizmo, int32_t p_handle, bool p_secondary,
			const godot::Variant &p_before, bool p_cancel) override;

protected:
	static void _bind_methods() {}
};

} // namespace grass

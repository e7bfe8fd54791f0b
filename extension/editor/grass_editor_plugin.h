// SPDX-License-Identifier: MIT
// Paints grass in the 3D editor: handles mouse and keys while a GrassField or a GrassWorld is selected. Active as soon as the library is
// loaded; there is nothing to enable.
#pragma once

#include "editor/answer_view.h"
#include "editor/brush_preview.h"
#include "editor/brush_toolbar.h"
#include "editor/edited_grass.h"
#include "editor/export_masks.h"
#include "editor/grass_clipboard.h"
#include "editor/grass_export_plugin.h"
#include "editor/ground_watch.h"
#include "editor/map_step.h"
#include "editor/new_nodes.h"
#include "editor/paint_stroke.h"
#include "editor/picture_dialog.h"
#include "editor/ring_view.h"
#include "editor/size_handles.h"
#include "editor/species_drops.h"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/editor_plugin.hpp>
#include <godot_cpp/classes/input_event.hpp>
#include <godot_cpp/classes/input_event_key.hpp>
#include <godot_cpp/classes/input_event_mouse_button.hpp>
#include <godot_cpp/classes/input_event_mouse_motion.hpp>
#include <godot_cpp/variant/dictionary.hpp>

namespace grass {

class GrassEditorPlugin : public godot::EditorPlugin {
	GDCLASS(GrassEditorPlugin, godot::EditorPlugin)

public:
	godot::String _get_plugin_name() const override { return "GrassField"; }
	void _enter_tree() override;
	void _exit_tree() override;
	bool _handles(godot::Object *p_object) const override;
	void _edit(godot::Object *p_object) override;
	void _make_visible(bool p_visible) override;
	// Ends the stroke, writes it to the scene's history, and brings the ground up to date. The editor calls it when it puts the scene
	// aside, or saves it.
	godot::Dictionary _get_state() const override;
	void _apply_changes() override;
	int32_t _forward_3d_gui_input(godot::Camera3D *p_camera, const godot::Ref<godot::InputEvent> &p_event) override;

	// Returns of the last stroke: `steps`, `chunks`, `rays`, `total_us`, `worst_us` (see StrokeCosts), `active`, `left_out`; of the last
	// movement of the mouse, with ring and steps: `event_us`, CPU microseconds; whether the `ring` is shown, and the number of fields that
	// show a `preview`. Of ground that follows what moved: `watch_rays` so far and in one frame at most (`watch_most_rays`), how many
	// pieces wait (`watch_waiting`), and the last look at the scene (`watch_us`).
	godot::Dictionary get_statistics() const;

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	std::optional<PaintedFields> find_painted() const { return _grass.find_painted(_toolbar->paints_neighbours()); }
	int32_t key_input(godot::Camera3D *p_camera, const godot::Ref<godot::InputEventKey> &p_key);
	int32_t button_input(godot::Camera3D *p_camera, const godot::Ref<godot::InputEventMouseButton> &p_button);
	int32_t motion_input(godot::Camera3D *p_camera, const godot::Ref<godot::InputEventMouseMotion> &p_motion);
	// Shows the brush's place, and before a stroke (p_is_hover) what it would do there.
	std::optional<GroundPoint> show_brush(
			godot::Camera3D *p_camera, const godot::Vector2 &p_mouse, const StrokeKeys &p_keys, bool p_is_hover = true);
	void hide_brush();
	int32_t asking_input(godot::Camera3D *p_camera, const godot::Ref<godot::InputEvent> &p_event);
	void finish_stroke();
	void finish_ground();
	void put_down(); // ends the stroke; hides ring, preview and answer
	void change_maps(const char *p_name, const MapChange &p_change);
	void update_toolbar();
	void _node_added(godot::Object *p_node);
	void _node_is_placed(int64_t p_id) { _new_nodes.furnish(uint64_t(p_id)); }
	bool clipboard_pressed(int64_t p_item);
	bool clipboard_key(godot::Camera3D *p_camera, const godot::InputEventKey &p_key);
	void paste(const Eigen::Vector2d &p_middle);
	void _tool_changed();
	void _bake_pressed();
	void _species_dropped(const godot::Array &p_species);
	void _species_dropped_on(godot::Object *p_field, const godot::Array &p_species);
	void make_selected_unique();
	void _menu_pressed(int64_t p_item);
	void _picture_chosen(const godot::String &p_path);

	BrushToolbar *_toolbar = nullptr;
	godot::Ref<GrassExportPlugin> _export_plugin;
	godot::Ref<ExportMasks> _export_masks;
	godot::Ref<SizeHandles> _size_handles;
	EditedGrass _grass;
	NewNodes _new_nodes;
	int _frames_to_offer = 0; // until the plugin looks again whether to offer a bake
	PaintStroke _stroke;
	GroundWatch _watch;
	RingView _ring;
	BrushPreview _preview;
	SpeciesDrops _drops;
	godot::Vector2 _mouse; // last known place
	AnswerView _answer;
	PictureDialog _pictures;
	GrassClipboard _clipboard;
	double _event_us = 0.0;
};

} // namespace grass

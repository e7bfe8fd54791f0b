// SPDX-License-Identifier: MIT
// Copy and paste in the plugin: of what is painted in the whole field or under the brush, and of species.
#include "editor/grass_editor_plugin.h"

#include "editor/toast.h"

#include <godot_cpp/classes/viewport.hpp>

using namespace godot;

namespace grass {

namespace {

bool is_too_large(double p_area) {
	if (p_area > CopiedArea::LARGEST) {
		toast(vformat(
				"GrassField: at most %d square metres can be copied at once. Copy a part with the brush, or duplicate the whole field.",
				int64_t(CopiedArea::LARGEST)));
	}
	return p_area > CopiedArea::LARGEST;
}

} // namespace

// Returns whether it was one of the clipboard's items.
bool GrassEditorPlugin::clipboard_pressed(int64_t p_item) {
	const GrassField *field = _grass.find_field();
	if (field == nullptr || p_item < BrushMenu::COPY || p_item > BrushMenu::PASTE_SPECIES) {
		return false;
	}
	finish_stroke();
	const Vector2 size = field->get_parts().settings.get_size();
	if (p_item == BrushMenu::COPY && !is_too_large(double(size.x) * double(size.y))) {
		_clipboard.copy_field(*field);
		toast("GrassField: copied what is painted in the field.", EditorToaster::SEVERITY_INFO);
	} else if (p_item == BrushMenu::PASTE) {
		if (_clipboard.is_of_field()) {
			paste(Eigen::Vector2d::Zero());
		} else {
			toast("GrassField: no field was copied. Choose Copy Grass for one, or press Ctrl+V with a tool in hand to paste what was "
				  "copied "
				  "under the brush.");
		}
	} else if (p_item == BrushMenu::COPY_SPECIES) {
		_clipboard.copy_species(*field);
		toast(vformat("GrassField: copied %d species.", _clipboard.count_species()), EditorToaster::SEVERITY_INFO);
	} else if (p_item == BrushMenu::PASTE_SPECIES) {
		if (_clipboard.count_species() == 0) {
			toast("GrassField: no species were copied. Select another field and choose Copy Species.");
		} else {
			_species_dropped(_clipboard.make_palette());
		}
	}
	return true;
}

// Returns whether the keys are the engine's for copy or paste, and the ring is on the ground: otherwise they are for nodes.
bool GrassEditorPlugin::clipboard_key(Camera3D *p_camera, const InputEventKey &p_key) {
	const bool is_copy = p_key.get_keycode() == KEY_C, is_paste = p_key.get_keycode() == KEY_V;
	if (!(is_copy || is_paste) || !p_key.is_command_or_control_pressed() || p_key.is_shift_pressed() || p_key.is_alt_pressed()) {
		return false;
	}
	finish_stroke();
	const auto point = _ring.is_shown() ? show_brush(p_camera, _mouse, {}) : std::nullopt;
	if (!point) {
		return false;
	}
	get_viewport()->set_input_as_handled();
	const GrassField *field = _grass.find_field();
	const double radius = _toolbar->get_brush()->get_reach();
	if (field == nullptr || !is_reached(*field, point->place(), radius)) {
		toast("GrassField: copy and paste act on the selected field. Select the field that you point at.");
	} else if (is_copy && !is_too_large(4.0 * radius * radius)) {
		_clipboard.copy_circle(*field, point->place(), radius);
		toast("GrassField: copied what is painted under the brush.", EditorToaster::SEVERITY_INFO);
	} else if (is_paste && !_clipboard.has_grass()) {
		toast("GrassField: nothing was copied. Press Ctrl+C over grass, with a tool in hand.");
	} else if (is_paste) {
		paste(point->place());
	}
	return true;
}

// Pastes what was copied. p_middle: x, z in metres from the selected field's centre.
void GrassEditorPlugin::paste(const Eigen::Vector2d &p_middle) {
	if (!_grass.may_change([this, p_middle] { paste(p_middle); })) {
		return;
	}
	int missing = 0;
	change_maps("Paste Grass", [&](const GrassField &p_field, GrassMap &r_map) {
		missing = _clipboard.paste(p_field, r_map, p_middle);
		return true;
	});
	if (missing > 0) {
		toast(vformat("GrassField: %d species were not planted, since the field does not grow them. Choose Copy Species for the field that "
					  "does, and Paste Species here.",
				missing));
	}
}

} // namespace grass

// SPDX-License-Identifier: MIT
// Text beside the cursor in the editor's 3D views: why there is no grass at that place.
#pragma once

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/label.hpp>
#include <godot_cpp/classes/panel_container.hpp>

namespace grass {

class AnswerView {
public:
	void create(); // in the editor's window
	void free();
	// Shows a text. p_mouse: in p_camera's view, as in its input events.
	void show(const godot::Camera3D *p_camera, const godot::Vector2 &p_mouse, const godot::String &p_text);
	void hide();
	godot::String get_text() const { return _panel != nullptr && _panel->is_visible() ? _label->get_text() : godot::String(); }

private:
	godot::PanelContainer *_panel = nullptr;
	godot::Label *_label = nullptr;
};

} // namespace grass

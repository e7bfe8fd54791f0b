// SPDX-License-Identifier: MIT
#include "editor/answer_view.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/sub_viewport_container.hpp>
#include <godot_cpp/classes/text_server.hpp>
#include <godot_cpp/classes/viewport.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// In the editor's unscaled pixels: distance of the text from the cursor, and its width.
constexpr double BESIDE = 18.0, LABEL_WIDTH = 300.0;

} // namespace

void AnswerView::create() {
	const double scale = EditorInterface::get_singleton()->get_editor_scale();
	_panel = memnew(PanelContainer);
	_panel->set_name("GrassAnswer");
	_panel->set_theme_type_variation("TooltipPanel");
	_panel->set_mouse_filter(Control::MOUSE_FILTER_IGNORE);
	_panel->set_as_top_level(true);
	_panel->set_z_index(1);
	_panel->hide();
	_label = memnew(Label);
	_label->set_theme_type_variation("TooltipLabel");
	_label->set_mouse_filter(Control::MOUSE_FILTER_IGNORE);
	_label->set_autowrap_mode(TextServer::AUTOWRAP_WORD);
	_label->set_custom_minimum_size(Vector2(real_t(LABEL_WIDTH * scale), 0));
	_panel->add_child(_label);
	EditorInterface::get_singleton()->get_base_control()->add_child(_panel);
}

void AnswerView::free() {
	if (_panel != nullptr) {
		_panel->queue_free();
	}
	_panel = nullptr;
	_label = nullptr;
}

void AnswerView::show(const Camera3D *p_camera, const Vector2 &p_mouse, const String &p_text) {
	const Control *view = Object::cast_to<Control>(p_camera->get_viewport()->get_parent());
	if (_panel == nullptr || view == nullptr) {
		return;
	}
	_label->set_text(p_text);
	_panel->reset_size();
	_panel->show();
	const real_t beside = real_t(BESIDE * EditorInterface::get_singleton()->get_editor_scale());
	const Vector2 first = view->get_global_position(), room = view->get_size() - _panel->get_size();
	const Vector2 at = p_mouse + Vector2(beside, beside); // within the view
	_panel->set_global_position(first + Vector2(std::max(real_t(0), std::min(at.x, room.x)), std::max(real_t(0), std::min(at.y, room.y))));
}

void AnswerView::hide() {
	if (_panel != nullptr) {
		_panel->hide();
	}
}

} // namespace grass

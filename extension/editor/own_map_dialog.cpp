// SPDX-License-Identifier: MIT
#include "editor/own_map_dialog.h"

#include "editor/unique_field.h"

#include <godot_cpp/classes/button.hpp>
#include <godot_cpp/classes/control.hpp>
#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/packed_scene.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <utility>

using namespace godot;

namespace grass {

namespace {

constexpr real_t TEXT_WIDTH = 480; // in the editor's unscaled pixels

String text_for(const GrassField &p_field, const ForeignField &p_foreign) {
	const String file = p_foreign.file.is_empty() ? String("a script's node") : p_foreign.file.get_file();
	return p_foreign.has_own_properties
			? vformat("The map of GrassField '%s' is a part of %s. This scene does not save changes of it.\n\nMake Unique: the field gets "
					  "a map "
					  "of its own in this scene, with the same grass.\nOpen Scene: paint there, and all fields with this map change.",
					  p_field.get_name(), file)
			: vformat("GrassField '%s' is a part of %s. This scene does not save changes of it.\n\nOpen that scene, or turn on Editable "
					  "Children for its instance.",
					  p_field.get_name(), file);
}

} // namespace

OwnMapDialog *OwnMapDialog::_singleton = nullptr;

void OwnMapDialog::create() {
	OwnMapDialog *dialog = _singleton = memnew(OwnMapDialog);
	dialog->set_name("GrassOwnMap");
	dialog->set_title("Map of Another Scene");
	dialog->set_autowrap(true);
	dialog->set_ok_button_text("Make Unique");
	dialog->_opener = dialog->add_button("Open Scene", false, "open");
	dialog->connect("confirmed", callable_mp(dialog, &OwnMapDialog::_make_own));
	dialog->connect("custom_action", callable_mp(dialog, &OwnMapDialog::_open));
	EditorInterface::get_singleton()->get_base_control()->add_child(dialog);
}

void OwnMapDialog::free() {
	_singleton->queue_free();
	_singleton = nullptr;
}

bool OwnMapDialog::may_change(const GrassField &p_field, const std::function<void()> &p_then) {
	return _singleton->allow(p_field, find_foreign(p_field), p_then);
}

bool OwnMapDialog::may_set(const GrassField &p_field) {
	return _singleton->allow(p_field, find_foreign(p_field, false), {});
}

bool OwnMapDialog::allow(const GrassField &p_field, const std::optional<ForeignField> &p_foreign, const std::function<void()> &p_then) {
	if (!p_foreign) {
		return true;
	}
	_field = p_field.get_instance_id();
	_file = p_foreign->file;
	_then = p_then;
	set_text(text_for(p_field, *p_foreign));
	get_ok_button()->set_visible(p_foreign->has_own_properties);
	_opener->set_visible(ResourceLoader::get_singleton()->exists(_file, "PackedScene"));
	popup_centered(Vector2i(Vector2(TEXT_WIDTH, 0) * EditorInterface::get_singleton()->get_editor_scale()));
	return false;
}

void OwnMapDialog::_make_own() {
	GrassField *field = Object::cast_to<GrassField>(ObjectDB::get_instance(_field));
	if (field == nullptr || !field->is_inside_tree()) {
		return;
	}
	make_map_unique(*field);
	if (const std::function<void()> then = std::exchange(_then, nullptr)) {
		then();
	}
}

void OwnMapDialog::_open(const StringName &) {
	hide();
	EditorInterface::get_singleton()->open_scene_from_path(_file);
}

} // namespace grass

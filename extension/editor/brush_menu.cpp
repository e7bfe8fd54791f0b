// SPDX-License-Identifier: MIT
#include "editor/brush_menu.h"

#include <godot_cpp/classes/popup_menu.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

BrushMenu::BrushMenu() {
	set_name("Menu");
	set_flat(true);
	set_tooltip_text("The whole field.");
	add(BARE, "Bare Field", "Only what you paint from now on grows.");
	add(FULL, "Full Field", "Grass grows everywhere except where you erase it from now on.");
	get_popup()->add_separator();
	add(CLEAR, "Clear Everything Painted", "");
	add(COPY, "Copy Grass", "What is painted in the field. Ctrl+C with a tool in hand copies what is under the brush.");
	add(PASTE, "Paste Grass", "Paints the field as the one that was copied. Ctrl+V with a tool in hand pastes under the brush.");
	add(COPY_SPECIES, "Copy Species", "The field's species, for another field.");
	add(PASTE_SPECIES, "Paste Species", "The field grows the copied species beside its own.");
	add(UNIQUE, "Make Unique", "Gives the field copies of its own of the map, and of the rule, species and patches that are not files.");
	get_popup()->add_separator();
	add(EXPORT, String::utf8("Export Picture\u2026"), "Saves a channel of the map as PNG or EXR.");
	add(IMPORT, String::utf8("Import Picture\u2026"), "Reads a PNG or an EXR into a channel of the map.");
	get_popup()->add_separator();
	add_check(FOLLOW, "Bake Ground by Itself", "Reads the ground under the brush, and wherever the ground or the field was moved.");
	add_check(NEIGHBOURS, "Paint Neighbours",
			"The brush paints all fields that it reaches, each on its own map, except locked and hidden ones.");
	get_popup()->connect("id_pressed", callable_mp(this, &BrushMenu::_item_pressed));
}

void BrushMenu::add(Item p_item, const String &p_text, const char *p_tooltip) {
	get_popup()->add_item(p_text, p_item);
	get_popup()->set_item_tooltip(index_of(p_item), p_tooltip);
}

void BrushMenu::add_check(Item p_item, const char *p_text, const char *p_tooltip) {
	get_popup()->add_check_item(p_text, p_item);
	get_popup()->set_item_checked(index_of(p_item), true);
	get_popup()->set_item_tooltip(index_of(p_item), p_tooltip);
}

int32_t BrushMenu::index_of(int64_t p_item) const {
	return get_popup()->get_item_index(int32_t(p_item));
}

bool BrushMenu::is_checked(Item p_item) const {
	return get_popup()->is_item_checked(index_of(p_item));
}

void BrushMenu::fit_to_world(bool p_is_world) {
	for (const Item item : { BARE, FULL, CLEAR, NEIGHBOURS, UNIQUE, COPY, PASTE, COPY_SPECIES, PASTE_SPECIES }) {
		get_popup()->set_item_disabled(index_of(item), p_is_world);
	}
}

void BrushMenu::_item_pressed(int64_t p_item) {
	if (get_popup()->is_item_checkable(index_of(p_item))) {
		get_popup()->toggle_item_checked(index_of(p_item));
	} else {
		emit_signal("item_chosen", p_item);
	}
}

void BrushMenu::_bind_methods() {
	ADD_SIGNAL(MethodInfo("item_chosen", PropertyInfo(Variant::INT, "item")));
}

} // namespace grass

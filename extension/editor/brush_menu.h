// SPDX-License-Identifier: MIT
// The toolbar's menu: what acts on the whole field, and what the brush does by itself. The plugin does both.
#pragma once

#include <godot_cpp/classes/menu_button.hpp>

namespace grass {

class BrushMenu : public godot::MenuButton {
	GDCLASS(BrushMenu, godot::MenuButton)

public:
	enum Item { BARE, FULL, CLEAR, FOLLOW, NEIGHBOURS, EXPORT, IMPORT, UNIQUE, COPY, PASTE, COPY_SPECIES, PASTE_SPECIES };

	BrushMenu();

	bool is_checked(Item p_item) const; // FOLLOW, NEIGHBOURS
	void fit_to_world(bool p_is_world); // disables what acts on whole fields for a world, since only part of it is in memory

protected:
	static void _bind_methods();

private:
	void add(Item p_item, const godot::String &p_text, const char *p_tooltip);
	void add_check(Item p_item, const char *p_text, const char *p_tooltip);
	int32_t index_of(int64_t p_item) const;
	void _item_pressed(int64_t p_item);
};

} // namespace grass

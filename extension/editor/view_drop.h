// SPDX-License-Identifier: MIT
// Covers a 3D view while species are dragged, and accepts a drop on a field.
#pragma once

#include <godot_cpp/classes/control.hpp>
#include <godot_cpp/classes/editor_interface.hpp>

namespace grass {

class GrassField;

class ViewDrop : public godot::Control {
	GDCLASS(ViewDrop, godot::Control)

public:
	// Covers one of the editor's four 3D views.
	static ViewDrop *create(int32_t p_view);

	bool _can_drop_data(const godot::Vector2 &p_place, const godot::Variant &p_dragged) const override;
	void _drop_data(const godot::Vector2 &p_place, const godot::Variant &p_dragged) override;

protected:
	static void _bind_methods();

private:
	GrassField *find_field(const godot::Vector2 &p_place) const; // the nearest field of the edited scene at that place, or null

	int32_t _view = 0;
};

} // namespace grass

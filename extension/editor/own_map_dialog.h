// SPDX-License-Identifier: MIT
// Asks before something is changed that the edited scene would not save, since the field's map is a part of another scene: the field can
// get a map of its own, or the other scene is opened.
#pragma once

#include "editor/field_owner.h"

#include <godot_cpp/classes/button.hpp>
#include <godot_cpp/classes/confirmation_dialog.hpp>

#include <functional>

namespace grass {

class OwnMapDialog : public godot::ConfirmationDialog {
	GDCLASS(OwnMapDialog, godot::ConfirmationDialog)

public:
	static void create(); // in the editor's window
	static void free();
	// Returns whether the edited scene saves changes of the field's map. If not, asks the user, and runs p_then once the field has a map of
	// its own.
	static bool may_change(const GrassField &p_field, const std::function<void()> &p_then = {});
	// Returns whether the edited scene saves the field's properties. If not, says so.
	static bool may_set(const GrassField &p_field);

protected:
	static void _bind_methods() {}

private:
	bool allow(const GrassField &p_field, const std::optional<ForeignField> &p_foreign, const std::function<void()> &p_then);
	void _make_own();
	void _open(const godot::StringName &p_action);

	static OwnMapDialog *_singleton;
	uint64_t _field = 0; // instance id
	godot::String _file; // that has the map
	std::function<void()> _then;
	godot::Button *_opener = nullptr;
};

} // namespace grass

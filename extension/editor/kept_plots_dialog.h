// SPDX-License-Identifier: MIT
// Asks what to do with plots that were painted and not saved, when the world's folder or the size of its plots has changed.
#pragma once

#include <godot_cpp/classes/confirmation_dialog.hpp>

namespace grass {

class GrassWorld;

class KeptPlotsDialog : public godot::ConfirmationDialog {
	GDCLASS(KeptPlotsDialog, godot::ConfirmationDialog)

public:
	static void create(); // in the editor's window
	static void free();
	static void ask(GrassWorld &r_world); // in the next frame, since a property is being set

protected:
	static void _bind_methods() {}

private:
	void _show();
	void _bring();
	void _act(const godot::StringName &p_action);
	GrassWorld *find_world() const;

	static KeptPlotsDialog *_singleton;
	uint64_t _world = 0; // instance id
};

} // namespace grass

// SPDX-License-Identifier: MIT
#include "editor/kept_plots_dialog.h"

#include "world/grass_world.h"

#include <godot_cpp/classes/control.hpp>
#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

constexpr char DISCARD[] = "discard";

} // namespace

KeptPlotsDialog *KeptPlotsDialog::_singleton = nullptr;

void KeptPlotsDialog::create() {
	KeptPlotsDialog *dialog = _singleton = memnew(KeptPlotsDialog);
	dialog->set_name("GrassKeptPlots");
	dialog->set_title("Plots That Are Not Saved");
	dialog->set_ok_button_text("Bring Over");
	dialog->set_cancel_button_text("Keep");
	dialog->add_button("Discard", false, DISCARD);
	dialog->connect("confirmed", callable_mp(dialog, &KeptPlotsDialog::_bring));
	dialog->connect("custom_action", callable_mp(dialog, &KeptPlotsDialog::_act));
	EditorInterface::get_singleton()->get_base_control()->add_child(dialog);
}

void KeptPlotsDialog::free() {
	_singleton->queue_free();
	_singleton = nullptr;
}

void KeptPlotsDialog::ask(GrassWorld &r_world) {
	if (_singleton != nullptr) {
		_singleton->_world = r_world.get_instance_id();
		callable_mp(_singleton, &KeptPlotsDialog::_show).call_deferred();
	}
}

GrassWorld *KeptPlotsDialog::find_world() const {
	return Object::cast_to<GrassWorld>(ObjectDB::get_instance(_world));
}

void KeptPlotsDialog::_show() {
	const GrassWorld *world = find_world();
	if (world == nullptr || world->count_kept_elsewhere() == 0) { // undone meanwhile
		return;
	}
	set_text(vformat("%d plots of GrassWorld '%s' were painted and not saved. They belong to another folder, or to another `plot_size`.\n\n"
					 "Bring Over: they become plots of '%s' and replace its own plots at the same places. Plots of another size stay in "
					 "memory.\nKeep: they stay in memory. They are saved with the scene to their own folder, if they have one.\nDiscard: "
					 "their changes are lost.",
			world->count_kept_elsewhere(), world->get_name(), world->get_folder()));
	popup_centered();
}

void KeptPlotsDialog::_bring() {
	if (GrassWorld *world = find_world()) {
		world->carry_unsaved();
		EditorInterface::get_singleton()->mark_scene_as_unsaved();
	}
}

void KeptPlotsDialog::_act(const StringName &p_action) {
	GrassWorld *world = find_world();
	if (p_action == StringName(DISCARD) && world != nullptr) {
		world->discard_kept_elsewhere();
	}
	hide();
}

} // namespace grass

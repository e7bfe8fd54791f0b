// SPDX-License-Identifier: MIT
#include "editor/save_worlds.h"

#include "world/grass_world.h"

#include <godot_cpp/classes/editor_file_system.hpp>
#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_toaster.hpp>

using namespace godot;

namespace grass {

namespace {

void warn(const String &p_text) {
	EditorInterface::get_singleton()->get_editor_toaster()->push_toast(p_text, EditorToaster::SEVERITY_WARNING);
}

} // namespace

void save_world(GrassWorld &r_world) {
	r_world.wait_for_files(); // including plots that have just left memory
	if (!r_world.has_unsaved()) {
		return;
	}
	if (r_world.get_folder().is_empty()) {
		warn(vformat("GrassWorld '%s': the painted grass is not saved yet. Set the world's `folder` and save again.", r_world.get_name()));
		return;
	}
	r_world.save();
	r_world.wait_for_files();
	if (const int64_t elsewhere = r_world.count_kept_elsewhere(); elsewhere > 0) {
		warn(vformat("GrassWorld '%s': %d plots that were painted for another folder or `plot_size` are not saved. Restore the old value "
					 "and save again.",
				r_world.get_name(), elsewhere));
	} else if (const String problem = r_world.find_folder_problem(); r_world.has_unsaved() && !problem.is_empty()) {
		warn(vformat("GrassWorld '%s': the painted grass is not saved. %s", r_world.get_name(), problem));
	} else if (r_world.has_unsaved()) {
		warn(vformat("GrassWorld '%s': some painted plots cannot be written to '%s'. They stay in memory. Free space there and save again.",
				r_world.get_name(), r_world.get_folder()));
	}
	EditorInterface::get_singleton()->get_resource_filesystem()->scan(); // new files are exported only once the editor knows them
}

} // namespace grass

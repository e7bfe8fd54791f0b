// SPDX-License-Identifier: MIT
#include "editor/picture_dialog.h"

#include <godot_cpp/classes/control.hpp>
#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/core/memory.hpp>

using namespace godot;

namespace grass {

namespace {

constexpr char CHANNEL[] = "Channel";

} // namespace

void PictureDialog::create(const Callable &p_chosen) {
	_dialog = memnew(EditorFileDialog);
	_dialog->set_name("GrassPictureDialog");
	_dialog->set_access(FileDialog::ACCESS_FILESYSTEM); // pictures come from other programs
	_dialog->set_mode_overrides_title(false);
	_dialog->add_filter("*.png", "8 bit");
	_dialog->add_filter("*.exr", "floats");
	PackedStringArray channels;
	for (const MapChannelInfo &info : MAP_CHANNEL_INFO) {
		channels.push_back(String(info.name).capitalize());
	}
	_dialog->add_option(CHANNEL, channels, MAP_DENSITY);
	_dialog->connect("file_selected", p_chosen);
	EditorInterface::get_singleton()->get_base_control()->add_child(_dialog);
}

void PictureDialog::free() {
	_dialog->queue_free();
	_dialog = nullptr;
}

void PictureDialog::ask(bool p_is_import) {
	_dialog->set_file_mode(p_is_import ? FileDialog::FILE_MODE_OPEN_FILE : FileDialog::FILE_MODE_SAVE_FILE);
	_dialog->set_title(p_is_import ? "Import a Picture into the Map" : "Export a Channel of the Map as a Picture");
	_dialog->popup_file_dialog();
}

GrassMap::Channel PictureDialog::get_channel() const {
	return GrassMap::Channel(int64_t(_dialog->get_selected_options()[CHANNEL]));
}

} // namespace grass

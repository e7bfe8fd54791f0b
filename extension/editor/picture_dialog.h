// SPDX-License-Identifier: MIT
// Asks for a channel of the map and for the file of its picture, to export it or to import it.
#pragma once

#include "resources/grass_map.h"

#include <godot_cpp/classes/editor_file_dialog.hpp>

namespace grass {

class PictureDialog {
public:
	void create(const godot::Callable &p_chosen); // called with the path
	void free();
	void ask(bool p_is_import);

	bool is_import() const { return _dialog->get_file_mode() == godot::FileDialog::FILE_MODE_OPEN_FILE; }
	GrassMap::Channel get_channel() const;

private:
	godot::EditorFileDialog *_dialog = nullptr;
};

} // namespace grass

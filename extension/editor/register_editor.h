// SPDX-License-Identifier: MIT
// What the library registers in an editor, with the class reference. Platforms without one leave this room out (GRASS_WITHOUT_EDITOR).
#pragma once

namespace grass {

void register_editor();

} // namespace grass

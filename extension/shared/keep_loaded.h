// SPDX-License-Identifier: MIT
// Keeps this library in memory until the process ends.
#pragma once

namespace grass {

// Must be called when the engine enters the library. The engine unloads it before it frees its own last objects, and calls the library for
// each object that the library ever used: for example, a resource that an export has changed outlives the editor.
void keep_library_loaded();

} // namespace grass

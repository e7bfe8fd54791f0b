// SPDX-License-Identifier: MIT
// Writes what was painted on the plots of a world when its scene is saved.
#pragma once

namespace grass {

class GrassWorld;

// Must be called right after its scene was saved. Returns once the files are written; reports those that cannot be written.
void save_world(GrassWorld &r_world);

} // namespace grass

// SPDX-License-Identifier: MIT
// What was painted on the plots of a world, written with its scene.
#pragma once

namespace grass {

class GrassWorld;

// Call it right after its scene was saved. Returns once the files are written; reports those that cannot be.
void save_world(GrassWorld &r_world);

} // namespace grass

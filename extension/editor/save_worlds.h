// SPDX-License-Identifier: MIT
// What was painted on the plots of a world, written with its scene.
#pragma once

namespace grass {

class GrassWorld;

// Its scene was saved just now. Returns once the files are written; tells the user of what cannot be.
void save_world(GrassWorld &r_world);

} // namespace grass

// SPDX-License-Identifier: MIT
// What the map's file and its changes are written with.
#pragma once

#include "core/base/bytes.h"
#include "core/map/map_file.h"

namespace grass {

// Whether the channel may hold these.
bool are_codes(const MapTexels &p_texels, const MapChannelInfo &p_info);

} // namespace grass

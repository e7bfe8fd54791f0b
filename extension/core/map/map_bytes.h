// SPDX-License-Identifier: MIT
// The functions that write the map's file and its changes.
#pragma once

#include "core/base/bytes.h"
#include "core/map/map_file.h"

namespace grass {

// Returns true if these are valid codes of the channel.
bool are_codes(const MapTexels &p_texels, const MapChannelInfo &p_info);

} // namespace grass

// SPDX-License-Identifier: MIT
// How large what comes from elsewhere may be, as project settings: maps that are read, messages that change them, pictures.
#pragma once

#include "core/map/read_limits.h"

namespace grass {

// Once, before anything is read.
void register_size_limits();
// On any thread.
ReadLimits get_read_limits();

} // namespace grass

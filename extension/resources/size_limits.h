// SPDX-License-Identifier: MIT
// Limits on the size of external data, as project settings: maps that are read, messages that change them, pictures, records.
#pragma once

#include "core/map/read_limits.h"

namespace grass {

// Must be called once, before anything is read.
void register_size_limits();
// Returns the limits. May be called on any thread.
ReadLimits get_read_limits();
size_t get_record_limit(); // bytes of a file of GrassField.record(), written or read

} // namespace grass

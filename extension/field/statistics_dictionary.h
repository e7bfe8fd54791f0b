// SPDX-License-Identifier: MIT
#pragma once

#include "core/field/field_statistics.h"

#include <godot_cpp/variant/dictionary.hpp>

namespace grass {

// Returns the result of get_statistics(): the values that users read, with version, device and driver.
godot::Dictionary statistics_dictionary(const FieldStatistics &p_statistics);
// Returns the result of get_counters(): the rest, for tests and benchmarks.
godot::Dictionary counters_dictionary(const FieldStatistics &p_statistics);

} // namespace grass

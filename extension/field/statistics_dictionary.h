// SPDX-License-Identifier: MIT
#pragma once

#include "core/field/field_statistics.h"

#include <godot_cpp/variant/dictionary.hpp>

namespace grass {

// As get_statistics() returns them: what users read, with version, device and driver.
godot::Dictionary statistics_dictionary(const FieldStatistics &p_statistics);
// As get_counters() returns them: the rest, for tests and benchmarks.
godot::Dictionary counters_dictionary(const FieldStatistics &p_statistics);

} // namespace grass

// SPDX-License-Identifier: MIT
#pragma once

#include "core/field/field_statistics.h"

#include <godot_cpp/variant/dictionary.hpp>

namespace grass {

// As get_statistics() returns them, with version, device and driver.
godot::Dictionary to_dictionary(const FieldStatistics &p_statistics);

} // namespace grass

// SPDX-License-Identifier: MIT
// The most that one call of a script does. A call for more does nothing but print an error, since it would stop the game for seconds. Each
// limit is a constant of the class by the same name.
#pragma once

#include <cstdint>

namespace grass {

// Blades that a query reads: those within 32 m, in a field of the default density.
inline constexpr int64_t BLADES_MAX = 1 << 20;
// Ground that a call changes or a query reads, seen from above, m^2: 1,024 m x 1,024 m.
inline constexpr int64_t AREA_MAX = 1 << 20;
// Ground that rays read: 512 m x 512 m, a ray for each square metre.
inline constexpr int64_t RAYS_AREA_MAX = 1 << 18;
// Length of a line through the grass, metres.
inline constexpr int64_t COVER_DISTANCE_MAX = 256;

} // namespace grass

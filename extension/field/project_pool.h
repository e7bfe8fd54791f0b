// SPDX-License-Identifier: MIT
// The number of tiles that all fields of the project together may have awake, by a project setting and the level of quality. Main thread.
#pragma once

#include "core/tiles/pool_budget.h"

#include <memory>

namespace grass {

inline constexpr const char *POOL_SETTING = "grass_field/limits/pool_tiles";

// Must be called once, before any field is made.
void register_project_pool();
std::shared_ptr<PoolBudget> project_pool();
// Reads the setting and the level again.
void update_project_pool();

} // namespace grass

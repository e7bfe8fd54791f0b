// SPDX-License-Identifier: MIT
#include "field/project_pool.h"

#include "core/tiles/tile_params.h"
#include "resources/grass_quality.h"
#include "shared/params.h"

#include <godot_cpp/classes/project_settings.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

void register_project_pool() {
	// Usually 1,024 to 16,384; a tile takes some 32 KB of the graphics card or of main memory while it is awake. Too few: grass does
	// not bend under bodies far from the cameras.
	const String hint = vformat("0,%d,1", int64_t(PoolBudget::MOST_TILES));
	add_project_setting(POOL_SETTING, int64_t(TileParams().pool_size), PROPERTY_HINT_RANGE, hint);
}

std::shared_ptr<PoolBudget> project_pool() {
	static const std::shared_ptr<PoolBudget> pool = std::make_shared<PoolBudget>();
	return pool;
}

void update_project_pool() {
	const int64_t tiles = ProjectSettings::get_singleton()->get_setting_with_override(POOL_SETTING);
	const double scaled = double(std::max<int64_t>(tiles, 0)) * current_quality().factor(QUALITY_POOL_TILES);
	project_pool()->set_slots(int(std::min(std::ceil(scaled), double(PoolBudget::MOST_TILES))));
}

} // namespace grass

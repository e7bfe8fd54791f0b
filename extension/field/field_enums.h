// SPDX-License-Identifier: MIT
// The enums of a GrassField's properties. The class inherits them, so scripts call them GrassField.METHOD_DIRECT and so on.
#pragma once

#include "core/field/field_params.h"

#include <cstdint>

namespace grass {

struct FieldEnums {
	enum SolverMethod : int64_t {
		METHOD_DIRECT = int(Method::DIRECT),
		METHOD_PBD = int(Method::PBD),
	};
	enum SimulationDetail : int64_t {
		SIMULATION_SEEN = int(grass::SimulationDetail::SEEN),
		SIMULATION_WHOLE = int(grass::SimulationDetail::WHOLE),
	};
	enum SleepMode : int64_t {
		SLEEP_TIMER = int(grass::SleepMode::TIMER),
		SLEEP_ENERGY = int(grass::SleepMode::ENERGY),
	};
	enum BackendMode : int64_t {
		BACKEND_AUTO, // GPU if the renderer has a RenderingDevice, otherwise CPU
		BACKEND_CPU,
	};
	enum DebugView : int64_t {
		DEBUG_VIEW_OFF = GRASS_DEBUG_OFF,
		DEBUG_VIEW_AWAKE_TILES = GRASS_DEBUG_AWAKE,
		DEBUG_VIEW_LOD = GRASS_DEBUG_LOD,
		DEBUG_VIEW_DENSITY = GRASS_DEBUG_DENSITY,
		DEBUG_VIEW_COST = GRASS_DEBUG_COST,
		DEBUG_VIEW_SIMULATED = GRASS_DEBUG_SIMULATED,
	};
};

} // namespace grass

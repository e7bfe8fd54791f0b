// SPDX-License-Identifier: MIT
// Every number and colour of a GrassSpecies that a user may set, in the inspector's order.
#pragma once

#include "core/plants/species.h"
#include "core/solver/solver_params.h"
#include "core/wear/recovery.h"
#include "draw/look_params.h"

#include <array>

namespace grass {

enum SpeciesParamId {
	SPECIES_PARAM_SHARE,
	SPECIES_PARAM_STAND_SIZE,
	SPECIES_PARAM_STAND_STRENGTH,
	SPECIES_PARAM_NATURAL_FREQUENCY,
	SPECIES_PARAM_DAMPING_RATIO,
	SPECIES_PARAM_TAPER,
	SPECIES_PARAM_ROOT_STIFFNESS,
	SPECIES_PARAM_BEND_STIFFNESS,
	SPECIES_PARAM_WEAR_RECOVERY,
	SPECIES_PARAM_DRY,
	SPECIES_PARAM_CARD_SHARE,
	SPECIES_PARAM_CARD_WIDTH,
	SPECIES_PARAM_CARD_HEIGHT,
	SPECIES_PARAM_COUNT,
};

inline constexpr std::array<Tunable, SPECIES_PARAM_COUNT> SPECIES_PARAMS = { SPECIES_SHARE, STAND_SIZE, STAND_STRENGTH, NATURAL_FREQUENCY,
	DAMPING_RATIO, TAPER, ROOT_STIFFNESS, BEND_STIFFNESS, WEAR_RECOVERY, DRY, CARD_SHARE, CARD_WIDTH, CARD_HEIGHT };

enum SpeciesColorId { SPECIES_ROOT_COLOR, SPECIES_TIP_COLOR, SPECIES_DRY_COLOR, SPECIES_CARD_COLOR, SPECIES_COLOR_COUNT };

inline constexpr std::array<NamedColor, SPECIES_COLOR_COUNT> SPECIES_COLORS = { ROOT_COLOR, TIP_COLOR, DRY_COLOR,
	{ "card_color", 1.0f, 1.0f, 1.0f } };

} // namespace grass

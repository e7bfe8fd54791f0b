// SPDX-License-Identifier: MIT
// Brings a plant's mesh into the form from which the core draws pictures.
#pragma once

#include "core/species/plant_picture.h"
#include "draw/plant_model.h"

#include <vector>

namespace grass {

std::vector<PictureSurface> picture_surfaces(const PlantModel &p_model);

} // namespace grass

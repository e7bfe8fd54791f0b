// SPDX-License-Identifier: MIT
// A plant's mesh in the form of which the core draws pictures.
#pragma once

#include "core/species/plant_picture.h"
#include "draw/plant_model.h"

#include <vector>

namespace grass {

std::vector<PictureSurface> picture_surfaces(const PlantModel &p_model);

} // namespace grass

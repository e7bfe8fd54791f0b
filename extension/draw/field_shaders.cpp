// SPDX-License-Identifier: MIT
#include "draw/field_shaders.h"

#include "draw/blade_materials.h"
#include "draw/ground.h"
#include "draw/plants.h"

namespace grass {

bool prepare_shaders(const Look &p_look) {
	return BladeMaterials::prepare(p_look) & Plants::prepare(p_look) & Ground::prepare(p_look); // `&`: threads take all of them
}

bool are_compiled(const Look &p_look) {
	return BladeMaterials::is_compiled(p_look) && Ground::is_compiled(p_look);
}

} // namespace grass

// SPDX-License-Identifier: MIT
// The field that the properties describe, as far as it is prepared. The running field does not read it.
#pragma once

#include "core/field/field_setup.h"
#include "draw/drawn_plant.h"
#include "field/field_properties.h"
#include "field/shown_map.h"

#include <memory>
#include <optional>
#include <vector>

namespace grass {

struct WantedField {
	FieldSetup setup;
	std::vector<GrownSpecies> species;
	std::vector<DrawnPlant> plants; // of the species
	std::shared_ptr<TileBounds> bounds; // null: not prepared yet
	godot::Ref<GrassMap> painted; // the map that `map` will show; null: none
	std::unique_ptr<ShownMap> map; // null: none, or not begun yet
};

std::shared_ptr<const SpeciesMix> find_mix(const FieldProperties &p_properties); // null: one species, see FieldSetup
WantedField find_wanted(const FieldProperties &p_properties);
// Returns the number of tiles that its pool should have, on the device that it runs on.
int find_pool_size(const FieldProperties &p_properties, const FieldSetup &p_setup);
// Returns where a map would be shown, in order to prepare it, or nothing while the patches are not made yet.
std::optional<MapPlace> find_map_place(const FieldProperties &p_properties);

} // namespace grass

// SPDX-License-Identifier: MIT
// The species that the brush plants, selected by picture and name from those of the selected field.
#pragma once

#include "editor/species_drop.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/item_list.hpp>

#include <memory>
#include <vector>

namespace grass {

// An item's index is its number in GrassBrush.species: 0 for the mix of species, n for the n-th species.
class SpeciesPalette : public godot::ItemList {
	GDCLASS(SpeciesPalette, godot::ItemList)

public:
	SpeciesPalette();

	// Offers the field's species. Cheap if they did not change; called often, since species notify only their field of changes.
	void show_field(const GrassField *p_field);
	int get_count() const { return int(_entries.size()); } // of species
	void show_species(int64_t p_species);
	// Returns the species to plant on this field: p_species if the user has chosen it and the field has it, otherwise the first.
	int64_t fitting(int64_t p_species);
	void set_chosen() { _is_chosen = true; }

protected:
	static void _bind_methods() {}

private:
	struct Entry {
		godot::String name;
		godot::Ref<GrassSpecies> species; // null: an empty entry
		std::vector<godot::Ref<godot::Image>> card; // including the leaf
		std::shared_ptr<const PlantModel> plant; // drawn in place of blades; null: none
		std::vector<double> look; // everything else that its picture shows
		bool operator==(const Entry &) const = default;
	};

	static Entry entry_of(const godot::Ref<GrassSpecies> &p_species, int p_number);
	void fill();

	const godot::Ref<GrassSpecies> _default = make_default_species(); // of fields that name none
	std::vector<Entry> _entries;
	bool _is_chosen = false; // by the user
};

} // namespace grass

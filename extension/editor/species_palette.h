// SPDX-License-Identifier: MIT
// The species that the brush plants, picked by picture and name from those of the selected field.
#pragma once

#include "nodes/grass_field.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/item_list.hpp>

#include <vector>

namespace grass {

// An item's index is the number that GrassBrush.species has for it: 0 as the species are mixed, n the n-th one.
class SpeciesPalette : public godot::ItemList {
	GDCLASS(SpeciesPalette, godot::ItemList)

public:
	SpeciesPalette();

	// Offers the field's species. Cheap if they did not change: species notify only their field of that.
	void show_field(const GrassField *p_field);
	int get_count() const { return int(_entries.size()); } // of species
	void show_species(int64_t p_species);
	// The species to plant on this field: p_species if the user has chosen it and the field has it, else the first.
	int64_t fitting(int64_t p_species);
	void set_chosen() { _is_chosen = true; }

protected:
	static void _bind_methods() {}

private:
	struct Entry {
		godot::String name;
		godot::Ref<GrassSpecies> species; // null: an empty place
		std::vector<godot::Ref<godot::Image>> card; // and the leaf
		std::vector<double> look; // all else that its picture shows
		bool operator==(const Entry &) const = default;
	};

	static Entry entry_of(const godot::Ref<GrassSpecies> &p_species, int p_number);
	void fill();

	std::vector<Entry> _entries;
	bool _is_chosen = false; // by the user
};

} // namespace grass

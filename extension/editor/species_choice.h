// SPDX-License-Identifier: MIT
// The species that the brush plants, chosen by name and picture from those of the selected field.
#pragma once

#include "nodes/grass_field.h"

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/option_button.hpp>

#include <array>
#include <vector>

namespace grass {

// Each entry's id is the number that GrassBrush.species has for it: 0 as the species are mixed, n the n-th one.
class SpeciesChoice : public godot::OptionButton {
	GDCLASS(SpeciesChoice, godot::OptionButton)

public:
	SpeciesChoice();

	// Offers the field's species. Cheap if they did not change: species notify only their field of that.
	void show_field(const GrassField *p_field);
	int get_count() const { return int(_entries.size()); } // of species
	void show_species(int64_t p_species);
	// The species to plant on this field, where the brush plants p_species so far: the first, until the user has chosen one.
	int64_t fitting(int64_t p_species) const;
	void set_chosen() { _is_chosen = true; }

protected:
	static void _bind_methods() {}

private:
	struct Entry {
		godot::String name;
		std::array<godot::Color, GRASS_LOOK_COLORS> colors{}; // from root to tip, linear
		godot::Ref<godot::Image> card;
		godot::Color card_color;
		bool operator==(const Entry &) const = default;
	};

	static Entry entry_of(const godot::Ref<GrassSpecies> &p_species, int p_number);
	static godot::Ref<godot::ImageTexture> make_swatch(const Entry &p_entry);
	void fill();

	std::vector<Entry> _entries;
	bool _is_chosen = false; // by the user
};

} // namespace grass

// SPDX-License-Identifier: MIT
#include "editor/species_choice.h"

#include <godot_cpp/classes/editor_interface.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

constexpr double SWATCH = 16.0; // a side, in the editor's unscaled pixels
constexpr char TOOLTIP[] = "The species to plant.\nCtrl + Shift + [ and ].";
constexpr char NO_SPECIES_TOOLTIP[] = "The field has no species to plant. Add entries to its `species`.";

} // namespace

SpeciesChoice::SpeciesChoice() {
	set_focus_mode(FOCUS_NONE); // keys stay with the view
	set_clip_text(true); // names may be of any length
	set_fit_to_longest_item(false);
	fill();
}

void SpeciesChoice::show_field(const GrassField *p_field) {
	std::vector<Entry> entries;
	const TypedArray<GrassSpecies> species = p_field != nullptr ? p_field->get_species() : TypedArray<GrassSpecies>();
	for (int i = 0; i < std::min(int(species.size()), GRASS_MAX_SPECIES); i++) {
		entries.push_back(entry_of(species[i], i + 1));
	}
	if (entries != _entries) {
		_entries = std::move(entries);
		fill();
	}
}

SpeciesChoice::Entry SpeciesChoice::entry_of(const Ref<GrassSpecies> &p_species, int p_number) {
	Entry entry;
	entry.name = vformat("Species %d", p_number);
	if (p_species.is_null()) {
		entry.name += String(" (empty)");
		return entry;
	}
	const bool has_file = !p_species->get_path().is_empty() && !p_species->get_path().contains("::");
	if (!p_species->get_name().is_empty()) {
		entry.name = p_species->get_name();
	} else if (has_file) {
		entry.name = p_species->get_path().get_file().get_basename().capitalize();
	}
	const SpeciesLook look = Ref<GrassSpecies>(p_species)->get_look();
	entry.colors = look.colors;
	entry.card = look.card_share > 0.0f ? look.card : Ref<Image>();
	entry.card_color = look.card_color;
	return entry;
}

// Its blades' colours from root to tip, and its flower before them.
Ref<ImageTexture> SpeciesChoice::make_swatch(const Entry &p_entry) {
	const int side = int(std::lround(SWATCH * EditorInterface::get_singleton()->get_editor_scale()));
	const Ref<Image> swatch = Image::create_empty(side, side, false, Image::FORMAT_RGBA8);
	Ref<Image> card;
	if (p_entry.card.is_valid()) {
		card = p_entry.card->duplicate();
		card->clear_mipmaps();
		card->resize(side, side, Image::INTERPOLATE_LANCZOS);
	}
	for (int y = 0; y < side; y++) {
		const float along = float(GRASS_LOOK_COLORS - 1) * (1.0f - (float(y) + 0.5f) / float(side));
		const size_t below = size_t(along);
		const Color blade = p_entry.colors[below].lerp(p_entry.colors[below + 1], along - float(below));
		for (int x = 0; x < side; x++) {
			const Color flower = card.is_valid() ? card->get_pixel(x, y) : Color(0, 0, 0, 0);
			Color color = blade.lerp(flower.srgb_to_linear() * p_entry.card_color, flower.a).linear_to_srgb();
			color.a = 1.0f;
			swatch->set_pixel(x, y, color);
		}
	}
	return ImageTexture::create_from_image(swatch);
}

void SpeciesChoice::fill() {
	clear();
	add_item("As mixed", 0);
	for (size_t i = 0; i < _entries.size(); i++) {
		add_icon_item(make_swatch(_entries[i]), _entries[i].name, int32_t(i) + 1);
	}
	set_disabled(_entries.empty());
	set_tooltip_text(_entries.empty() ? NO_SPECIES_TOOLTIP : TOOLTIP);
}

void SpeciesChoice::show_species(int64_t p_species) {
	select(get_item_index(int32_t(std::min<int64_t>(p_species, get_count()))));
}

int64_t SpeciesChoice::fitting(int64_t p_species) const {
	return _is_chosen && p_species <= get_count() ? p_species : std::min(1, get_count());
}

} // namespace grass

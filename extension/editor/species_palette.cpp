// SPDX-License-Identifier: MIT
#include "editor/species_palette.h"

#include "editor/field_owner.h"
#include "editor/species_preview.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/image_texture.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// In the editor's unscaled pixels: side of a picture, width of an item (the presets' names fit), gap between two, margin around all.
constexpr int PICTURE = 40, COLUMN = 100, BETWEEN = 8, AROUND = 24;
constexpr int MOST_COLUMNS = 6; // as many as the view at 1,280 pixels has room for
constexpr char TOOLTIP[] = "The species to plant: click one, or Ctrl + Shift + [ and ].\nDrop a GrassSpecies here, for example a preset, "
						   "and the field grows it, too.";
constexpr char NO_FIELD_TOOLTIP[] = "No plot of the world is in memory here, so there is no species to plant. Come nearer.";

// Returns strips of all pictures, side by side.
Ref<Image> mix_of(const std::vector<Ref<Image>> &p_pictures, int p_side) {
	Ref<Image> mix = Image::create_empty(p_side, p_side, false, Image::FORMAT_RGBA8);
	const int count = int(p_pictures.size());
	for (int i = 0; i < count; i++) {
		const int from = i * p_side / count, to = (i + 1) * p_side / count;
		mix->blit_rect(p_pictures[size_t(i)], Rect2i(from, 0, to - from, p_side), Vector2i(from, 0));
	}
	return mix;
}

} // namespace

SpeciesPalette::SpeciesPalette() {
	const int scale = std::max(1, int(EditorInterface::get_singleton()->get_editor_scale()));
	set_focus_mode(FOCUS_NONE); // keys stay with the view
	set_icon_mode(ICON_MODE_TOP);
	set_fixed_icon_size(Vector2i(PICTURE, PICTURE) * scale);
	set_fixed_column_width(COLUMN * scale); // names may have any length
	set_max_columns(MOST_COLUMNS);
	set_auto_height(true);
}

void SpeciesPalette::show_field(const GrassField *p_field) {
	std::vector<Entry> entries;
	TypedArray<GrassSpecies> species = p_field != nullptr ? p_field->get_species() : TypedArray<GrassSpecies>();
	if (p_field != nullptr && species.is_empty()) {
		species.push_back(_default);
	}
	for (int i = 0; i < std::min(int(species.size()), GRASS_MAX_SPECIES); i++) {
		entries.push_back(entry_of(species[i], i + 1));
	}
	if (entries != _entries || get_item_count() == 0) {
		_entries = std::move(entries);
		fill();
	}
}

SpeciesPalette::Entry SpeciesPalette::entry_of(const Ref<GrassSpecies> &p_species, int p_number) {
	Entry entry;
	entry.name = vformat("Species %d", p_number);
	entry.species = p_species;
	if (p_species.is_null()) {
		entry.name += String(" (empty)");
		return entry;
	}
	if (!p_species->get_name().is_empty()) {
		entry.name = p_species->get_name();
	} else if (has_own_file(**p_species)) {
		entry.name = p_species->get_path().get_file().get_basename().capitalize();
	}
	const SpeciesLook look = entry.species->get_look();
	entry.card = look.card;
	entry.plant = entry.species->find_plant();
	entry.card.push_back(look.leaf);
	entry.look = { look.dry, look.card_share, look.card_width, look.card_height, look.leaf_size };
	std::vector<Color> colors(look.colors.begin(), look.colors.end());
	colors.insert(colors.end(), { look.dry_color, look.card_color });
	for (const Color &color : colors) {
		entry.look.insert(entry.look.end(), { color.r, color.g, color.b });
	}
	if (const Ref<GrassPatch> patch = entry.species->get_patch(); patch.is_valid()) {
		const PatchParams &form = patch->get_params();
		entry.look.insert(entry.look.end(), { double(form.seed), form.length_min, form.length_max, form.width_min, form.width_max });
		entry.look.insert(entry.look.end(), form.weights.begin(), form.weights.end());
	}
	return entry;
}

void SpeciesPalette::fill() {
	clear();
	const int side = int(get_fixed_icon_size().x);
	std::vector<Ref<Image>> pictures;
	for (const Entry &entry : _entries) {
		const bool is_empty = entry.species.is_null();
		pictures.push_back(is_empty ? Image::create_empty(side, side, false, Image::FORMAT_RGBA8)
									: draw_picture(**entry.species, entry.species->get_look(), entry.plant, side));
	}
	if (_entries.empty()) {
		add_item("No species", Ref<Texture2D>(), false);
	} else {
		add_item("As mixed", ImageTexture::create_from_image(mix_of(pictures, side)));
	}
	for (size_t i = 0; i < _entries.size(); i++) {
		add_item(_entries[i].name, ImageTexture::create_from_image(pictures[i]));
		set_item_tooltip(int32_t(i) + 1, _entries[i].name + "\n" + TOOLTIP);
	}
	const bool is_bare = get_count() == 1 && _entries[0].species == _default;
	if (is_bare) {
		add_item("Drop one here", Ref<Texture2D>(), false);
	}
	set_tooltip_text(_entries.empty() ? NO_FIELD_TOOLTIP : TOOLTIP);
	set_fixed_column_width(_entries.empty() ? 0 : side * COLUMN / PICTURE);
	const int width =
			side * (_entries.empty() ? 3 * COLUMN : (COLUMN + BETWEEN) * std::min(get_item_count(), MOST_COLUMNS) + AROUND) / PICTURE;
	set_custom_minimum_size(Vector2(real_t(width), 0));
}

void SpeciesPalette::show_species(int64_t p_species) {
	const int32_t index = int32_t(std::min<int64_t>(p_species, get_count()));
	if (!_entries.empty() && !is_selected(index)) {
		select(index);
	}
}

int64_t SpeciesPalette::fitting(int64_t p_species) {
	_is_chosen = _is_chosen && p_species <= get_count();
	return _is_chosen ? p_species : std::min(1, get_count());
}

} // namespace grass

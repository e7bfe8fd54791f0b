// SPDX-License-Identifier: MIT
#include "editor/species_drop.h"

#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include <algorithm>
#include <vector>

using namespace godot;

namespace grass {

namespace {

// File types that may contain a species or a picture: dragging a scene over the toolbar must not load it.
constexpr const char *TAKEN[] = { ".tres", ".res", ".png", ".jpg", ".jpeg", ".webp", ".svg", ".exr", ".tga", ".bmp" };

bool may_be_taken(const String &p_file) {
	return std::ranges::any_of(TAKEN, [&](const char *p_end) { return p_file.ends_with(p_end); });
}

std::vector<Ref<Resource>> find_dragged(const Variant &p_dragged) {
	if (p_dragged.get_type() != Variant::DICTIONARY) {
		return {};
	}
	const Dictionary dragged = p_dragged;
	const String type = dragged.get("type", "");
	if (type == "resource") {
		return { Ref<Resource>(dragged.get("resource", Variant())) };
	}
	const PackedStringArray files = type == "files" ? PackedStringArray(dragged.get("files", PackedStringArray())) : PackedStringArray();
	std::vector<Ref<Resource>> found;
	for (int64_t i = 0; i < files.size(); i++) {
		found.push_back(may_be_taken(files[i]) ? ResourceLoader::get_singleton()->load(files[i]) : Ref<Resource>());
	}
	return found;
}

} // namespace

TypedArray<GrassSpecies> find_dragged_species(const Variant &p_dragged) {
	TypedArray<GrassSpecies> species;
	for (const Ref<Resource> &resource : find_dragged(p_dragged)) {
		if (const Ref<GrassSpecies> one = resource; one.is_valid()) {
			species.push_back(one);
		}
	}
	return species;
}

Ref<GrassSpecies> make_default_species() {
	Ref<GrassSpecies> species;
	species.instantiate();
	species->set_name("Default Grass");
	return species;
}

TypedArray<GrassSpecies> find_grown_species(const GrassField &p_field) {
	TypedArray<GrassSpecies> species = p_field.get_species();
	if (species.is_empty()) {
		species.push_back(make_default_species());
	}
	return species;
}

Ref<Texture2D> find_dragged_picture(const Variant &p_dragged) {
	const std::vector<Ref<Resource>> dragged = find_dragged(p_dragged);
	return dragged.size() == 1 ? Ref<Texture2D>(dragged[0]) : Ref<Texture2D>();
}

} // namespace grass

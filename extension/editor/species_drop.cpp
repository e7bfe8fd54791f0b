// SPDX-License-Identifier: MIT
#include "editor/species_drop.h"

#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

using namespace godot;

namespace grass {

TypedArray<GrassSpecies> find_dragged_species(const Variant &p_dragged) {
	TypedArray<GrassSpecies> species;
	if (p_dragged.get_type() != Variant::DICTIONARY) {
		return species;
	}
	const Dictionary dragged = p_dragged;
	const String type = dragged.get("type", "");
	if (type == "resource") {
		const Ref<GrassSpecies> one = dragged.get("resource", Variant());
		if (one.is_valid()) {
			species.push_back(one);
		}
	}
	const PackedStringArray files = type == "files" ? PackedStringArray(dragged.get("files", PackedStringArray())) : PackedStringArray();
	for (int64_t i = 0; i < files.size(); i++) {
		const bool is_resource = files[i].ends_with(".tres") || files[i].ends_with(".res");
		const Ref<GrassSpecies> one = is_resource ? ResourceLoader::get_singleton()->load(files[i]) : Ref<Resource>();
		if (one.is_valid()) {
			species.push_back(one);
		}
	}
	return species;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "nodes/described_field.h"

#include "nodes/grass_field.h"
#include "shared/build_info.h"

#include <godot_cpp/classes/engine.hpp>

using namespace godot;

namespace grass {

namespace {

Dictionary describe(const GrassSpecies &p_species) {
	Dictionary species;
	species["is_plain"] = p_species.is_plain();
	for (size_t i = 0; i < SPECIES_PARAMS.size(); i++) {
		species[SPECIES_PARAMS[i].name] = p_species.get_param(int64_t(i));
	}
	if (const Ref<GrassPatch> patch = p_species.get_patch(); patch.is_valid()) {
		species["patch_seed"] = patch->get_seed();
		for (int64_t i = 0; i < GrassPatch::PARAM_MAX; i++) {
			species[i] = patch->get_param(GrassPatch::Param(i));
		}
	}
	return species;
}

// Makes a species. A gradient stands in for what is only drawn: a field mixes species if one of them is more than its blades.
Ref<GrassSpecies> make_species(const Dictionary &p_described) {
	Ref<GrassSpecies> species;
	species.instantiate();
	for (size_t i = 0; i < SPECIES_PARAMS.size(); i++) {
		species->set_param(int64_t(i), p_described.get(SPECIES_PARAMS[i].name, SPECIES_PARAMS[i].initial));
	}
	if (p_described.has("patch_seed")) {
		Ref<GrassPatch> patch;
		patch.instantiate();
		patch->set_seed(p_described["patch_seed"]);
		for (int64_t i = 0; i < GrassPatch::PARAM_MAX; i++) {
			patch->set_param(GrassPatch::Param(i), p_described.get(i, 0.0));
		}
		species->set_patch(patch);
	}
	if (!bool(p_described.get("is_plain", true)) && species->is_plain()) {
		Ref<Gradient> gradient;
		gradient.instantiate();
		species->set_gradient(gradient);
	}
	return species;
}

} // namespace

Dictionary describe_field(const GrassField &p_field) {
	const FieldParts &parts = p_field.get_parts();
	Dictionary described;
	described["version"] = get_version();
	described["engine"] = Engine::get_singleton()->get_version_info()["string"];
	described["backend"] = parts.standing.get_backend()->get_name();
	described["transform"] = p_field.field_transform();
	described["noise_origin"] = parts.properties.noise_origin;
	described["size"] = parts.properties.size;
	described["seed"] = parts.properties.seed;
	described["method"] = int64_t(parts.properties.method);
	described["sleep_mode"] = int64_t(parts.properties.sleep_mode);
	described["pool_tiles"] = parts.properties.pool_tiles;
	for (size_t i = 0; i < FIELD_PARAMS.size(); i++) {
		described[FIELD_PARAMS[i].tunable.name] = parts.properties.params[i];
	}
	Array species;
	for (const GrownSpecies &grown : parts.standing.get_species()) {
		species.push_back(describe(*grown.species.ptr()));
	}
	described["species"] = species;
	if (const ShownMap *map = parts.standing.get_map()) {
		described["map"] = map->get_map()->get_data();
	}
	return described;
}

// Sets the properties of a field. The engine converts a value of another type to an empty one, and setters clamp.
String become_described(GrassField &r_field, const Dictionary &p_described) {
	FieldParts &parts = r_field.get_parts();
	Ref<GrassMap> map;
	if (p_described.has("map")) {
		map.instantiate();
		if (const String reason = map->read(p_described["map"]); !reason.is_empty()) {
			return vformat("holds a map that %s", reason);
		}
	}
	TypedArray<GrassSpecies> species;
	const Array described = p_described.get("species", Array());
	for (int64_t i = 0; i < described.size(); i++) {
		species.push_back(make_species(described[i]));
	}
	r_field.set_global_transform(p_described.get("transform", Transform3D()));
	r_field.set_noise_origin(p_described.get("noise_origin", Vector2i()));
	parts.settings.set_size(p_described.get("size", parts.settings.get_size()));
	parts.settings.set_seed(p_described.get("seed", 0));
	parts.settings.set_method(FieldEnums::SolverMethod(int64_t(p_described.get("method", 0))));
	parts.settings.set_sleep_mode(FieldEnums::SleepMode(int64_t(p_described.get("sleep_mode", 0))));
	parts.settings.set_pool_tiles(p_described.get("pool_tiles", 0));
	for (size_t i = 0; i < FIELD_PARAMS.size(); i++) {
		parts.settings.set_param(int64_t(i), p_described.get(FIELD_PARAMS[i].tunable.name, FIELD_PARAMS[i].tunable.initial));
	}
	r_field.set_species(species);
	r_field.set_map(map);
	r_field.request_rebuild();
	return String();
}

} // namespace grass

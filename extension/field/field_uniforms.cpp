// SPDX-License-Identifier: MIT
#include "field/field_uniforms.h"

#include "draw/patch_texture.h"

#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/packed_vector4_array.hpp>

#include <utility>

using namespace godot;

namespace grass {

void FieldUniforms::set_all(const FieldProperties &p_properties, const FieldSetup &p_setup, const SetUniform &p_set) const {
	const TileGrid &grid = p_setup.grid;
	p_set("tiles", Vector2(real_t(grid.get_tiles_x()), real_t(grid.get_tiles_z())));
	p_set("lattice_points", lattice_texture());
	p_set("leaf_pictures", leaf_textures());
	p_set("tile_size", grid.get_tile_size());
	const BladeSize size = p_setup.blade_size();
	p_set("grass_cover", grass_lod_cover(size.width, size.length, float(grid.get_tile_size())));
	p_set("grass_length", size.length);
	p_set("grass_width", size.width);
	set_clump(p_setup.clump, p_set);
	const std::array<float, 4> &origin = p_setup.clump.origin;
	p_set("clump_origin", Vector4(origin[0], origin[1], origin[2], origin[3]));
	p_set("noise_origin", Vector2(real_t(p_properties.noise_origin.x), real_t(p_properties.noise_origin.y)));
	p_set("canopy_height", p_setup.patch->mean_height * 1.1);
	p_set("debug_view", p_properties.debug_view);
	p_set("follow_slope", p_setup.follow_slope);
	p_set("sparse_height", p_setup.sparse_height);
	p_set("other_light", _light);
	show_suns(p_set);
	for (size_t i = 0; i < FIELD_PARAMS.size(); i++) {
		if (FIELD_PARAMS[i].effect == Effect::UNIFORM) {
			p_set(FIELD_PARAMS[i].tunable.name, p_properties.scaled(FIELD_PARAMS[i].id));
		}
	}
	for (size_t i = 0; i < FIELD_COLORS.size(); i++) {
		p_set(FIELD_COLORS[i].name, p_properties.colors[i]);
	}
	set_soil(p_properties, p_set);
	p_set("terrain_texture", p_properties.find_terrain_texture());
	set_wind(p_properties, p_set);
}

void FieldUniforms::set_soil(const FieldProperties &p_properties, const SetUniform &p_set) {
	Vector3 has;
	for (size_t i = 0; i < SOIL_TEXTURES.size(); i++) {
		p_set(SOIL_TEXTURES[i], p_properties.soil_textures[i]);
		has[int(i)] = real_t(p_properties.soil_textures[i].is_valid());
	}
	p_set("soil_textures", has);
}

void FieldUniforms::set_clump(const ClumpParams &p_clump, const SetUniform &p_set) {
	p_set("clump", Vector4(p_clump.size, p_clump.height, p_clump.lean, p_clump.tint));
}

void FieldUniforms::set_wind(const FieldProperties &p_properties, const SetUniform &p_set) const {
	const Eigen::Vector2d wind = wind_in_field(_turn, p_properties.param(PARAM_WIND_SPEED), p_properties.param(PARAM_WIND_DIRECTION));
	p_set("wind", Vector2(real_t(wind.x()), real_t(wind.y())));
	p_set("gust", Vector2(real_t(p_properties.param(PARAM_GUST_SIZE)), real_t(p_properties.param(PARAM_GUST_STRENGTH))));
}

bool FieldUniforms::turn(const Eigen::Matrix3d &p_turn) {
	return std::exchange(_turn, p_turn) != p_turn;
}

void FieldUniforms::set_light(const Vector4 &p_other, const SetUniform &p_set) {
	if (_light != p_other) {
		_light = p_other;
		p_set("other_light", _light);
	}
}

void FieldUniforms::set_suns(const SunMap &p_suns, const SetUniform &p_set) {
	if (_suns != p_suns) {
		_suns = p_suns;
		show_suns(p_set);
	}
}

void FieldUniforms::show_suns(const SetUniform &p_set) const {
	Vector4 map = _suns.map;
	map.z *= real_t(1.0f - _mesh_share); // near plants with a mesh cast its shadow, and not that of their blades
	p_set("sun_map", map);
	PackedVector3Array bare;
	for (const Vector3 &toward : _suns.bare) {
		bare.push_back(toward);
	}
	p_set("bare_sun_count", bare.size());
	p_set("bare_suns", bare);
}

void FieldUniforms::set_wind_clock(const SetUniform &p_set) {
	_clock = Vector2(real_t(_wind.sway), real_t(_wind.roll));
	p_set("grass_time", _clock);
}

bool FieldUniforms::keep_wind_clock(const SetUniform &p_set) {
	if (_clock_before != _drawn_clock) {
		_clock_before = _drawn_clock;
		p_set("grass_time_before", _clock_before);
	}
	return std::exchange(_drawn_clock, _clock) != _clock;
}

bool FieldUniforms::blow(const FieldProperties &p_properties, double p_delta, bool p_has_forces) {
	const double speed = p_properties.param(PARAM_WIND_SPEED);
	const bool blows = speed > 0.0 || p_has_forces;
	if (blows) {
		_wind.advance(p_delta, speed, p_properties.param(PARAM_GUST_SIZE));
	}
	return blows;
}

void FieldUniforms::set_forces(std::span<const Force> p_forces, const TileGrid &p_grid, const SetUniform &p_set) {
	if (p_forces.empty() && _forces == 0) {
		return;
	}
	_forces = p_forces.size();
	p_set("force_count", int64_t(_forces));
	if (p_forces.empty()) {
		return;
	}
	PackedVector4Array places, blows, rings, beats;
	for (const Force &force : p_forces) {
		const GrassForce record = force.pack(p_grid);
		const Eigen::Vector3f place = force.place.cast<float>();
		places.push_back({ place.x(), place.y(), place.z(), record.place.w });
		for (const auto &[array, values] :
				{ std::pair(&blows, record.blow), std::pair(&rings, record.ring), std::pair(&beats, record.beat) }) {
			array->push_back({ values.x, values.y, values.z, values.w });
		}
	}
	p_set("force_place", places);
	p_set("force_blow", blows);
	p_set("force_ring", rings);
	p_set("force_beat", beats);
}

// Colours, dryness and variation of hue of the ground, and of blades that are all of one species: the mean over the species, weighted by
// their shares.
void FieldUniforms::set_colors(const std::vector<GrownSpecies> &p_species, const SetUniform &p_set) {
	double shares = 0.0;
	for (const GrownSpecies &grown : p_species) {
		shares += grown.species->get_mix().share;
	}
	const auto share_of = [&](const GrownSpecies &p_grown) {
		return shares > 0.0 ? p_grown.species->get_mix().share / shares : 1.0 / double(p_species.size());
	};
	double dry = 0.0, hue_variation = 0.0;
	for (const GrownSpecies &grown : p_species) {
		dry += share_of(grown) * grown.species->get_param(SPECIES_PARAM_DRY);
		hue_variation += share_of(grown) * grown.species->get_param(SPECIES_PARAM_HUE_VARIATION);
	}
	for (int color = SPECIES_ROOT_COLOR; color <= SPECIES_DRY_COLOR; color++) {
		Color mean(0.0f, 0.0f, 0.0f);
		for (const GrownSpecies &grown : p_species) {
			mean += grown.species->get_color(color).srgb_to_linear() * float(share_of(grown));
		}
		p_set(SPECIES_COLORS[size_t(color)].name, p_species.size() == 1 ? p_species[0].species->get_color(color) : mean.linear_to_srgb());
	}
	p_set(DRY.name, float(dry));
	p_set(HUE_VARIATION.name, float(hue_variation));
}

// Sets how plants with a mesh look as blades, and where they do.
void FieldUniforms::set_plants(const std::vector<DrawnPlant> &p_plants, float p_reach, const SetUniform &p_set) {
	PackedVector4Array looks, bands;
	PackedVector3Array reaches;
	PackedFloat32Array rows;
	for (const DrawnPlant &plant : p_plants) {
		const Color color = plant.model ? plant.model->color : Color();
		looks.push_back({ real_t(color.r), real_t(color.g), real_t(color.b), plant.cover() });
		reaches.push_back(Vector3(real_t(plant.blade_distance() * p_reach), real_t(plant.width()), real_t(plant.distance * p_reach)));
		for (const PlantModel::Band &band : plant.model ? plant.model->bands : decltype(PlantModel::bands)()) {
			bands.push_back({ real_t(band.color.r), real_t(band.color.g), real_t(band.color.b), band.width });
			rows.push_back(band.rows);
		}
	}
	looks.resize(GRASS_MAX_SPECIES);
	reaches.resize(GRASS_MAX_SPECIES);
	bands.resize(GRASS_MAX_SPECIES * GRASS_PLANT_BANDS);
	p_set("plant_far", looks);
	rows.resize(GRASS_MAX_SPECIES * GRASS_PLANT_BANDS);
	p_set("plant_bands", bands);
	p_set("plant_rows", rows);
	p_set("plant_reach", reaches);
}

void FieldUniforms::set_species(const FieldSetup &p_setup, const std::vector<GrownSpecies> &p_species,
		const std::vector<DrawnPlant> &p_plants, float p_reach, const SetUniform &p_set, const SetUniform &p_set_blades) {
	set_colors(p_species, p_set);
	_mesh_share = 0.0f;
	for (size_t s = 0; s < p_plants.size() && p_setup.species; s++) {
		_mesh_share += p_plants[s].model ? float(p_setup.species->get_share(int(s))) : 0.0f;
	}
	show_suns(p_set);
	if (!p_setup.species) {
		return;
	}
	PackedInt32Array records, origins, frays;
	PackedFloat32Array falls;
	for (const SpeciesRecord &record : p_setup.species->get_records()) {
		for (const int32_t value : { record.cell, record.strength, record.limit, record.salt }) {
			records.push_back(value);
		}
		for (const int32_t value : { record.x, record.z, record.column, record.row }) {
			origins.push_back(value);
		}
		frays.push_back(record.fray);
		falls.push_back(record.falls);
	}
	frays.resize(GRASS_MAX_SPECIES);
	falls.resize(GRASS_MAX_SPECIES);
	records.resize(4 * GRASS_MAX_SPECIES);
	origins.resize(4 * GRASS_MAX_SPECIES);
	if (p_setup.has_plants) {
		PackedInt32Array stems;
		for (const SpeciesRecord &record : p_setup.species->get_records()) {
			stems.push_back(record.stems);
		}
		stems.resize(GRASS_MAX_SPECIES);
		p_set_blades("species_stems", stems);
		set_plants(p_plants, p_reach, p_set);
	}
	PackedFloat32Array shares;
	for (int s = 0; s < p_setup.species->get_count(); s++) {
		shares.push_back(float(p_setup.species->get_share(s)));
	}
	shares.resize(GRASS_MAX_SPECIES);
	p_set("species_shares", shares);
	p_set("species_count", p_setup.species->get_count());
	p_set("species_mix", records);
	p_set("species_origin", origins);
	p_set("species_fray", frays);
	p_set_blades("species_falls", falls);
	p_set_blades("species_texel", p_setup.species->get_texel_units());
	constexpr float OVER_MEAN = 1.1f; // as canopy_height is over the patch's
	constexpr float COVERS = float(GRASS_LOD_FULLNESS * GRASS_LOD_FACING); // of width times length: seen from anywhere
	std::vector<SpeciesLook> looks;
	for (const GrownSpecies &grown : p_species) {
		SpeciesLook look = grown.species->get_look();
		const float own = grown.patch->mean_height * OVER_MEAN, mixed = p_setup.patch->mean_height * OVER_MEAN;
		const float alone = float(grown.species->get_mix().stand_strength);
		look.canopy_alone = std::max(own, 0.01f);
		look.canopy_among_others = std::max(mixed + (own - mixed) * alone, 0.01f);
		look.leaf_width = width_of_leaf(float(grown.species->get_leaf_area()), grown.patch->mean_length);
		look.blade_area = COVERS * (grown.patch->mean_width + look.leaf_width) * grown.patch->mean_length;
		looks.push_back(look);
	}
	if (!are_made_of(_cards, looks)) {
		_cards = make_cards(looks);
	}
	p_set("species_look", make_look_texture(looks, _cards));
	if (_cards.textures.is_valid()) {
		p_set_blades("card_textures", _cards.textures);
	}
}

} // namespace grass

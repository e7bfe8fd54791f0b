// SPDX-License-Identifier: MIT
#include "resources/grass_species.h"

#include "shared/bind_property.h"
#include "shared/main_thread.h"
#include "shared/params.h"
#include "shared/watch_resource.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

using namespace godot;

namespace grass {

GrassSpecies::GrassSpecies() {
	for (size_t i = 0; i < _colors.size(); i++) {
		_colors[i] = Color(SPECIES_COLORS[i].red, SPECIES_COLORS[i].green, SPECIES_COLORS[i].blue);
	}
}

void GrassSpecies::set_patch(const Ref<GrassPatch> &p_patch) {
	GRASS_CHANGE_GUARD(label());
	if (watch_instead(_patch, p_patch, callable_mp(this, &GrassSpecies::_part_changed))) {
		emit_changed();
	}
}

void GrassSpecies::set_gradient(const Ref<Gradient> &p_gradient) {
	GRASS_CHANGE_GUARD(label());
	if (watch_instead(_gradient, p_gradient, callable_mp(this, &GrassSpecies::_part_changed))) {
		emit_changed();
	}
}

void GrassSpecies::set_card(const Ref<Texture2D> &p_card) {
	GRASS_CHANGE_GUARD(label());
	if (watch_instead(_card, p_card, callable_mp(this, &GrassSpecies::_part_changed))) {
		_card_images.clear();
		emit_changed();
	}
}

void GrassSpecies::set_leaf(const Ref<Texture2D> &p_leaf) {
	GRASS_CHANGE_GUARD(label());
	if (watch_instead(_leaf, p_leaf, callable_mp(this, &GrassSpecies::_part_changed))) {
		_leaf_image.unref();
		emit_changed();
	}
}

void GrassSpecies::set_plant_mesh(const Ref<Mesh> &p_mesh) {
	GRASS_CHANGE_GUARD(label());
	if (watch_instead(_plant_mesh, p_mesh, callable_mp(this, &GrassSpecies::_part_changed))) {
		_plant.reset();
		_impostor.reset();
		emit_changed();
	}
}

void GrassSpecies::set_plant_scene(const Ref<PackedScene> &p_scene) {
	GRASS_CHANGE_GUARD(label());
	replace_in(*this, _plant_scene, p_scene);
}

float GrassSpecies::find_plant_height(float p_mean_length) const {
	find_plant();
	return _plant && _plant->height > 0.0f ? _plant->height : p_mean_length;
}

int GrassSpecies::get_stems() const {
	return int(std::bit_floor(unsigned(param(SPECIES_PARAM_STEMS))));
}

std::shared_ptr<const PlantModel> GrassSpecies::find_plant() const {
	if (_plant_mesh.is_valid() && !_plant) {
		const Ref<Mesh> mesh = _plant_mesh; // a script, maybe, that sets another one meanwhile
		const PlantReading reading = read_plant(mesh, label() + String(": `plant_mesh`"));
		if (_plant_mesh == mesh) {
			_plant = reading;
		}
	}
	return _plant ? _plant->model : nullptr;
}

std::shared_ptr<const PlantImpostor> GrassSpecies::find_impostor() const {
	if (const std::shared_ptr<const PlantModel> model = find_plant(); model && !_impostor) {
		_impostor = std::make_shared<const PlantImpostor>(*model);
	}
	return _impostor;
}

String GrassSpecies::get_plant_problem() const {
	find_plant();
	return _plant ? _plant->problem : String();
}

double GrassSpecies::get_card_size() const {
	const double flower = _card.is_valid() && param(SPECIES_PARAM_CARD_SHARE) > 0.0
			? std::hypot(param(SPECIES_PARAM_CARD_WIDTH), param(SPECIES_PARAM_CARD_HEIGHT))
			: 0.0;
	const double leaf = _leaf.is_valid() ? std::sqrt(2.0) * param(SPECIES_PARAM_LEAF_SIZE) : 0.0;
	return 0.5 * double(GRASS_CARD_LARGEST) * std::max(flower, leaf);
}

double GrassSpecies::get_leaf_area() {
	read_pictures();
	const double side = param(SPECIES_PARAM_LEAF_SIZE), bare = _card.is_valid() ? 1.0 - param(SPECIES_PARAM_CARD_SHARE) : 1.0;
	return _leaf_image.is_valid() ? bare * side * side * _leaf_cover : 0.0;
}

void GrassSpecies::set_param(int64_t p_param, double p_value) {
	GRASS_CHANGE_GUARD(label());
	ERR_FAIL_INDEX(p_param, int(SPECIES_PARAM_COUNT));
	if (!replace(_params[size_t(p_param)], checked(SPECIES_PARAMS[size_t(p_param)], p_value, label()))) {
		return;
	}
	if (p_param == SPECIES_PARAM_CARD_PICTURES) {
		_card_images.clear();
	}
	emit_changed();
}

double GrassSpecies::get_param(int64_t p_param) const {
	ERR_FAIL_INDEX_V(p_param, int(SPECIES_PARAM_COUNT), 0.0);
	return _params[size_t(p_param)];
}

Variant GrassSpecies::_get_param(int64_t p_param) const {
	ERR_FAIL_INDEX_V(p_param, int(SPECIES_PARAM_COUNT), 0.0);
	return property_value(SPECIES_PARAMS[size_t(p_param)], _params[size_t(p_param)]);
}

void GrassSpecies::set_color(int64_t p_index, const Color &p_color) {
	GRASS_CHANGE_GUARD(label());
	ERR_FAIL_INDEX(p_index, int(SPECIES_COLOR_COUNT));
	replace_in(*this, _colors[size_t(p_index)], p_color);
}

Color GrassSpecies::get_color(int64_t p_index) const {
	ERR_FAIL_INDEX_V(p_index, int(SPECIES_COLOR_COUNT), Color());
	return _colors[size_t(p_index)];
}

std::shared_ptr<const Patch> GrassSpecies::find_patch() const {
	return _patch.is_valid() ? const_cast<GrassPatch *>(_patch.ptr())->get_patch() : GrassPatch::get_default();
}

bool GrassSpecies::prepare_patch() const {
	return _patch.is_null() ? GrassPatch::is_default_made() : const_cast<GrassPatch *>(_patch.ptr())->prepare();
}

SpeciesParams GrassSpecies::get_mix() const {
	return { param(SPECIES_PARAM_SHARE), param(SPECIES_PARAM_STAND_SIZE), param(SPECIES_PARAM_STAND_STRENGTH), get_stems(),
		param(SPECIES_PARAM_STAND_EDGE), _plant_mesh.is_null() };
}

SolverParams GrassSpecies::get_solver(const SolverParams &p_field) const {
	SolverParams params = p_field;
	params.natural_frequency = param(SPECIES_PARAM_NATURAL_FREQUENCY);
	params.damping_ratio = param(SPECIES_PARAM_DAMPING_RATIO);
	params.taper = param(SPECIES_PARAM_TAPER);
	params.width_to_thickness = param(SPECIES_PARAM_WIDTH_TO_THICKNESS);
	params.root_stiffness = param(SPECIES_PARAM_ROOT_STIFFNESS);
	params.bend_stiffness = param(SPECIES_PARAM_BEND_STIFFNESS);
	return params;
}

void GrassSpecies::_part_changed() {
	_card_images.clear(); // it may have been the card
	_leaf_image.unref(); // or the leaf
	_plant.reset(); // or the mesh
	_impostor.reset();
	emit_changed();
}

std::vector<Ref<Image>> GrassSpecies::read_card() const {
	return grass::read_card(_card, get_card_pictures(), label() + String(": the picture of `card`"));
}

std::vector<Ref<Image>> GrassSpecies::read_leaf() const {
	return grass::read_card(_leaf, 1, label() + String(": the picture of `leaf`"));
}

void GrassSpecies::read_pictures() {
	if (_card_images.empty()) {
		_card_images = read_card();
	}
	if (_leaf_image.is_null()) {
		const std::vector<Ref<Image>> leaf = read_leaf();
		_leaf_image = leaf.empty() ? Ref<Image>() : leaf.front();
		_leaf_cover = leaf.empty() ? 0.0 : double(mean_color(_leaf_image).a);
	}
}

SpeciesLook GrassSpecies::get_look() {
	read_pictures();
	return make_look(_card_images, _leaf_image);
}

SpeciesLook GrassSpecies::make_look(const std::vector<Ref<Image>> &p_card, const Ref<Image> &p_leaf) const {
	SpeciesLook look;
	const Color root = _colors[SPECIES_ROOT_COLOR].srgb_to_linear(), tip = _colors[SPECIES_TIP_COLOR].srgb_to_linear();
	for (size_t i = 0; i < look.colors.size(); i++) {
		const float along = float(i) / float(look.colors.size() - 1);
		look.colors[i] = _gradient.is_valid() ? const_cast<Gradient *>(_gradient.ptr())->sample(along).srgb_to_linear()
											  : root.lerp(tip, along * along * (3.0f - 2.0f * along));
	}
	look.dry_color = _colors[SPECIES_DRY_COLOR].srgb_to_linear();
	look.dry = float(param(SPECIES_PARAM_DRY));
	look.hue_variation = float(param(SPECIES_PARAM_HUE_VARIATION));
	look.card = p_card;
	look.card_color = _colors[SPECIES_CARD_COLOR].srgb_to_linear();
	look.card_share = float(param(SPECIES_PARAM_CARD_SHARE));
	look.card_width = float(param(SPECIES_PARAM_CARD_WIDTH));
	look.card_height = float(param(SPECIES_PARAM_CARD_HEIGHT));
	look.card_flatness = float(param(SPECIES_PARAM_CARD_FLATNESS));
	look.leaf = p_leaf;
	look.leaf_size = float(param(SPECIES_PARAM_LEAF_SIZE));
	return look;
}

void GrassSpecies::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_set_param", "param", "value"), &GrassSpecies::set_param);
	ClassDB::bind_method(D_METHOD("_get_param", "param"), &GrassSpecies::_get_param);
	ClassDB::bind_method(D_METHOD("_set_color", "index", "color"), &GrassSpecies::set_color);
	ClassDB::bind_method(D_METHOD("_get_color", "index"), &GrassSpecies::get_color);
	const auto add_numbers = [](int p_first, int p_last) { add_params("GrassSpecies", SPECIES_PARAMS, p_first, p_last); };
	const auto add_colors = [](int p_first, int p_last) {
		for (int color = p_first; color <= p_last; color++) {
			ClassDB::add_property("GrassSpecies",
					PropertyInfo(Variant::COLOR, SPECIES_COLORS[size_t(color)].name, PROPERTY_HINT_COLOR_NO_ALPHA), "_set_color",
					"_get_color", color);
		}
	};
	GRASS_BIND_PROPERTY_AS(
			GrassSpecies, PropertyInfo(Variant::OBJECT, "patch", PROPERTY_HINT_RESOURCE_TYPE, "GrassPatch"), set_patch, get_patch, "patch");
	ADD_GROUP("Mix", "");
	add_numbers(SPECIES_PARAM_SHARE, SPECIES_PARAM_TUSSOCK_BLADES);
	ADD_GROUP("Simulation", "");
	add_numbers(SPECIES_PARAM_NATURAL_FREQUENCY, SPECIES_PARAM_BEND_STIFFNESS);
	ADD_GROUP("Map", "");
	add_numbers(SPECIES_PARAM_WEAR_RECOVERY, SPECIES_PARAM_WEAR_RECOVERY);
	ADD_GROUP("Look", "");
	add_colors(SPECIES_ROOT_COLOR, SPECIES_DRY_COLOR);
	GRASS_BIND_PROPERTY_AS(GrassSpecies, PropertyInfo(Variant::OBJECT, "gradient", PROPERTY_HINT_RESOURCE_TYPE, "Gradient"), set_gradient,
			get_gradient, "gradient");
	add_numbers(SPECIES_PARAM_DRY, SPECIES_PARAM_HUE_VARIATION);
	ADD_GROUP("Card", "card");
	GRASS_BIND_PROPERTY_AS(
			GrassSpecies, PropertyInfo(Variant::OBJECT, "card", PROPERTY_HINT_RESOURCE_TYPE, "Texture2D"), set_card, get_card, "card");
	add_colors(SPECIES_CARD_COLOR, SPECIES_CARD_COLOR);
	add_numbers(SPECIES_PARAM_CARD_SHARE, SPECIES_PARAM_CARD_PICTURES);
	ADD_GROUP("Leaf", "leaf");
	GRASS_BIND_PROPERTY_AS(
			GrassSpecies, PropertyInfo(Variant::OBJECT, "leaf", PROPERTY_HINT_RESOURCE_TYPE, "Texture2D"), set_leaf, get_leaf, "leaf");
	add_numbers(SPECIES_PARAM_LEAF_SIZE, SPECIES_PARAM_LEAF_SIZE);
	ADD_GROUP("Plant", "");
	GRASS_BIND_PROPERTY_AS(GrassSpecies, PropertyInfo(Variant::OBJECT, "plant_mesh", PROPERTY_HINT_RESOURCE_TYPE, "Mesh"), set_plant_mesh,
			get_plant_mesh, "mesh");
	add_numbers(SPECIES_PARAM_PLANT_DISTANCE, SPECIES_PARAM_STEMS);
	GRASS_BIND_PROPERTY_AS(GrassSpecies, PropertyInfo(Variant::OBJECT, "plant_scene", PROPERTY_HINT_RESOURCE_TYPE, "PackedScene"),
			set_plant_scene, get_plant_scene, "scene");
	add_numbers(SPECIES_PARAM_PLANT_SCENE_DISTANCE, SPECIES_PARAM_PLANT_SCENE_DISTANCE);
}

} // namespace grass

// SPDX-License-Identifier: MIT
// GrassSpecies: one kind of plants in the mix of a GrassField. Properties only.
#pragma once

#include "draw/plant_impostor.h"
#include "draw/plant_model.h"
#include "draw/species_look.h"
#include "resources/grass_patch.h"
#include "resources/species_params.h"
#include "shared/label.h"
#include "shared/property_value.h"

#include <godot_cpp/classes/gradient.hpp>
#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/packed_scene.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/texture2d.hpp>

#include <optional>

namespace grass {

class GrassSpecies : public godot::Resource {
	GDCLASS(GrassSpecies, godot::Resource)

public:
	GrassSpecies();

	void set_patch(const godot::Ref<GrassPatch> &p_patch); // null: the default patch
	godot::Ref<GrassPatch> get_patch() const { return value_of(_patch); }
	void set_gradient(const godot::Ref<godot::Gradient> &p_gradient); // null: from root_color to tip_color
	godot::Ref<godot::Gradient> get_gradient() const { return value_of(_gradient); }
	void set_card(const godot::Ref<godot::Texture2D> &p_card); // null: no flower or seed head
	godot::Ref<godot::Texture2D> get_card() const { return value_of(_card); }
	void set_leaf(const godot::Ref<godot::Texture2D> &p_leaf); // null: blades end in a tip
	godot::Ref<godot::Texture2D> get_leaf() const { return value_of(_leaf); }
	void set_plant_mesh(const godot::Ref<godot::Mesh> &p_mesh); // null: blades
	godot::Ref<godot::Mesh> get_plant_mesh() const { return value_of(_plant_mesh); }
	void set_plant_scene(const godot::Ref<godot::PackedScene> &p_scene); // null: plants are only drawn
	godot::Ref<godot::PackedScene> get_plant_scene() const { return value_of(_plant_scene); }
	// Set and get indexed properties: numbers (SPECIES_PARAMS) and colours (SPECIES_COLORS).
	void set_param(int64_t p_param, double p_value);
	double get_param(int64_t p_param) const;
	godot::Variant _get_param(int64_t p_param) const; // for the property: an int if it is a whole number
	void set_color(int64_t p_index, const godot::Color &p_color);
	godot::Color get_color(int64_t p_index) const;

	std::shared_ptr<const Patch> find_patch() const;
	bool prepare_patch() const; // whether find_patch() returns it at once; if not, starts making it
	SpeciesParams get_mix() const;
	// Returns the species' solver. p_field: the solver's parameters that are not the species' own.
	SolverParams get_solver(const SolverParams &p_field) const;
	SpeciesLook get_look(); // without canopies
	// Return the pictures of `card` and `leaf`, as read_card() of draw/species_look.h does.
	std::vector<godot::Ref<godot::Image>> read_card() const;
	std::vector<godot::Ref<godot::Image>> read_leaf() const;
	SpeciesLook make_look(const std::vector<godot::Ref<godot::Image>> &p_card,
			const godot::Ref<godot::Image> &p_leaf) const; // the same with images of read_card() and read_leaf()
	int get_card_pictures() const { return int(param(SPECIES_PARAM_CARD_PICTURES)); }
	double get_wear_recovery() const { return param(SPECIES_PARAM_WEAR_RECOVERY); } // per minute
	double get_card_size() const; // how far a card or leaf extends from the tip, metres; 0: neither
	double get_leaf_area(); // area that the mean blade's leaf covers, m^2
	// Returns whether it has two colours, no card, no leaf, no mesh and one stem: shaders without species draw a field of only this
	// species.
	bool is_plain() const { return _gradient.is_null() && _card.is_null() && _leaf.is_null() && _plant_mesh.is_null() && get_stems() == 1; }
	int get_stems() const; // number of blades that share a root: a power of two
	Tussocks get_tussocks() const { return { param(SPECIES_PARAM_TUSSOCK_SHARE), int(param(SPECIES_PARAM_TUSSOCK_BLADES)) }; }
	// Returns the mesh in the form for drawing, or null.
	std::shared_ptr<const PlantModel> find_plant() const;
	// Returns the impostor of the mesh, or null. At first use it begins to be drawn.
	std::shared_ptr<const PlantImpostor> find_impostor() const;
	godot::String get_plant_problem() const; // why it cannot be drawn although a mesh is set; empty: it can
	double get_plant_distance() const { return param(SPECIES_PARAM_PLANT_DISTANCE); } // metres
	double get_plant_scene_distance() const { return param(SPECIES_PARAM_PLANT_SCENE_DISTANCE); } // metres
	// Returns the height for which a plant's scene is made: that of the mesh, in its own units; without a mesh p_mean_length, that of a
	// blade.
	float find_plant_height(float p_mean_length) const;

protected:
	static void _bind_methods();

private:
	godot::String label() const { return label_of(*this); } // for messages
	void _part_changed();
	void read_pictures();
	double param(SpeciesParamId p_param) const { return _params[size_t(p_param)]; }

	godot::Ref<GrassPatch> _patch;
	godot::Ref<godot::Gradient> _gradient;
	godot::Ref<godot::Texture2D> _card;
	godot::Ref<godot::Texture2D> _leaf;
	std::vector<godot::Ref<godot::Image>> _card_images; // of _card, read on first use
	godot::Ref<godot::Image> _leaf_image; // of _leaf, read on first use
	double _leaf_cover = 0.0; // of _leaf, 0..1
	godot::Ref<godot::Mesh> _plant_mesh;
	godot::Ref<godot::PackedScene> _plant_scene;
	mutable std::optional<PlantReading> _plant; // of _plant_mesh, read on first use
	mutable std::shared_ptr<const PlantImpostor> _impostor; // of _plant, made on first use
	std::array<double, SPECIES_PARAM_COUNT> _params = initial_of(SPECIES_PARAMS);
	std::array<godot::Color, SPECIES_COLOR_COUNT> _colors;
};

} // namespace grass

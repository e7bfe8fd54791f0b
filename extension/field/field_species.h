// SPDX-License-Identifier: MIT
// A field's species: from the list of resources to one patch, one mix, and the steps of a tick. An empty list counts as one species
// with the defaults (docs/history/0023-always-a-species.md).
#pragma once

#include "core/blades/patch.h"
#include "core/solver/solver_params.h"
#include "core/species/species.h"
#include "draw/drawn_plant.h"
#include "resources/grass_species.h"

#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace grass {

// A species of a running field, with the patch that it was made with.
struct GrownSpecies {
	godot::Ref<GrassSpecies> species;
	std::shared_ptr<const Patch> patch;
};

// Returns the field's solver as each species has it.
std::vector<SolverParams> solvers_of(const std::vector<GrownSpecies> &p_species, const SolverParams &p_field);

std::vector<std::shared_ptr<const Patch>> patches_of(const std::vector<GrownSpecies> &p_species);

// The list that the node's property holds.
class FieldSpecies {
public:
	using List = std::vector<godot::Ref<GrassSpecies>>;

	// Sets the list. p_changed: called when one of them changes.
	void set(const godot::TypedArray<GrassSpecies> &p_species, const godot::Callable &p_changed);
	godot::TypedArray<GrassSpecies> get() const;
	// Returns whether it is one species without gradient and card: then shaders and passes for several are not needed.
	bool is_plain() const;

	// Sets how gravity in the field's axes differs from that of level ground, m/s^2: see find_pull(). It changes the patches.
	void set_pull(const Eigen::Vector3d &p_pull) { _pull = p_pull; }
	const Eigen::Vector3d &get_pull() const { return _pull; }
	// Makes threads prepare the missing patches. Returns true once none is missing.
	bool prepare_patches() const;
	// Reads the meshes that are not read yet. Meshes may be scripts: returns false if one of them freed p_field, and this object with it.
	[[nodiscard]] bool read_plants(const godot::Object &p_field) const;
	// Returns the species that are used. An empty place in the list counts as a species, so that the numbers of the others stay the same.
	List find_used() const;
	std::vector<SpeciesParams> find_mix() const;
	std::vector<GrownSpecies> find_grown() const;
	// Returns the radius of the largest flower, seed head or leaf around its tip, in metres. A card on a thinned tile is drawn larger.
	float find_card_size() const;
	float find_leaf_area() const; // of the mean blade, m^2
	// Returns the meshes of the species in the order of find_used(); null: none. p_density is in blades per square metre.
	std::vector<DrawnPlant> find_plants(double p_density) const;
	bool has_plant_meshes() const; // whether they can be drawn or not, since reading them may run scripts
	bool has_plant_scenes() const;
	std::vector<int> find_stems() const; // that share a root
	bool is_joined() const; // the patch of join() matches the present species
	// Returns all species' blades as one patch; it is the same patch until they change.
	std::shared_ptr<const Patch> join() const;
	void warn(godot::PackedStringArray &r_warnings, double p_density) const;

private:
	struct Joining { // what a joined patch is made of
		std::vector<std::shared_ptr<const Patch>> from;
		std::vector<double> shares;
		std::vector<int> stems;
		std::vector<Tussocks> tussocks;
		bool operator==(const Joining &) const = default;
	};

	static std::shared_ptr<const Patch> find_join(const Joining &p_joining);
	Joining find_joining() const;
	bool is_upright() const { return _pull.isZero(0.0); }
	std::shared_ptr<const Patch> find_patch(const GrassSpecies &p_species) const;
	std::vector<double> find_shares() const;
	void warn_of_plants(int64_t p_species, double p_density, godot::PackedStringArray &r_warnings) const;

	List _list; // may hold empty ones
	Eigen::Vector3d _pull = Eigen::Vector3d::Zero();
	mutable std::shared_ptr<const Patch> _joined;
	mutable Joining _joined_of;
};

} // namespace grass

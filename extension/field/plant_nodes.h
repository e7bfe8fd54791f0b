// SPDX-License-Identifier: MIT
// The nodes of plants: instances of GrassSpecies.plant_scene at the plants that core/field/plant_search chooses. They are kept below a node
// of their own inside of the field; those that are not used wait outside of the tree.
#pragma once

#include "core/field/field_statistics.h"
#include "core/field/plant_search.h"
#include "field/field_host.h"
#include "field/plant_eyes.h"
#include "field/standing_field.h"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/packed_scene.hpp>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace grass {

class PlantNodes {
public:
	// Begins without nodes. The host's node emits plant_node_appeared and plant_node_leaving.
	explicit PlantNodes(FieldHost &p_host) : _host(p_host) {}
	~PlantNodes();

	// Returns whether update() has anything to do for these species.
	bool is_used(const StandingField &p_standing) const;
	// Gives plants near eyes their nodes, and takes those of others away, a few in each tick. Must be called once a tick. p_tracker: knows
	// the bodies near the field. Returns false if a script freed the field.
	[[nodiscard]] bool update(StandingField &r_standing, const FieldProperties &p_properties, const BodyTracker &p_tracker);
	// Must be called while the field leaves the tree: no plant has a node then. Returns false if a script freed the field.
	[[nodiscard]] bool leave();
	// Must be called once the field has left the tree, which does not release its nodes before. Returns false if a script freed the field.
	[[nodiscard]] bool put_away();
	bool is_waiting() const { return !_left.empty(); } // for put_away()

	int64_t get_memory_usage() const { return int64_t(_search.get_memory_usage()); } // bytes, without the nodes
	void add_to(FieldStatistics &r_statistics) const;

private:
	using Scene = godot::Ref<godot::PackedScene>;
	using Scenes = std::array<Scene, GRASS_MAX_SPECIES>;
	struct Shown {
		StandingScene plant;
		Scene scene;
		float scale = 1.0f;
		uint64_t node = 0; // instance id; of no node once the game has freed it
	};

	Scenes find_scenes(const StandingField &p_standing) const;
	std::span<const StandingScene> choose(
			StandingField &r_standing, const FieldProperties &p_properties, const BodyTracker &p_tracker, const Scenes &p_scenes);
	bool follow_scale();
	godot::Node3D *find_holder() const;
	godot::Node3D *need_holder();
	void free_strayed_holder();
	bool show(const StandingScene &p_plant, const Scene &p_scene, float p_scale);
	bool hide(BladeNumber p_blade);
	bool store(const Shown &p_shown, godot::Node3D *p_holder);
	godot::Node3D *take(const Scene &p_scene);
	bool make(const Scene &p_scene, int p_species, godot::Node3D *&r_node);
	void drop_unused(const Scenes &p_scenes);

	FieldHost &_host;
	PlantEyes _eyes;
	PlantSearch _search;
	uint64_t _holder = 0; // instance id of the node above the scenes
	std::map<BladeNumber, Shown> _shown;
	std::vector<Shown> _left; // still below the holder, see put_away()
	std::vector<std::pair<Scene, uint64_t>> _stored; // out of the tree: scene, instance id
	std::vector<Scene> _failed; // scenes that make no Node3D
	uint64_t _leaves = 0; // calls of leave(), by which a loop notices one
};

} // namespace grass

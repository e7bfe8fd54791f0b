// SPDX-License-Identifier: MIT
// The fields of a world's plots, copies of one scene. When a plot leaves, its field waits, hidden, for the next plot, so that none of its
// buffers is made again.
#pragma once

#include "core/map/paint_map.h"
#include "nodes/grass_field.h"

#include <godot_cpp/classes/packed_scene.hpp>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace grass {

class WorldFields {
public:
	// The most fields that wait.
	static constexpr size_t MOST_SPARE = 3;

	// What the scene defines for all of them.
	struct Pattern {
		PaintMap map; // of plots without a file
		bool has_terrain = false;
		int64_t pool_tiles = 0;
		uint32_t collision_mask = 1, layers = 1;
		double tile_size = 0.0; // metres
	};

	explicit WorldFields(godot::Node3D &p_world) : _world(p_world) {}
	WorldFields(const WorldFields &) = delete;
	WorldFields &operator=(const WorldFields &) = delete;
	~WorldFields() { forget_first(); }

	// Starts. p_scene: its root is a GrassField; null: one with the defaults. p_side: of a plot, metres. p_label: of the world, for
	// messages. Scripts of the scene run: afterwards this object may be gone, with the world.
	void start(const godot::Ref<godot::PackedScene> &p_scene, double p_side, const godot::String &p_label);
	// Removes the waiting fields from the tree.
	void stop();

	const Pattern &get_pattern() const { return _pattern; }
	// Returns where plots' maps will be shown, so that they are prepared for it; nothing until it is known. Scripts of the scene may run:
	// afterwards this object may be gone, with the world.
	const std::optional<MapPlace> &get_place() const { return _place; }
	void find_place();
	bool has_wrong_scene() const { return _has_wrong_scene; }
	size_t count_spare() const { return _spare.size(); }
	const std::vector<uint64_t> &get_spare() const { return _spare; } // instance ids
	void forget_lost(); // forgets those that a script freed, or removed from the tree
	// Returns a waiting field, or a new one; it is hidden, and in the tree. Returns null if a script of the scene freed it or removed it
	// from the tree; afterwards this object may be gone, with the world.
	GrassField *take();
	const godot::Node3D &get_world() const { return _world; }
	// Takes back the field of a plot that has left. p_keeps: it may wait for the next plot. One that a script has removed from the tree
	// belongs to the game.
	void give_back(GrassField *p_field, bool p_keeps);
	void free_spare(); // one of them
	int64_t get_made() const { return _made; } // since start()

private:
	// The most fields that are made to find the place, one after the other, if scripts of the scene free them.
	static constexpr int MOST_FIRST = 3;

	GrassField *make(); // null: a script of the scene has freed the world
	FieldReport::WarningTeller make_teller() const;
	GrassField *make_first();
	void forget_first();

	godot::Node3D &_world;
	godot::Ref<godot::PackedScene> _scene;
	double _side = 0.0;
	godot::String _label;
	std::shared_ptr<std::set<std::string>> _warned_of = std::make_shared<std::set<std::string>>(); // printed by any of the fields
	Pattern _pattern;
	uint64_t _first = 0; // instance id of a field outside of the tree, until the place is known; 0: none
	int _firsts = 0; // so far
	std::optional<MapPlace> _place;
	bool _has_wrong_scene = false;
	std::vector<uint64_t> _spare; // instance ids
	int64_t _made = 0;
};

GrassField *field_with(uint64_t p_id); // null: freed

} // namespace grass

// SPDX-License-Identifier: MIT
// The fields of a world's plots, copies of one scene. One whose plot has left waits, hidden, for the next plot, so that none of its
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
	// How many wait at most.
	static constexpr size_t MOST_SPARE = 3;

	// What the scene says of all of them.
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

	// p_scene: its root is a GrassField; null: one with the defaults. p_side: of a plot, metres. p_label: of the world, for messages.
	// Scripts of the scene run: afterwards this may be gone, with the world.
	void start(const godot::Ref<godot::PackedScene> &p_scene, double p_side, const godot::String &p_label);
	// Those that wait leave the tree.
	void stop();

	const Pattern &get_pattern() const { return _pattern; }
	// For what plots' maps are prepared; nothing until it is known.
	const std::optional<MapPlace> &find_place();
	bool has_wrong_scene() const { return _has_wrong_scene; }
	size_t count_spare() const { return _spare.size(); }
	void forget_freed(); // by a script
	// One that waits, or a new one; a hidden child of the world. Null where a script of the scene freed it or took it out of the tree;
	// afterwards this may be gone, with the world.
	GrassField *take();
	const godot::Node3D &get_world() const { return _world; }
	// Its plot has left. p_keeps: it may wait for the next one.
	void give_back(GrassField *p_field, bool p_keeps);
	void free_spare(); // one of them
	int64_t get_made() const { return _made; } // since start()

private:
	GrassField *make(); // null: a script of the scene freed the world
	GrassField::WarningTeller make_teller() const;
	void forget_first();

	godot::Node3D &_world;
	godot::Ref<godot::PackedScene> _scene;
	double _side = 0.0;
	godot::String _label;
	std::shared_ptr<std::set<std::string>> _warned_of = std::make_shared<std::set<std::string>>(); // by any of the fields
	Pattern _pattern;
	GrassField *_first = nullptr; // outside of the tree, until the place is known
	std::optional<MapPlace> _place;
	bool _has_wrong_scene = false;
	std::vector<uint64_t> _spare; // instances' ids
	int64_t _made = 0;
};

GrassField *field_with(uint64_t p_id); // null: freed

} // namespace grass

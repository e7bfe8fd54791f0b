// SPDX-License-Identifier: MIT
// The properties of a GrassWorld, and what follows from them alone.
#pragma once

#include "core/world/world_plan.h"
#include "world/kept_plots.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/packed_scene.hpp>
#include <godot_cpp/variant/vector2.hpp>

namespace grass {

struct WorldProperties {
	WorldGrid grid() const { return { { size.x, size.y }, plot_size }; }
	size_t budget() const { return size_t(memory_budget * 1e6); } // bytes
	// The editor shows what a level has, not what a game made of it.
	PlotsPlace place() const { return { folder, save_folder.is_empty() || is_edited() ? folder : save_folder, plot_size }; }
	static bool is_edited() { return godot::Engine::get_singleton()->is_editor_hint(); }

	godot::Vector2 size{ godot::real_t(WorldGrid::SIZE.initial), godot::real_t(WorldGrid::SIZE.initial) }; // metres along x and z
	double plot_size = WorldGrid::PLOT_SIZE.initial, camera_radius = WORLD_CAMERA_RADIUS.initial,
		   body_radius = WORLD_BODY_RADIUS.initial; // metres
	double memory_budget = WORLD_MEMORY_BUDGET.initial; // MB
	godot::Ref<godot::PackedScene> scene; // its root is a GrassField; null: one with the defaults
	godot::String folder, save_folder;
};

} // namespace grass

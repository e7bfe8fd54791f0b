// SPDX-License-Identifier: MIT
// Cuts and paints the grass of a world, in all plots that are in memory. Places are global.
#pragma once

#include "world/world_plots.h"

namespace grass {

// Listeners of the maps may free the world, and this object with it: nothing may follow a call.
class WorldWork {
public:
	WorldWork(godot::Node3D &p_world, const WorldPlots &p_plots) : _world(p_world), _plots(p_plots) {}

	CutResult cut(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);
	double paint(const godot::Ref<GrassBrush> &p_brush, const godot::Vector3 &p_from, const godot::Vector3 &p_to);

private:
	// Runs p_work(key, work of its field) for each plot, until a script has freed the world.
	template <typename F> void in_plots(F &&p_work);

	godot::Node3D &_world;
	const WorldPlots &_plots;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// Measures the memory that a world's plots use. Decides which plots the budget holds, and how large their pools may become.
#pragma once

#include "core/world/world_plan.h"
#include "world/plot.h"

namespace grass {

class PlotMemory {
public:
	// Measures a world. p_plots, p_fields: the world's; they must outlive this object.
	PlotMemory(Plots &p_plots, const WorldFields &p_fields) : _plots(p_plots), _fields(p_fields) {}

	// Starts with nothing measured.
	void start(size_t p_budget);
	void set_budget(size_t p_budget) { _budget = p_budget; } // bytes
	// Measures one plot, in turn, and those that have just appeared. Must be called in each frame.
	void measure();
	void make_plan(const WorldGrid &p_grid, std::span<const WorldEye> p_eyes);
	const WorldPlan &get_plan() const { return _plan; }
	// Lets pools grow by what the budget has left, for which other plots leave.
	void limit_pools();
	int64_t find_most_slots() const; // that any plot may have
	// Returns whether the plot may come now.
	bool has_room_for(const PlotKey &p_key) const;
	bool is_exceeded() const { return count_bytes() > _budget; } // the budget
	size_t count_used() const; // bytes in use now

private:
	size_t count_bytes() const; // that the budget pays for: of fields and maps, including those that wait
	size_t count_shared() const;
	size_t count_pool(const GrassField &p_field, const FieldMemory &p_measured) const;
	std::vector<LoadedPlot> find_loaded() const;

	Plots &_plots;
	const WorldFields &_fields;
	size_t _budget = 0; // bytes
	WorldPlanner _planner;
	WorldPlan _plan;
	int64_t _pool_tile = 0; // bytes for each slot of a pool; 0 until a field runs
	PlotKey _measured{ 1 << 30, 0 }; // the plot measured last
};

} // namespace grass

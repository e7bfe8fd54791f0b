// SPDX-License-Identifier: MIT
// What a world reports: warnings, in the inspector and in the console, and statistics.
#pragma once

#include "world/world_eyes.h"
#include "world/world_plots.h"
#include "world/world_properties.h"

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace grass {

class WorldReport {
public:
	WorldReport(godot::Node3D &p_world, const WorldProperties &p_properties, const WorldPlots &p_plots, const WorldEyes &p_eyes) :
			_world(p_world), _properties(p_properties), _plots(p_plots), _eyes(p_eyes) {}

	// Starts again, with other properties.
	void restart();
	// Ends a frame, which took p_ms.
	void count_frame(double p_ms);
	// Prints each warning once, and again when the budget falls far shorter than reported. In the editor the node shows them.
	void print_warnings();
	// Warns of unwritten changes. Must be called before the node ends.
	void print_loss() const;
	godot::PackedStringArray get_warnings() const;
	godot::Dictionary get_statistics() const;

private:
	// How far the budget is from holding everything.
	struct Shortage {
		bool is_short = false;
		double reach = 0.0; // metres
		size_t missing = 0; // bytes
		bool is_worse_than(const Shortage &p_other) const;
	};
	godot::PackedStringArray find_warnings() const; // all but the shortage
	godot::String describe_shortage() const; // "": the budget holds everything

	godot::Node3D &_world;
	const WorldProperties &_properties;
	const WorldPlots &_plots;
	const WorldEyes &_eyes;
	Shortage _shortage; // in the last warning
	bool _has_printed = false; // all other warnings, since restart()
	godot::PackedStringArray _warned_of; // in the console
	double _frame_ms = 0.0, _most_frame_ms = 0.0; // of the last frame; of any since restart()
};

} // namespace grass

// SPDX-License-Identifier: MIT
// The plots of a world in memory: read by a thread, added to the tree one at a time, kept while they are wanted, and written if they
// changed when they leave.
#pragma once

#include "shared/script_call.h"
#include "world/plot_memory.h"
#include "world/world_files.h"

#include <functional>
#include <vector>

namespace grass {

struct WorldSettings {
	WorldGrid grid;
	godot::Ref<godot::PackedScene> scene; // of a plot's field; null: a GrassField with the defaults
	size_t budget = 0; // bytes
};

struct WorldStatistics {
	int64_t plots = 0, waiting = 0, changed = 0; // now; waiting ones are being read or made
	int64_t memory = 0; // bytes in use
	int64_t brought = 0, left = 0, fields_made = 0; // since the world entered the tree
	int64_t most_moves = 0; // most plots that were added or left in one frame
	int64_t tests = 0; // distances and paths that the last frame compared with plots
};

class WorldPlots {
public:
	using Tell = std::function<void(const char *p_signal, const PlotKey &p_key, GrassField *p_field)>;

	WorldPlots(godot::Node3D &p_world, Tell p_tell) : _fields(p_world), _tell(std::move(p_tell)) {}

	// Starts when the world is in the tree. This and update() run scripts: afterwards this object may be gone, with the world.
	void start(const WorldSettings &p_settings, const WorldFolders &p_folders);
	// Writes changed plots, unless p_forgets; the fields are freed with the world's children.
	void stop(bool p_forgets = false);
	bool is_running() const { return _is_running; }
	void set_budget(size_t p_bytes) { _memory.set_budget(p_bytes); }
	void update(std::span<const WorldEye> p_eyes); // runs a frame

	GrassField *find(const PlotKey &p_key) const; // null: not in memory, or not made yet
	std::vector<PlotKey> get_standing() const;
	int64_t save(); // returns the number of plots to write
	// Sets a plot to p_to wherever that differs from p_from, even if it is not in memory.
	void restore(const PlotKey &p_key, const PaintMap &p_from, const PaintMap &p_to);
	const WorldPlan &get_plan() const { return _memory.get_plan(); }
	const WorldGrid &get_grid() const { return _settings.grid; }
	const WorldFields &get_fields() const { return _fields; }
	WorldFiles &get_files() { return _files; }
	const WorldFiles &get_files() const { return _files; }
	uint32_t find_layers() const; // of the grass in the tree, and of the plots that follow
	WorldStatistics get_statistics() const;

private:
	using State = Plot::State;

	void take_read();
	// Runs a part of a frame in which scripts may run. Returns false if a script ended the world, freed it, or removed it from the tree;
	// the frame ends then.
	template <typename F> bool run(F &&p_step) { return outlives(_fields.get_world(), p_step) && _is_running; }
	// world_plots_moves.cpp
	void look_after_fields();
	void make_empty(const PlotKey &p_key);
	void tell_once(bool &r_has_told, const PlotKey &p_key, const char *p_text) const;
	bool make_fields();
	void show_coming();
	void bring_one();
	void bring(PlotKey p_key);
	void leave_one();
	void leave(PlotKey p_key, uint64_t p_field);
	bool is_changed(const Plot &p_plot, const GrassField &p_field) const;
	bool is_coming() const;
	void ask();

	WorldFields _fields;
	Tell _tell;
	WorldSettings _settings;
	WorldFiles _files;
	Plots _plots;
	PlotMemory _memory{ _plots, _fields };
	int64_t _asks = 0; // so far
	bool _is_running = false;
	godot::String _label; // of the world, for messages
	bool _told_of_empty = false, _told_of_taken = false; // since it entered the tree
	WorldStatistics _statistics;
};

} // namespace grass

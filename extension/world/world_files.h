// SPDX-License-Identifier: MIT
// The maps of a world's plots, in files. One thread reads and writes them in the order of the requests, so that a plot that returns at once
// is read as it was written. Where there are no threads, each request is answered at once.
#pragma once

#include "core/map/read_limits.h"
#include "core/world/world_grid.h"
#include "field/shown_map.h"
#include "world/kept_plots.h"

#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <set>
#include <vector>

namespace grass {

struct WorldFolders {
	PlotsPlace place; // folders of maps and of changed maps, and the size of their plots
	godot::String label; // of the world, for messages
	bool keeps = false; // changed maps stay in memory until they are saved: in the editor, and if there is no folder
};

// A plot's map as read, and prepared for its field.
struct ReadPlot {
	PlotKey key;
	int64_t ask = 0; // the request that it answers
	PaintMap map;
	std::unique_ptr<ShownMap> prepared;
};

struct WorldFileStatistics {
	int64_t waiting = 0; // jobs
	int64_t read = 0, written = 0, refused = 0; // files
	int64_t kept = 0; // maps that are not written yet
	int64_t kept_elsewhere = 0; // kept maps that belong to other folders, or to plots of another size
};

class WorldFiles {
public:
	~WorldFiles() { stop(); }

	void start(const WorldFolders &p_folders);
	// Waits until everything is written, and ends the thread.
	void stop();
	// Requests a plot's map. p_ask: is returned with it; p_default: the map if there is no file; p_place: the field that it is for.
	void read(const PlotKey &p_key, int64_t p_ask, const PaintMap &p_default, const MapPlace &p_place);
	void write(const PlotKey &p_key, const PaintMap &p_map);
	// Changes a plot that is not in memory, and writes it.
	void change(const PlotKey &p_key, const PaintMap &p_default, const std::function<void(PaintMap &)> &p_change);
	// Writes the kept maps, each to its own folder.
	void write_kept();
	// Moves, while no thread runs, what is kept for other folders to the current ones. Returns the number of plots.
	int64_t carry_kept();
	// Forgets, while no thread runs, what is kept. Returns the number of plots.
	int64_t discard_kept();
	void discard_kept_elsewhere();
	int64_t count_writable() const; // number of kept plots that write_kept() has a folder for
	void wait(); // until nothing is waiting
	std::vector<ReadPlot> take_read();
	WorldFileStatistics get_statistics() const;
	static godot::String path_of(const godot::String &p_folder, const PlotKey &p_key);
	// Returns the paths of all plots in a folder.
	static godot::PackedStringArray find_plots(const godot::String &p_folder);
	// Returns what is wrong with the folders, for the user; "" if nothing is.
	godot::String find_problem() const;

private:
	struct Job {
		bool is_read; // otherwise it writes, and must not be lost
		std::function<void()> run;
	};

	void add(Job &&p_job);
	void wait_until(std::unique_lock<std::mutex> &r_lock, const std::function<bool()> &p_is_done);
	void work();
	PaintMap find(const PlotKey &p_key, const PaintMap &p_default);
	ReadLimits limits() const; // of a plot's file
	bool read_file(const godot::String &p_path, PaintMap &r_map);
	void put(const PlotKey &p_key, const PaintMap &p_map);
	bool may_write(const PlotsPlace &p_place) const;
	void write_file(const PlotsPlace &p_place, const PlotKey &p_key, const godot::PackedByteArray &p_data);
	void keep(const PlotsPlace &p_place, const PlotKey &p_key, const godot::PackedByteArray &p_data);

	WorldFolders _folders; // changes only while no thread runs, like the next two
	FoldersOfSize _sizes; // what the folders hold
	bool _makes_textures = false;
	std::future<void> _thread; // not valid: requests are answered at once
	mutable std::mutex _mutex; // guards everything below
	std::condition_variable _has_changed;
	std::deque<Job> _jobs; // the first one is in progress
	bool _is_ending = false, _has_ended = true;
	std::vector<ReadPlot> _read;
	KeptPlots _kept;
	std::set<std::string> _refused; // paths of files that cannot be read
	WorldFileStatistics _statistics;
};

} // namespace grass

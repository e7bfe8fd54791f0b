// SPDX-License-Identifier: MIT
#include "world/world_plots.h"

#include "core/map/map_merge.h"
#include "core/world/plot_map.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Most plots that are read ahead of those that appear.
constexpr int MOST_READ = 2;
} // namespace

GrassField *WorldPlots::find(const PlotKey &p_key) const {
	const auto found = _plots.find(p_key);
	return found != _plots.end() && found->second.state == State::STANDING ? found->second.get_field() : nullptr;
}

void WorldPlots::start(const WorldSettings &p_settings, const WorldFolders &p_folders) {
	stop();
	_settings = p_settings;
	_label = p_folders.label;
	_told_of_empty = _told_of_taken = false;
	_statistics = {};
	_memory.start(p_settings.budget);
	const auto start_fields = [&] { _fields.start(p_settings.scene, p_settings.grid.get_plot_size(), p_folders.label); };
	if (!outlives(_fields.get_world(), start_fields) || _is_running) { // a script of the scene restarted the world
		return;
	}
	_files.start(p_folders);
	_is_running = true;
}

void WorldPlots::stop(bool p_forgets) {
	if (!_is_running) {
		return;
	}
	if (!p_forgets) {
		save();
	}
	for (auto &[key, plot] : _plots) {
		GrassField *field = plot.get_field();
		if (field != nullptr && field->get_parent() != nullptr) { // otherwise it is the game's
			field->queue_free();
		}
	}
	_fields.stop();
	_plots.clear();
	_files.stop();
	_is_running = false;
}

void WorldPlots::update(std::span<const WorldEye> p_eyes) {
	const int64_t moves = _statistics.brought + _statistics.left;
	take_read();
	look_after_fields();
	if (!make_fields() || !run([&] { show_coming(); })) {
		return;
	}
	_memory.measure();
	_memory.make_plan(_settings.grid, p_eyes);
	_memory.limit_pools();
	if (!run([&] { leave_one(); }) || !run([&] { bring_one(); }) || !run([&] { _fields.find_place(); })) {
		return;
	}
	ask();
	_statistics.most_moves = std::max(_statistics.most_moves, _statistics.brought + _statistics.left - moves);
}

void WorldPlots::take_read() {
	for (ReadPlot &read : _files.take_read()) {
		const auto found = _plots.find(read.key);
		if (found != _plots.end() && found->second.state == State::ASKED && found->second.ask == read.ask) {
			found->second.known = std::move(read.map);
			found->second.prepared = std::move(read.prepared);
			found->second.state = State::READ;
		}
	}
}

// Requests the nearest wanted plot that is not requested yet.
void WorldPlots::ask() {
	const std::optional<MapPlace> place = _fields.get_place();
	if (!place) {
		return;
	}
	const auto count = std::ranges::count_if(
			_plots, [](const auto &p_entry) { return p_entry.second.state == State::ASKED || p_entry.second.state == State::READ; });
	for (const PlotKey &key : _memory.get_plan().wanted) {
		if (count >= MOST_READ) {
			return;
		}
		if (!_plots.contains(key)) {
			_plots[key].ask = ++_asks;
			_files.read(key, _asks, _fields.get_pattern().map, *place);
			return;
		}
	}
}

uint32_t WorldPlots::find_layers() const {
	uint32_t layers = _fields.get_pattern().layers;
	for (const auto &[key, plot] : _plots) {
		const GrassField *field = plot.get_field(); // null: it is still being read
		layers |= field != nullptr ? field->get_layer_mask() : 0u;
	}
	return layers;
}

std::vector<PlotKey> WorldPlots::get_standing() const {
	std::vector<PlotKey> keys;
	for (const auto &[key, plot] : _plots) {
		if (plot.state == State::STANDING && plot.get_field() != nullptr) {
			keys.push_back(key);
		}
	}
	return keys;
}

int64_t WorldPlots::save() {
	int64_t count = 0;
	for (auto &[key, plot] : _plots) {
		const GrassField *field = plot.get_field();
		if (field != nullptr && is_changed(plot, *field)) {
			plot.known = field->get_map()->get_map();
			_files.write(key, kept_of(plot.known, _fields.get_pattern().has_terrain));
			count++;
		}
	}
	return count;
}

// Restores a plot. One that is being read is read again, since the earlier request returns its old state.
void WorldPlots::restore(const PlotKey &p_key, const PaintMap &p_from, const PaintMap &p_to) {
	const bool has_terrain = _fields.get_pattern().has_terrain;
	const auto change = [from = kept_of(p_from, has_terrain), to = kept_of(p_to, has_terrain)](
								PaintMap &r_map) { (void)merge_maps(from, to, r_map); };
	const auto found = _plots.find(p_key);
	if (GrassField *field = found != _plots.end() ? found->second.get_field() : nullptr) {
		if (field->get_map().is_null()) { // a script removed it
			return;
		}
		const Ref<GrassMapSnapshot> snapshot = field->get_map()->take_snapshot();
		change(snapshot->map);
		field->get_map()->restore_snapshot(snapshot);
		return;
	}
	if (found != _plots.end()) {
		_plots.erase(found);
	}
	_files.change(p_key, _fields.get_pattern().map, change);
}

WorldStatistics WorldPlots::get_statistics() const {
	WorldStatistics statistics = _statistics;
	statistics.tests = _memory.get_plan().tests;
	statistics.fields_made = _fields.get_made();
	for (const auto &[key, plot] : _plots) {
		const GrassField *field = plot.get_field();
		statistics.plots += plot.state == State::STANDING ? 1 : 0;
		statistics.waiting += plot.state == State::STANDING || plot.state == State::EMPTY ? 0 : 1;
		statistics.changed += field != nullptr && is_changed(plot, *field) ? 1 : 0;
	}
	statistics.memory = int64_t(_memory.count_used());
	return statistics;
}

} // namespace grass

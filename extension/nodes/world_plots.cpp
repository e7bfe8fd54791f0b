// SPDX-License-Identifier: MIT
#include "nodes/world_plots.h"

#include "convert.h"
#include "core/world/plot_map.h"

#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Plots that are read ahead of those that come.
constexpr int MOST_READ = 2;
// The pool of a plot where nothing moves: enough for a blast. More: memory in every plot.
constexpr int64_t QUIET_POOL = 32;
// Metres around a plot in which what moves has its pool made larger.
constexpr double MOVES_NEAR = 16.0;

} // namespace

GrassField *WorldPlots::field_of(const Plot &p_plot) const {
	return p_plot.field != 0 ? field_with(p_plot.field) : nullptr;
}

GrassField *WorldPlots::find(const PlotKey &p_key) const {
	const auto found = _plots.find(p_key);
	return found != _plots.end() && found->second.state == State::STANDING ? field_of(found->second) : nullptr;
}

void WorldPlots::start(const WorldSettings &p_settings, const WorldFolders &p_folders) {
	stop();
	_settings = p_settings;
	_statistics = {};
	_planner.forget();
	_fields.start(p_settings.scene, p_settings.grid.get_plot_size());
	_files.start(p_folders);
	_is_running = true;
}

void WorldPlots::stop() {
	if (!_is_running) {
		return;
	}
	save();
	for (auto &[key, plot] : _plots) {
		if (GrassField *field = field_of(plot)) {
			field->queue_free();
		}
	}
	_fields.stop();
	_plots.clear();
	_files.stop();
	_is_running = false;
}

void WorldPlots::update(std::span<const WorldEye> p_eyes, std::span<const Eigen::Vector2d> p_movers) {
	const int64_t moves = _statistics.brought + _statistics.left;
	take_read();
	show_coming();
	measure_one();
	const std::vector<PlotKey> loaded = get_keys();
	// What a plot takes is held back, for the field that comes while another one leaves.
	const size_t held_back = _shared + _planner.expected({ 1 << 30, 0 });
	_plan = _planner.plan(_settings.grid, p_eyes, loaded, _settings.budget > held_back ? _settings.budget - held_back : 0);
	leave_one();
	bring_one(p_movers);
	ask();
	fit_pool(p_movers);
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
	std::erase_if(_plots, [this](const auto &p_entry) { // a script freed its field
		return p_entry.second.field != 0 && field_of(p_entry.second) == nullptr;
	});
}

bool WorldPlots::is_coming() const {
	return std::ranges::any_of(_plots, [](const auto &p_entry) { return p_entry.second.state == State::COMING; });
}

void WorldPlots::show_coming() {
	for (auto &[key, plot] : _plots) {
		GrassField *field = field_of(plot);
		if (plot.state != State::COMING || !field->is_made()) {
			continue;
		}
		plot.state = State::STANDING;
		_statistics.most_build_ms = std::max(_statistics.most_build_ms, field->get_build_ms());
		field->set_visible(true);
		_shared = size_t(field->get_shared_memory());
		_tell("plot_loaded", key, field);
		return; // a listener may have changed everything
	}
}

// The nearest of those that are read.
void WorldPlots::bring_one(std::span<const Eigen::Vector2d> p_movers) {
	if (is_coming()) {
		return;
	}
	for (const PlotKey &key : _plan.wanted) {
		const auto found = _plots.find(key);
		if (found != _plots.end() && found->second.state == State::READ) {
			_fields.forget_freed();
			if (_fields.count_spare() > 0 || count_bytes() + _planner.expected(key) <= _settings.budget) {
				bring(key, found->second, p_movers);
			}
			return;
		}
	}
}

void WorldPlots::bring(const PlotKey &p_key, Plot &r_plot, std::span<const Eigen::Vector2d> p_movers) {
	GrassField *field = _fields.take();
	const Eigen::Vector2d centre = _settings.grid.centre(p_key);
	field->set_position(Vector3(real_t(centre.x()), 0, real_t(centre.y())));
	field->set_noise_origin(Vector2i(int32_t(centre.x()), int32_t(centre.y()))); // whole, since plots are made of whole chunks
	const int64_t pool = pool_for(p_key, p_movers);
	if (field->get_pool_tiles() != pool) {
		field->set_pool_tiles(pool);
	}
	Ref<GrassMapSnapshot> snapshot;
	snapshot.instantiate();
	snapshot->map = r_plot.known;
	Ref<GrassMap> map;
	map.instantiate();
	map->restore_snapshot(snapshot);
	field->show_map(map, std::move(r_plot.prepared));
	r_plot.field = field->get_instance_id();
	r_plot.state = State::COMING;
	_statistics.brought++;
}

// One that is read and nobody wants any more is only forgotten.
void WorldPlots::leave_one() {
	const bool is_all_here = std::ranges::all_of(_plan.wanted, [this](const PlotKey &p_key) { return find(p_key) != nullptr; });
	for (const PlotKey &key : _plan.leaving) {
		Plot &plot = _plots.at(key);
		if (plot.field == 0) {
			_plots.erase(key);
		} else if (plot.state == State::STANDING &&
				(_fields.count_spare() < WorldFields::MOST_SPARE || is_all_here || count_bytes() > _settings.budget)) {
			leave(key, plot);
			return;
		}
	}
	if (_plan.leaving.empty() && _fields.count_spare() > 0 && count_bytes() > _settings.budget) {
		_fields.free_spare();
	}
}

void WorldPlots::leave(const PlotKey &p_key, Plot &r_plot) {
	GrassField *field = field_of(r_plot);
	_tell("plot_leaving", p_key, field);
	const auto found = _plots.find(p_key);
	if (found == _plots.end() || field_of(found->second) == nullptr) { // a listener freed it
		return;
	}
	if (is_changed(found->second, *field)) {
		_files.write(p_key, kept_of(field->get_map()->get_map(), _fields.get_pattern().has_terrain));
	}
	_plots.erase(found);
	_statistics.left++;
	_fields.give_back(field, count_bytes() <= _settings.budget);
}

bool WorldPlots::is_changed(const Plot &p_plot, const GrassField &p_field) const {
	const Ref<GrassMap> map = p_field.get_map();
	return map.is_valid() && map->is_readable() &&
			!is_same(kept_of(map->get_map(), _fields.get_pattern().has_terrain), kept_of(p_plot.known, _fields.get_pattern().has_terrain));
}

// Of the wanted plots the nearest that nobody asked for.
void WorldPlots::ask() {
	const std::optional<ShownPlace> &place = _fields.find_place();
	if (!place) {
		return;
	}
	const auto count = std::ranges::count_if(
			_plots, [](const auto &p_entry) { return p_entry.second.state == State::ASKED || p_entry.second.state == State::READ; });
	for (const PlotKey &key : _plan.wanted) {
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

// One a frame, in turn.
void WorldPlots::measure_one() {
	auto next = _plots.upper_bound(_measured);
	if (next == _plots.end()) {
		next = _plots.begin();
	}
	if (next == _plots.end()) {
		return;
	}
	for (auto &[key, plot] : _plots) {
		const GrassField *field = field_of(plot);
		if (field != nullptr && (plot.bytes == 0 || key == next->first) && plot.state == State::STANDING) {
			const size_t map = field->get_map().is_valid() ? size_t(field->get_map()->get_memory_usage()) : 0;
			plot.bytes = size_t(field->get_memory_usage()) - _shared + map;
			_planner.learn(key, plot.bytes);
		}
	}
	_measured = next->first;
}

int64_t WorldPlots::pool_for(const PlotKey &p_key, std::span<const Eigen::Vector2d> p_movers) const {
	const int64_t pool = _fields.get_pattern().pool_tiles;
	const bool moves = std::ranges::any_of(
			p_movers, [&](const Eigen::Vector2d &p_place) { return _settings.grid.distance(p_key, p_place) <= MOVES_NEAR; });
	return moves ? pool : std::min(pool, QUIET_POOL);
}

// A pool costs memory, and few plots have anything that moves. One field at a time, and only while nothing comes.
void WorldPlots::fit_pool(std::span<const Eigen::Vector2d> p_movers) {
	if (is_coming()) {
		return;
	}
	for (auto &[key, plot] : _plots) {
		GrassField *field = plot.state == State::STANDING ? field_of(plot) : nullptr;
		const int64_t pool = field != nullptr ? pool_for(key, p_movers) : 0;
		if (field == nullptr || field->get_pool_tiles() == pool) {
			continue;
		}
		if (!field->is_made()) {
			return;
		}
		if (pool > field->get_pool_tiles() || field->get_awake_tile_count() == 0) {
			field->set_pool_tiles(pool);
			return;
		}
	}
}

size_t WorldPlots::count_bytes() const {
	size_t bytes = _shared;
	for (const auto &[key, plot] : _plots) {
		bytes += plot.field != 0 ? (plot.bytes > 0 ? plot.bytes : _planner.expected(key))
								 : (plot.prepared ? plot.prepared->laid.get_memory_usage() : 0);
	}
	return bytes + _fields.count_spare() * _planner.expected({ 1 << 30, 0 });
}

std::vector<PlotKey> WorldPlots::get_keys() const {
	std::vector<PlotKey> keys;
	for (const auto &[key, plot] : _plots) {
		keys.push_back(key);
	}
	return keys;
}

std::vector<PlotKey> WorldPlots::get_standing() const {
	std::vector<PlotKey> keys;
	for (const auto &[key, plot] : _plots) {
		if (plot.state == State::STANDING && field_of(plot) != nullptr) {
			keys.push_back(key);
		}
	}
	return keys;
}

int64_t WorldPlots::save() {
	int64_t count = 0;
	for (auto &[key, plot] : _plots) {
		const GrassField *field = field_of(plot);
		if (field != nullptr && is_changed(plot, *field)) {
			plot.known = field->get_map()->get_map();
			_files.write(key, kept_of(plot.known, _fields.get_pattern().has_terrain));
			count++;
		}
	}
	return count;
}

// One that is being read is read again: what was asked for comes from before.
void WorldPlots::restore(const PlotKey &p_key, const PaintMap &p_from, const PaintMap &p_to) {
	const bool has_terrain = _fields.get_pattern().has_terrain;
	const auto change = [from = kept_of(p_from, has_terrain), to = kept_of(p_to, has_terrain)](
								PaintMap &r_map) { put_back(r_map, from, to); };
	const auto found = _plots.find(p_key);
	if (GrassField *field = found != _plots.end() ? field_of(found->second) : nullptr) {
		if (field->get_map().is_null()) { // a script took it
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
	statistics.fields_made = _fields.get_made();
	for (const auto &[key, plot] : _plots) {
		const GrassField *field = field_of(plot);
		(plot.state == State::STANDING ? statistics.plots : statistics.waiting)++;
		statistics.changed += field != nullptr && is_changed(plot, *field) ? 1 : 0;
	}
	statistics.spare = int64_t(_fields.count_spare());
	statistics.memory = int64_t(count_bytes());
	return statistics;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "world/world_plots.h"

#include "core/world/plot_map.h"
#include "shared/convert.h"
#include "shared/script_call.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Most plots that are read ahead of those that appear.
constexpr int MOST_READ = 2;
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
	_planner = {};
	_pool_tile.reset();
	_pool_wanted = 0;
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
		if (GrassField *field = field_of(plot)) {
			field->queue_free();
		}
	}
	_fields.stop();
	_plots.clear();
	_files.stop();
	_is_running = false;
}

// Runs a part of a frame in which scripts may run. Returns false if a script ended the world, freed it, or removed it from the tree; the
// frame ends then.
template <typename F> bool WorldPlots::run(F &&p_step) {
	return outlives(_fields.get_world(), p_step) && _is_running;
}

void WorldPlots::update(std::span<const WorldEye> p_eyes, std::span<const WorldMover> p_movers, double p_delta) {
	const int64_t moves = _statistics.brought + _statistics.left;
	take_read();
	if (!run([&] { show_coming(); })) {
		return;
	}
	measure();
	make_plan(p_eyes, p_movers, p_delta);
	fit_pools();
	if (!run([&] { leave_one(); }) || !run([&] { bring_one(); })) {
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
	std::erase_if(_plots, [this](const auto &p_entry) { // a script may have freed its field
		return p_entry.second.field != 0 && field_of(p_entry.second) == nullptr;
	});
}

bool WorldPlots::is_coming() const {
	return std::ranges::any_of(_plots, [](const auto &p_entry) { return p_entry.second.state == State::COMING; });
}

void WorldPlots::show_coming() {
	for (auto &[key, plot] : _plots) {
		GrassField *field = field_of(plot);
		if (plot.state != State::COMING || field == nullptr || !field->is_made()) {
			continue;
		}
		const PlotKey shown = key;
		const uint64_t id = plot.field;
		plot.state = State::STANDING;
		_statistics.most_build_ms = std::max(_statistics.most_build_ms, field->get_build_ms());
		if (run([&] { field->set_visible(true); }) && field_with(id) != nullptr) { // a script may be notified
			_tell("plot_loaded", shown, field);
		}
		return; // a listener may have changed everything
	}
}

// Brings the nearest of the plots that are read.
void WorldPlots::bring_one() {
	if (is_coming()) {
		return;
	}
	for (const PlotKey &key : _plan.wanted) {
		const auto found = _plots.find(key);
		if (found != _plots.end() && found->second.state == State::READ) {
			_fields.forget_freed();
			const PlotPools pools = find_pools();
			const size_t bytes = count_bytes() + _planner.expected(key);
			const auto fits = [&](int64_t p_pool) { return bytes + size_t(p_pool) * pools.tile_bytes <= _settings.budget; };
			if (_fields.count_spare() > 0 || is_under_eyes(key) || fits(pools.quiet)) {
				bring(key, fits(pool_for(key)) ? pool_for(key) : pools.quiet);
			}
			return;
		}
	}
}

void WorldPlots::bring(PlotKey p_key, int64_t p_pool) {
	GrassField *field = nullptr;
	if (!run([&] { field = _fields.take(); }) || field == nullptr) {
		return;
	}
	const auto found = _plots.find(p_key);
	if (found == _plots.end() || found->second.state != State::READ) { // a script of the field restarted the world
		field->queue_free();
		return;
	}
	Plot &plot = found->second;
	const Eigen::Vector2d centre = _settings.grid.centre(p_key);
	field->set_position(Vector3(real_t(centre.x()), 0, real_t(centre.y())));
	field->set_noise_origin(Vector2i(int32_t(centre.x()), int32_t(centre.y()))); // whole, since plots consist of whole chunks
	if (field->get_pool_tiles() != p_pool) {
		field->set_pool_tiles(p_pool);
	}
	Ref<GrassMapSnapshot> snapshot;
	snapshot.instantiate();
	snapshot->map = plot.known;
	Ref<GrassMap> map;
	map.instantiate();
	map->restore_snapshot(snapshot);
	field->show_map(map, std::move(plot.prepared));
	plot.field = field->get_instance_id();
	plot.state = State::COMING;
	_statistics.brought++;
}

// A plot that was read and is no longer wanted is only forgotten.
void WorldPlots::leave_one() {
	const std::vector<PlotKey> leaving = _plan.leaving; // listeners may restart the world
	const bool is_all_here = std::ranges::all_of(_plan.wanted, [this](const PlotKey &p_key) { return find(p_key) != nullptr; });
	for (const PlotKey &key : leaving) {
		const Plot &plot = _plots.at(key);
		if (plot.field == 0) {
			_plots.erase(key);
		} else if (plot.state == State::STANDING &&
				(_fields.count_spare() < WorldFields::MOST_SPARE || is_all_here || count_bytes() + _pool_wanted > _settings.budget)) {
			leave(key, plot);
			return;
		}
	}
	if (_plan.leaving.empty() && _fields.count_spare() > 0 && count_bytes() + _pool_wanted > _settings.budget) {
		_fields.free_spare();
	}
}

void WorldPlots::leave(PlotKey p_key, const Plot &p_plot) {
	GrassField *field = field_of(p_plot);
	if (!run([&] { _tell("plot_leaving", p_key, field); })) {
		return;
	}
	const auto found = _plots.find(p_key);
	if (found == _plots.end() || found->second.state != State::STANDING || field_of(found->second) != field) { // a listener has freed it
		return;
	}
	if (is_changed(found->second, *field)) {
		_files.write(p_key, kept_of(field->get_map()->get_map(), _fields.get_pattern().has_terrain));
	}
	_plots.erase(found);
	_statistics.left++;
	const bool has_room = count_bytes() + _pool_wanted <= _settings.budget;
	_fields.give_back(field, has_room && field->get_pool_tiles() <= find_pools().quiet); // a large pool is needed elsewhere
}

bool WorldPlots::is_changed(const Plot &p_plot, const GrassField &p_field) const {
	const Ref<GrassMap> map = p_field.get_map();
	return map.is_valid() && map->is_readable() &&
			!is_same(kept_of(map->get_map(), _fields.get_pattern().has_terrain), kept_of(p_plot.known, _fields.get_pattern().has_terrain));
}

// Requests the nearest wanted plot that is not requested yet.
void WorldPlots::ask() {
	const std::optional<MapPlace> &place = _fields.find_place();
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

uint32_t WorldPlots::find_layers() const {
	uint32_t layers = _fields.get_pattern().layers;
	for (const auto &[key, plot] : _plots) {
		const GrassField *field = field_of(plot); // null: it is still being read
		layers |= field != nullptr ? field->get_layer_mask() : 0u;
	}
	return layers;
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

// A plot that is being read is read again, since the earlier request returns its old state.
void WorldPlots::restore(const PlotKey &p_key, const PaintMap &p_from, const PaintMap &p_to) {
	const bool has_terrain = _fields.get_pattern().has_terrain;
	const auto change = [from = kept_of(p_from, has_terrain), to = kept_of(p_to, has_terrain)](
								PaintMap &r_map) { put_back(r_map, from, to); };
	const auto found = _plots.find(p_key);
	if (GrassField *field = found != _plots.end() ? field_of(found->second) : nullptr) {
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

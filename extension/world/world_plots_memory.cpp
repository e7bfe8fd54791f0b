// SPDX-License-Identifier: MIT
// The memory that the plots of a world use, what the budget holds, and the sizes of their pools.
#include "world/world_plots.h"

#include "resources/grass_quality.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// The pool of a plot in which nothing moves: enough for a blast. More: more memory in every plot.
constexpr int64_t QUIET_POOL = 32;
// Lead time: a pool is made larger this many seconds and frames before anything that moves arrives, since a field is made in parts. More:
// pools where nothing arrives. Less: grass stays upright behind fast bodies.
constexpr double LEAD = 2.0; // seconds
constexpr double LEAD_FRAMES = 40.0;
// Weight of one frame in the mean of the last frames.
constexpr double FRAME_WEIGHT = 0.05;

// All of p_memory is of one field, but its parts may be of two moments, since the device reports late.
size_t rest_of(const FieldMemory &p_memory) {
	return p_memory.all > 0 ? size_t(std::max<int64_t>(p_memory.all - p_memory.shared - p_memory.pool, 1)) : 0;
}

size_t pool_of(const FieldMemory &p_memory, int64_t p_tiles) {
	return size_t(std::max(p_memory.pool, p_memory.pool_tile * p_tiles)); // the larger size, for a pool that is still being made
}

} // namespace

// Measures one plot in each frame, in turn, and those that have just appeared.
void WorldPlots::measure() {
	auto next = _plots.upper_bound(_measured);
	if (next == _plots.end()) {
		next = _plots.begin();
	}
	if (next == _plots.end()) {
		return;
	}
	for (auto &[key, plot] : _plots) {
		const GrassField *field = plot.state == State::STANDING ? field_of(plot) : nullptr;
		if (field != nullptr && (plot.memory.all == 0 || key == next->first)) {
			plot.memory = field->find_memory();
			_pool_tile = plot.memory.pool_tile;
			_least_pool = std::min(_least_pool.value_or(plot.memory.pool), plot.memory.pool);
		}
	}
	_measured = next->first;
}

std::vector<LoadedPlot> WorldPlots::find_loaded() const {
	std::vector<LoadedPlot> loaded;
	for (const auto &[key, plot] : _plots) {
		const GrassField *field = field_of(plot);
		const int64_t tiles = field != nullptr ? field->get_pool_tiles() : 0;
		const size_t unmeasured = size_t(tiles) * size_t(_pool_tile.value_or(0)); // or measured before its pool was made larger
		loaded.push_back({ key, rest_of(plot.memory), std::max(pool_of(plot.memory, tiles), unmeasured), tiles });
	}
	return loaded;
}

PlotPools WorldPlots::find_pools() const {
	const int64_t full = current_quality().scale_pool(_fields.get_pattern().pool_tiles), quiet = std::min(full, QUIET_POOL);
	return { quiet, _pool_tile ? full : quiet, size_t(_pool_tile.value_or(0)), size_t(_least_pool.value_or(0)) };
}

void WorldPlots::make_plan(std::span<const WorldEye> p_eyes, std::span<const WorldMover> p_movers, double p_delta) {
	_frame_seconds += FRAME_WEIGHT * (p_delta - _frame_seconds);
	const BusyPlots busy = find_busy(_settings.grid, p_movers, std::max(LEAD, LEAD_FRAMES * _frame_seconds));
	const std::vector<LoadedPlot> loaded = find_loaded();
	_planner.learn(loaded);
	const PlotPools pools = find_pools();
	const size_t shared = count_shared();
	// The size of a plot is held back for the field that appears while another one leaves.
	const size_t held_back = _planner.get_typical() + pools.quiet_bytes();
	_plan = _planner.plan(
			_settings.grid, { p_eyes, busy.plots, loaded, pools, _settings.budget - std::min(_settings.budget, shared), held_back });
	_statistics.tests = busy.tests + _plan.tests;
}

bool WorldPlots::is_under_eyes(const PlotKey &p_key) const {
	const auto end = _plan.wanted.begin() + std::ptrdiff_t(_plan.under_eyes);
	return std::find(_plan.wanted.begin(), end, p_key) != end;
}

int64_t WorldPlots::pool_for(const PlotKey &p_key) const {
	const auto found = _plan.pools.find(p_key);
	return found != _plan.pools.end() ? found->second : find_pools().quiet;
}

// Changes one field at a time: gives it a larger pool once the plots have left that the budget does not hold beside it. Takes from a pool
// only while its grass is at rest, unless the level of quality has fallen.
void WorldPlots::fit_pools() {
	_pool_wanted = 0;
	const PlotPools pools = find_pools();
	for (auto &[key, plot] : _plots) {
		GrassField *field = plot.state == State::STANDING ? field_of(plot) : nullptr;
		if (field == nullptr || !field->is_inside_tree()) {
			continue;
		}
		if (!field->is_made()) {
			return;
		}
		const int64_t has = field->get_pool_tiles(), pool = pool_for(key);
		const bool may_shrink = has > pools.busy || field->get_awake_tile_count() == 0;
		if (pool == has || (pool < has && !may_shrink)) {
			continue;
		}
		const size_t more = pool > has ? size_t(pool - has) * pools.tile_bytes : 0;
		if (more > 0 && !_plan.leaving.empty() && count_bytes() + more > _settings.budget) {
			_pool_wanted = more;
			continue;
		}
		field->fit_pool(pool);
		return;
	}
}

size_t WorldPlots::count_shared() const {
	std::map<const void *, size_t> patches;
	for (const auto &[key, plot] : _plots) {
		if (plot.memory.patch != nullptr) {
			patches[plot.memory.patch] = size_t(std::max<int64_t>(plot.memory.shared, 0));
		}
	}
	size_t bytes = 0;
	for (const auto &[patch, shared] : patches) {
		bytes += shared;
	}
	return bytes;
}

size_t WorldPlots::count_bytes() const {
	const PlotPools pools = find_pools();
	size_t bytes = count_shared() + _fields.count_spare() * (_planner.get_typical() + pools.quiet_bytes());
	for (const auto &[key, plot] : _plots) {
		if (const GrassField *field = field_of(plot)) {
			bytes += plot.memory.all > 0
					? rest_of(plot.memory) + pool_of(plot.memory, field->get_pool_tiles())
					: _planner.expected(key) + std::max(size_t(field->get_pool_tiles()) * pools.tile_bytes, pools.least_bytes);
		} else if (plot.prepared) {
			bytes += plot.prepared->get_layers().get_memory_usage();
		}
	}
	return bytes;
}

size_t WorldPlots::count_used() const {
	size_t bytes = 0;
	std::map<const void *, size_t> patches;
	const auto add = [&](const GrassField *p_field) {
		if (p_field != nullptr) {
			const FieldMemory memory = p_field->find_memory();
			bytes += size_t(std::max<int64_t>(memory.all - memory.shared, 0));
			patches[memory.patch] = size_t(memory.shared);
		}
	};
	for (const auto &[key, plot] : _plots) {
		add(field_of(plot));
		bytes += plot.prepared ? plot.prepared->get_layers().get_memory_usage() : 0;
	}
	for (const uint64_t id : _fields.get_spare()) {
		add(field_with(id));
	}
	for (const auto &[patch, shared] : patches) {
		bytes += shared;
	}
	return bytes;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "world/plot_memory.h"

#include "resources/grass_quality.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Slots that a plot may always have, however small the budget is: enough for a few bodies. More: more memory than the budget allows.
constexpr int64_t LEAST_POOL = 32;
// Slots that the budget keeps free, since pools grow at once, and other plots leave one in a frame. Fewer: it is exceeded while bodies
// cross a border.
constexpr int64_t SPARE_SLOTS = 128;

// Returns the memory without the pool. All of p_memory is of one field, but its parts may be of two moments, since the device reports late.
size_t rest_of(const FieldMemory &p_memory) {
	return p_memory.all > 0 ? size_t(std::max<int64_t>(p_memory.all - p_memory.shared - p_memory.pool, 1)) : 0;
}

} // namespace

void PlotMemory::start(size_t p_budget) {
	_budget = p_budget;
	_planner = {};
	_pool_tile = 0;
}

void PlotMemory::measure() {
	auto next = _plots.upper_bound(_measured);
	if (next == _plots.end()) {
		next = _plots.begin();
	}
	if (next == _plots.end()) {
		return;
	}
	for (auto &[key, plot] : _plots) {
		const GrassField *field = plot.state == Plot::State::STANDING ? plot.get_field() : nullptr;
		if (field != nullptr && (plot.memory.all == 0 || key == next->first)) {
			plot.memory = field->get_report().find_memory();
			_pool_tile = plot.memory.pool_tile;
		}
	}
	_measured = next->first;
}

// Slots may exist that were made since the field was measured.
size_t PlotMemory::count_pool(const GrassField &p_field, const FieldMemory &p_measured) const {
	return size_t(std::max(p_measured.pool, p_field.get_pool_slots() * _pool_tile));
}

std::vector<LoadedPlot> PlotMemory::find_loaded() const {
	std::vector<LoadedPlot> loaded;
	for (const auto &[key, plot] : _plots) {
		const GrassField *field = plot.get_field();
		loaded.push_back({ key, rest_of(plot.memory), field != nullptr ? count_pool(*field, plot.memory) : 0 });
	}
	return loaded;
}

void PlotMemory::make_plan(const WorldGrid &p_grid, std::span<const WorldEye> p_eyes) {
	const std::vector<LoadedPlot> loaded = find_loaded();
	_planner.learn(loaded);
	const size_t shared = count_shared();
	// The size of a plot is held back for the field that appears while another one leaves.
	const size_t held_back = _planner.get_typical() + size_t(SPARE_SLOTS * _pool_tile);
	_plan = _planner.plan(p_grid, { p_eyes, loaded, _budget - std::min(_budget, shared), held_back });
}

bool PlotMemory::has_room_for(const PlotKey &p_key) const {
	const auto end = _plan.wanted.begin() + std::ptrdiff_t(_plan.under_eyes);
	const bool is_under_eyes = std::find(_plan.wanted.begin(), end, p_key) != end;
	return _fields.count_spare() > 0 || is_under_eyes || count_bytes() + _planner.expected(p_key) <= _budget;
}

int64_t PlotMemory::find_most_slots() const {
	return current_quality().scale_pool(_fields.get_pattern().pool_tiles);
}

// Lets each pool grow by half of what the budget has left beside the plots under the eyes and all pools, so that two may grow at once.
void PlotMemory::limit_pools() {
	size_t needed = count_shared();
	for (const PlotKey &key : std::span(_plan.wanted).first(_plan.under_eyes)) {
		needed += _planner.expected(key);
	}
	for (const auto &[key, plot] : _plots) {
		const GrassField *field = plot.get_field();
		needed += field != nullptr ? count_pool(*field, plot.memory) : 0;
	}
	const size_t left = _budget - std::min(_budget, needed);
	const int64_t more = _pool_tile > 0 ? int64_t(left / 2) / _pool_tile : 0, most = find_most_slots();
	for (const auto &[key, plot] : _plots) {
		GrassField *field = plot.state == Plot::State::STANDING ? plot.get_field() : nullptr;
		if (field != nullptr && field->is_inside_tree()) {
			field->get_parts().settings.fit_pool(std::min(std::max(field->get_pool_slots() + more, LEAST_POOL), most));
		}
	}
}

size_t PlotMemory::count_shared() const {
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

size_t PlotMemory::count_bytes() const {
	size_t bytes = count_shared() + _fields.count_spare() * _planner.get_typical();
	for (const auto &[key, plot] : _plots) {
		if (const GrassField *field = plot.get_field()) {
			bytes += (plot.memory.all > 0 ? rest_of(plot.memory) : _planner.expected(key)) + count_pool(*field, plot.memory);
		} else if (plot.prepared) {
			bytes += plot.prepared->get_layers().get_memory_usage();
		}
	}
	return bytes;
}

size_t PlotMemory::count_used() const {
	size_t bytes = 0;
	std::map<const void *, size_t> patches;
	const auto add = [&](const GrassField *p_field) {
		if (p_field != nullptr) {
			const FieldMemory memory = p_field->get_report().find_memory();
			bytes += size_t(std::max<int64_t>(memory.all - memory.shared, 0));
			patches[memory.patch] = size_t(memory.shared);
		}
	};
	for (const auto &[key, plot] : _plots) {
		add(plot.get_field());
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

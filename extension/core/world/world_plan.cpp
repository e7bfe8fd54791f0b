// SPDX-License-Identifier: MIT
#include "core/world/world_plan.h"

#include <unordered_set>

namespace grass {

namespace {

constexpr double FAR = std::numeric_limits<double>::infinity();

// A plot and its distance to the nearest eye, metres.
struct Candidate {
	double rank;
	PlotKey key;
	auto operator<=>(const Candidate &) const = default;
};

size_t minus(size_t p_from, size_t p_amount) {
	return p_from - std::min(p_from, p_amount);
}

// A plan that is being made.
class Draft {
public:
	Draft(const WorldPlanner &p_planner, const WorldGrid &p_grid, const WorldNeeds &p_needs) :
			_planner(p_planner), _grid(p_grid), _needs(p_needs), _groups(group_eyes(p_grid, p_needs.eyes)) {
		for (const LoadedPlot &plot : p_needs.loaded) {
			_loaded[plot.key] = &plot;
		}
	}

	WorldPlan make() {
		hold_under_eyes();
		hold_around();
		const std::vector<Candidate> lingering = find_lingering();
		for (const Candidate &candidate : lingering) {
			if (!_is_full && !_held.contains(candidate.key) && fits(candidate.key)) {
				hold(candidate.key);
			}
		}
		find_leaving();
		return std::move(_plan);
	}

private:
	const LoadedPlot *loaded(const PlotKey &p_key) const {
		const auto found = _loaded.find(p_key);
		return found != _loaded.end() ? found->second : nullptr;
	}
	// Returns the bytes of a plot with the pool that it has now.
	size_t cost(const PlotKey &p_key) const {
		const LoadedPlot *plot = loaded(p_key);
		return _planner.expected(p_key) + (plot != nullptr ? plot->pool : 0);
	}
	// Returns the bytes that are left. Plots under the eyes are not limited by this.
	size_t left() const { return minus(_needs.budget, _bytes + _needs.held_back); }
	bool fits(const PlotKey &p_key) const { return cost(p_key) <= left(); }
	void hold(const PlotKey &p_key) {
		_held.insert(p_key);
		_bytes += cost(p_key);
	}

	void hold_under_eyes();
	void hold_around();
	void hold_near(std::vector<Candidate> &r_ring);
	void add_ring(const EyeGroup &p_group, int p_ring);
	std::vector<Candidate> find_lingering();
	void find_leaving();

	const WorldPlanner &_planner;
	const WorldGrid &_grid;
	const WorldNeeds &_needs;
	std::vector<EyeGroup> _groups;
	std::unordered_map<PlotKey, const LoadedPlot *, PlotHash> _loaded;
	std::unordered_map<PlotKey, double, PlotHash> _near; // metres to the nearest eye, of loaded plots that are wanted or may linger
	std::unordered_map<PlotKey, double, PlotHash> _open; // the same for plots that are wanted and not judged yet
	std::unordered_set<PlotKey, PlotHash> _held, _judged;
	size_t _bytes = 0; // of all plots held
	bool _is_full = false; // no more plots are accepted
	WorldPlan _plan;
};

// Holds the plots under the eyes whatever the budget is, since grass must not be missing where somebody is.
void Draft::hold_under_eyes() {
	for (const EyeGroup &group : _groups) {
		if (_grid.has(group.plot) && _judged.insert(group.plot).second) {
			hold(group.plot);
			_plan.wanted.push_back(group.plot);
		}
	}
	_plan.under_eyes = _plan.wanted.size();
	_plan.missing = minus(_bytes, _needs.budget);
	_plan.is_short = _is_full = _plan.missing > 0;
	_plan.reach = _plan.is_short ? 0.0 : _plan.reach;
}

// Visits plots in rings around the eyes' own plots, only as many as the budget holds.
void Draft::hold_around() {
	int rings = 0;
	for (const EyeGroup &group : _groups) {
		rings = std::max(rings, int(group.radius / _grid.get_plot_size()) + 1);
	}
	std::vector<Candidate> ring;
	for (int n = 0; n <= rings && !_is_full; n++) {
		for (const EyeGroup &group : _groups) {
			add_ring(group, n);
		}
		const double known = n < rings ? n * _grid.get_plot_size() : FAR; // no plot of the next ring is nearer
		ring.clear();
		std::erase_if(_open, [&](const auto &p_entry) {
			const bool is_near = p_entry.second < known;
			if (is_near) {
				ring.push_back({ p_entry.second, p_entry.first });
			}
			return is_near;
		});
		hold_near(ring);
	}
}

void Draft::add_ring(const EyeGroup &p_group, int p_ring) {
	const Eigen::Vector2d reach = Eigen::Vector2d::Constant(p_group.radius);
	const PlotKey first = _grid.at(p_group.min - reach), last = _grid.at(p_group.max + reach);
	const auto add = [&](int p_x, int p_z) {
		const PlotKey key{ p_x, p_z };
		if (!_grid.has(key) || _judged.contains(key)) {
			return;
		}
		_plan.tests++;
		if (const double distance = p_group.distance(_grid, key); distance <= p_group.radius) {
			const auto [found, is_new] = _open.try_emplace(key, distance);
			found->second = std::min(found->second, distance);
		}
	};
	const int low_x = std::max(first.x, p_group.plot.x - p_ring), high_x = std::min(last.x, p_group.plot.x + p_ring),
			  low_z = std::max(first.z, p_group.plot.z - p_ring), high_z = std::min(last.z, p_group.plot.z + p_ring);
	for (int z = low_z; z <= high_z; z++) {
		const bool is_whole = std::abs(z - p_group.plot.z) == p_ring; // otherwise the ring has two plots in this row
		for (int x = low_x; x <= high_x; x++) {
			if (!is_whole && x > p_group.plot.x - p_ring && x < p_group.plot.x + p_ring) {
				x = p_group.plot.x + p_ring - 1;
				continue;
			}
			add(x, z);
		}
	}
}

// Stops at the first plot that does not fit: otherwise a small distant plot would replace a large near one, and they would alternate. A
// plot larger than the whole budget is only skipped.
void Draft::hold_near(std::vector<Candidate> &r_ring) {
	std::ranges::sort(r_ring);
	for (const Candidate &candidate : r_ring) {
		_judged.insert(candidate.key);
		if (!fits(candidate.key)) {
			_plan.is_short = true;
			_plan.reach = std::min(_plan.reach, candidate.rank);
			_is_full = cost(candidate.key) <= _needs.budget;
			if (_is_full) {
				return;
			}
			continue;
		}
		hold(candidate.key);
		_plan.wanted.push_back(candidate.key);
	}
}

// Returns the loaded plots within LINGER of what an eye wants, nearest first, including those that are wanted.
std::vector<Candidate> Draft::find_lingering() {
	const auto look = [this](const EyeGroup &p_group, const PlotKey &p_key) {
		_plan.tests++;
		const double distance = p_group.distance(_grid, p_key);
		if (distance <= p_group.radius + WorldPlanner::LINGER) {
			const auto [found, is_new] = _near.try_emplace(p_key, distance);
			found->second = std::min(found->second, distance);
		}
	};
	for (const EyeGroup &group : _groups) {
		const Eigen::Vector2d reach = Eigen::Vector2d::Constant(group.radius + WorldPlanner::LINGER);
		const PlotKey first = _grid.at(group.min - reach), last = _grid.at(group.max + reach);
		if ((int64_t(last.x) - first.x + 1) * (int64_t(last.z) - first.z + 1) > int64_t(_loaded.size())) {
			for (const auto &[key, plot] : _loaded) {
				look(group, key);
			}
			continue;
		}
		for (int z = first.z; z <= last.z; z++) {
			for (int x = first.x; x <= last.x; x++) {
				if (_loaded.contains({ x, z })) {
					look(group, { x, z });
				}
			}
		}
	}
	std::vector<Candidate> near;
	for (const auto &[key, distance] : _near) {
		if (_grid.has(key)) {
			near.push_back({ distance, key });
		}
	}
	std::ranges::sort(near);
	return near;
}

void Draft::find_leaving() {
	std::vector<Candidate> leaving;
	for (const LoadedPlot &plot : _needs.loaded) {
		if (!_held.contains(plot.key)) {
			const auto near = _near.find(plot.key);
			leaving.push_back({ near != _near.end() ? near->second : FAR, plot.key });
		}
	}
	std::ranges::sort(leaving);
	for (auto candidate = leaving.rbegin(); candidate != leaving.rend(); ++candidate) {
		_plan.leaving.push_back(candidate->key);
	}
}

} // namespace

void WorldPlanner::learn(std::span<const LoadedPlot> p_loaded) {
	std::vector<size_t> known;
	for (const LoadedPlot &plot : p_loaded) {
		if (plot.rest > 0) {
			_rest[plot.key] = plot.rest;
			known.push_back(plot.rest);
		}
	}
	if (!known.empty()) {
		const auto middle = known.begin() + std::ptrdiff_t(known.size() / 2);
		std::ranges::nth_element(known, middle);
		_typical = *middle;
	}
}

size_t WorldPlanner::expected(const PlotKey &p_key) const {
	const auto found = _rest.find(p_key);
	return found != _rest.end() ? found->second : _typical;
}

WorldPlan WorldPlanner::plan(const WorldGrid &p_grid, const WorldNeeds &p_needs) const {
	return Draft(*this, p_grid, p_needs).make();
}

} // namespace grass

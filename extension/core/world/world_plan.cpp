// SPDX-License-Identifier: MIT
#include "core/world/world_plan.h"

#include <set>

namespace grass {

namespace {

// A plot that an eye wants, or that may linger.
struct Candidate {
	double rank; // metres from the nearest eye; those that linger come after all that are wanted
	PlotKey key;
	bool is_wanted;
	auto operator<=>(const Candidate &) const = default;
};

// How far p_key is from the eye that wants it most. INF: nobody wants it, nor lets it linger.
Candidate judge(const WorldGrid &p_grid, std::span<const WorldEye> p_eyes, const PlotKey &p_key) {
	constexpr double FAR = std::numeric_limits<double>::infinity();
	double wanted = FAR, lingering = FAR;
	for (const WorldEye &eye : p_eyes) {
		const double distance = p_grid.distance(p_key, eye.place);
		if (distance <= eye.radius) {
			wanted = std::min(wanted, distance);
		} else if (distance <= eye.radius + WorldPlanner::LINGER) {
			lingering = std::min(lingering, distance);
		}
	}
	constexpr double AFTER = 1e9; // metres: behind whatever is wanted
	return wanted < FAR ? Candidate{ wanted, p_key, true } : Candidate{ AFTER + lingering, p_key, false };
}

std::set<PlotKey> keys_around(const WorldGrid &p_grid, std::span<const WorldEye> p_eyes) {
	std::set<PlotKey> keys;
	for (const WorldEye &eye : p_eyes) {
		if (!eye.place.allFinite()) {
			continue;
		}
		const Eigen::Vector2d reach = Eigen::Vector2d::Constant(eye.radius);
		const PlotKey from = p_grid.at(eye.place - reach), to = p_grid.at(eye.place + reach);
		for (int z = from.z; z <= to.z; z++) {
			for (int x = from.x; x <= to.x; x++) {
				if (p_grid.has({ x, z }) && p_grid.distance({ x, z }, eye.place) <= eye.radius) {
					keys.insert({ x, z });
				}
			}
		}
	}
	return keys;
}

} // namespace

void WorldPlanner::learn(const PlotKey &p_key, size_t p_bytes) {
	_bytes[p_key] = p_bytes;
	_most = std::max(_most, p_bytes);
}

size_t WorldPlanner::expected(const PlotKey &p_key) const {
	const auto found = _bytes.find(p_key);
	return found != _bytes.end() ? found->second : _most;
}

void WorldPlanner::forget() {
	*this = WorldPlanner();
}

WorldPlan WorldPlanner::plan(
		const WorldGrid &p_grid, std::span<const WorldEye> p_eyes, std::span<const PlotKey> p_loaded, size_t p_budget) const {
	std::set<PlotKey> keys = keys_around(p_grid, p_eyes);
	std::set<PlotKey> leaving;
	for (const PlotKey &key : p_loaded) {
		keys.insert(key);
		leaving.insert(key);
	}
	std::set<Candidate> candidates;
	for (const PlotKey &key : keys) {
		candidates.insert(judge(p_grid, p_eyes, key));
	}
	WorldPlan plan;
	size_t bytes = 0;
	for (const Candidate &candidate : candidates) {
		const size_t more = expected(candidate.key);
		const bool fits = p_grid.has(candidate.key) && std::isfinite(candidate.rank) && bytes + more <= p_budget;
		if (candidate.is_wanted && !fits) {
			plan.is_short = true;
			plan.reach = std::min(plan.reach, candidate.rank);
		}
		// Behind one that does not fit nothing comes: else a small far plot would stand in the place of a large near one, by turns.
		if (fits && !plan.is_short) {
			bytes += more;
			leaving.erase(candidate.key);
			if (candidate.is_wanted) {
				plan.wanted.push_back(candidate.key);
			}
		}
	}
	for (auto candidate = candidates.rbegin(); candidate != candidates.rend(); ++candidate) {
		if (leaving.contains(candidate->key)) {
			plan.leaving.push_back(candidate->key);
		}
	}
	return plan;
}

} // namespace grass

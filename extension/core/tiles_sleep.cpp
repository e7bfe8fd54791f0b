// SPDX-License-Identifier: MIT
// How TileManager puts tiles to sleep: by a timer as in section 5.2 of Fan et al. 2015, or by energy, their future work.
#include "core/tiles.h"

#include <cmath>

namespace grass {

namespace {

// Seconds for which blades must be calm.
constexpr double CALM_TIME = 0.5;
// A tile is no longer calm above this multiple of the energy up to which it becomes so: twice the motion.
constexpr float CALM_ENDS = 4.0f;
// Seconds on the way to rest of a tile that is calm, at most: nothing is to be seen on it.
constexpr double CALM_SETTLE_TIME = 0.1;
// Seconds after the last touch at which a tile settles that never calmed down. Very soft blades swing this long.
constexpr double LONGEST_AWAKE = 10.0;

} // namespace

void TileManager::report_energy(const EnergyReport &p_report) {
	for (const int slot : _used) {
		if (size_t(slot) >= p_report.energies.size()) {
			break;
		}
		Awake &awake = _awake[size_t(slot)];
		const float energy = p_report.energies[size_t(slot)];
		if (p_report.step >= awake.woken_step && size_t(slot) < p_report.bends.size() && p_report.bends[size_t(slot)].allFinite()) {
			awake.bend = p_report.bends[size_t(slot)];
		}
		if (p_report.step < awake.touched_step || !std::isfinite(energy)) {
			continue;
		}
		awake.energy = std::max(energy, 0.0f);
		if (awake.energy > CALM_ENDS * float(_params.sleep_energy)) {
			awake.calm_since = NEVER;
		} else if (awake.energy <= float(_params.sleep_energy)) {
			awake.calm_since = std::min(awake.calm_since, _time);
		}
	}
}

void TileManager::deactivate_tiles(double p_delta) {
	for (const int slot : _used) {
		Awake &awake = _awake[size_t(slot)];
		Mark &mark = _marks[size_t(slot)];
		if (mark.is_touched) {
			keep_awake(awake, mark.is_stirred);
		}
		const bool is_idle = !mark.is_stirred && _time - awake.stirred >= CALM_TIME; // no object has moved in it for a while
		mark.is_unseen = is_idle && !is_seen(awake);
		if (mark.is_touched) {
			continue;
		}
		awake.blend = (mark.is_unseen || _has_passed_unseen) && is_past(awake) ? 1.0f : awake.blend;
		if (awake.blend >= 1.0f) {
			retire(slot);
			_free.insert(slot);
		} else if (!mark.is_unseen && should_settle(awake)) {
			settle(awake, p_delta);
		}
	}
	_has_passed_unseen = false;
}

void TileManager::keep_awake(Awake &r_awake, bool p_is_stirred) const {
	r_awake.touched = _time;
	r_awake.stirred = p_is_stirred ? _time : r_awake.stirred;
	r_awake.touched_step = _step_number;
	r_awake.calm_since = NEVER;
	r_awake.energy = NO_ENERGY;
	r_awake.is_settling = false;
	r_awake.blend = 0.0f;
}

bool TileManager::is_calm(const Awake &p_awake) const {
	return _params.sleep_mode == SleepMode::ENERGY && p_awake.energy <= float(_params.sleep_energy) &&
			_time - p_awake.calm_since >= CALM_TIME;
}

// Would be at rest by now, for all that anybody can tell who did not see it.
bool TileManager::is_past(const Awake &p_awake) const {
	return p_awake.is_settling || is_calm(p_awake) || _time - p_awake.touched >= _params.sleep_delay + _params.settle_time;
}

bool TileManager::should_settle(const Awake &p_awake) const {
	if (p_awake.is_settling || is_calm(p_awake)) {
		return true;
	}
	double delay = _params.sleep_delay;
	if (_params.sleep_mode == SleepMode::ENERGY) { // the timer holds where nothing is reported
		delay = p_awake.energy == NO_ENERGY ? std::max(delay, CALM_TIME) : LONGEST_AWAKE;
	}
	return _time - p_awake.touched >= delay;
}

// Takes the share of what is left of the way that brings the tile to rest in time, at even pace.
void TileManager::settle(Awake &r_awake, double p_delta) const {
	if (!r_awake.is_settling) {
		r_awake.is_settling = true;
		r_awake.settle_left = is_calm(r_awake) ? std::min(_params.settle_time, CALM_SETTLE_TIME) : _params.settle_time;
	}
	// What rounding leaves of a step is no step of its own.
	const bool arrives = r_awake.settle_left <= p_delta * 1.0001;
	r_awake.blend = arrives ? 1.0f : float(p_delta / r_awake.settle_left);
	r_awake.settle_left -= p_delta;
}

// Announces that the slot's tile is at rest from now on. The slot is its caller's.
void TileManager::retire(int p_slot) {
	Awake &awake = _awake[size_t(p_slot)];
	(awake.blend >= 1.0f ? _statistics.slept : _statistics.evicted)++;
	_records.push_back({ awake.tile, { awake.start, 0, 0, GRASS_SLOT_RETIRED }, {} });
	_slot_of_tile.erase(awake.tile.z);
	_used.erase(p_slot);
	awake = {};
	_marks[size_t(p_slot)] = {};
}

} // namespace grass

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
	if (p_report.step == _reported_step) {
		return; // nothing new, and who was touched since then is not in it
	}
	_reported_step = p_report.step;
	if (!p_report.bends.empty()) {
		_bend_step = p_report.step;
		_bends.assign(p_report.bends.begin(), p_report.bends.end());
	}
	for (const int slot : _used) {
		if (size_t(slot) >= p_report.energies.size()) {
			break;
		}
		Awake &awake = _awake[size_t(slot)];
		const float energy = p_report.energies[size_t(slot)];
		const bool is_older = int32_t(uint32_t(p_report.step) - awake.touched_step) < 0;
		if (is_older || !std::isfinite(energy)) {
			continue;
		}
		awake.energy = energy > 0.0f ? energy : 0.0f; // and no zero with a sign
		if (awake.energy > CALM_ENDS * float(_params.sleep_energy)) {
			awake.calm_since = NEVER;
		} else if (awake.energy <= float(_params.sleep_energy)) {
			awake.calm_since = std::min(awake.calm_since, _time);
		}
	}
}

void TileManager::deactivate_tiles(double p_delta) {
	for (const int slot : _used) {
		Mark &mark = _marks[size_t(slot)];
		const bool is_touched = _touched.has(slot), is_stirred = _stirred.has(slot);
		if (is_touched) {
			keep_awake(slot, is_stirred);
		}
		// No object has moved in it for a while.
		const bool is_idle = !is_stirred && _time - _awake[size_t(slot)].stirred >= CALM_TIME;
		mark.is_unseen = is_idle && !is_seen(_places[size_t(slot)]);
		if (is_touched) {
			continue;
		}
		mark.blend = (mark.is_unseen || _has_passed_unseen) && is_past(slot) ? 1.0f : mark.blend;
		if (mark.blend >= 1.0f) {
			retire(slot);
			_free.insert(slot);
		} else if (!mark.is_unseen && should_settle(slot)) {
			settle(slot, p_delta);
		}
	}
	_has_passed_unseen = false;
}

void TileManager::keep_awake(int p_slot, bool p_is_stirred) {
	Mark &mark = _marks[size_t(p_slot)];
	_awake[size_t(p_slot)] = { _time, p_is_stirred ? _time : _awake[size_t(p_slot)].stirred, NEVER, NO_ENERGY, uint32_t(_step_number) };
	mark.is_settling = false;
	mark.blend = 0.0f;
}

bool TileManager::is_calm(const Awake &p_awake) const {
	return _params.sleep_mode == SleepMode::ENERGY && p_awake.energy <= float(_params.sleep_energy) &&
			_time - p_awake.calm_since >= CALM_TIME;
}

// Would be at rest by now, for all that anybody can tell who did not see it.
bool TileManager::is_past(int p_slot) const {
	const Awake &awake = _awake[size_t(p_slot)];
	return _marks[size_t(p_slot)].is_settling || is_calm(awake) || _time - awake.touched >= _params.sleep_delay + _params.settle_time;
}

bool TileManager::should_settle(int p_slot) const {
	const Awake &awake = _awake[size_t(p_slot)];
	if (_marks[size_t(p_slot)].is_settling || is_calm(awake)) {
		return true;
	}
	double delay = _params.sleep_delay;
	if (_params.sleep_mode == SleepMode::ENERGY) { // the timer holds where nothing is reported
		delay = awake.energy == NO_ENERGY ? std::max(delay, CALM_TIME) : LONGEST_AWAKE;
	}
	return _time - awake.touched >= delay;
}

// Takes the share of what is left of the way that brings the tile to rest in time, at even pace.
void TileManager::settle(int p_slot, double p_delta) {
	Mark &mark = _marks[size_t(p_slot)];
	double &left = _lives[size_t(p_slot)].settle_left;
	if (!mark.is_settling) {
		mark.is_settling = true;
		left = is_calm(_awake[size_t(p_slot)]) ? std::min(_params.settle_time, CALM_SETTLE_TIME) : _params.settle_time;
	}
	// What rounding leaves of a step is no step of its own.
	const bool arrives = left <= p_delta * 1.0001;
	mark.blend = arrives ? 1.0f : float(p_delta / left);
	left -= p_delta;
}

// Announces that the slot's tile is at rest from now on. The slot is its caller's.
void TileManager::retire(int p_slot) {
	Place &place = _places[size_t(p_slot)];
	(_marks[size_t(p_slot)].blend >= 1.0f ? _statistics.slept : _statistics.evicted)++;
	_records.push_back({ { place.x, place.z, place.tile, p_slot }, { place.start, 0, 0, GRASS_SLOT_RETIRED }, {} });
	_slot_of_tile.erase(place.x, place.z);
	_used.erase(p_slot);
	place = {};
	_awake[size_t(p_slot)] = {};
	_marks[size_t(p_slot)] = {};
}

} // namespace grass

// SPDX-License-Identifier: MIT
// How TileManager puts tiles to sleep: by a timer as in section 5.2 of Fan et al. 2015, or by energy, their future work.
#include "core/tiles/tiles.h"

#include <bit>
#include <cmath>

namespace grass {

namespace {

// Seconds for which blades must stay calm.
constexpr double CALM_TIME = 0.5;
// A calm tile stops being calm above this multiple of the energy at which it became calm: twice the motion.
constexpr float CALM_ENDS = 4.0f;
// The most seconds that a calm tile takes to settle, since its motion is invisible.
constexpr double CALM_SETTLE_TIME = 0.1;
// Seconds after the last meeting at which a tile that never calmed down settles. Very soft blades swing this long.
constexpr double LONGEST_AWAKE = 10.0;

// A collider counts as changed once it has moved by these steps: metres, and shares of a turn.
constexpr double PLACE_STEP = 1e-3, TURN_STEP = 5e-3;

uint64_t mix(uint64_t p_signature, uint64_t p_word) {
	const uint64_t product = (p_signature ^ p_word) * 0x9e3779b97f4a7c15u;
	return product ^ (product >> 32);
}

uint64_t sign_of(const ColliderShape &p_shape) {
	uint64_t signature = mix(p_shape.owner, uint64_t(p_shape.type) + (uint64_t(p_shape.planes.size()) << 8));
	const Eigen::Vector4d turn = p_shape.now.rotation.coeffs();
	for (int i = 0; i < 3; i++) {
		signature = mix(signature, std::bit_cast<uint64_t>(p_shape.size[i]));
		signature = mix(signature, uint64_t(std::llround(p_shape.now.position[i] / PLACE_STEP)));
		signature = mix(signature, uint64_t(std::llround(turn[i] / TURN_STEP)));
	}
	return p_shape.force == ColliderShape::NO_FORCE ? signature : mix(signature, p_shape.revision);
}

} // namespace

void TileManager::report_energy(const EnergyReport &p_report) {
	if (p_report.step == _reported_step || p_report.step < _moved_step) {
		return; // nothing new, and it does not know which tiles were met since
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
		Motion &motion = _motions[size_t(slot)];
		const float energy = p_report.energies[size_t(slot)];
		const bool is_older = int32_t(uint32_t(p_report.step) - motion.met_step) < 0;
		if (is_older || !std::isfinite(energy)) {
			continue;
		}
		motion.energy = energy > 0.0f ? energy : 0.0f; // removes a negative zero
		double &calm_since = _times[size_t(slot)].calm_since;
		if (motion.energy > CALM_ENDS * float(_params.sleep_energy)) {
			calm_since = NEVER;
		} else if (motion.energy <= float(_params.sleep_energy)) {
			calm_since = std::min(calm_since, _time);
		}
	}
}

// Computes a signature of which colliders are where, so coarse that trembling does not change it but creeping does. A tile is stirred if
// its signature differs from that of the last step.
void TileManager::sign_meetings(std::span<const ColliderShape> p_colliders) {
	std::swap(_signatures, _signatures_before);
	std::fill(_signatures.begin(), _signatures.end(), 0);
	uint32_t last = std::numeric_limits<uint32_t>::max();
	uint64_t sign = 0;
	_statistics.colliders = 0;
	for (TileMeetings::Meeting &meeting : _meetings.get()) { // ascending by collider
		meeting.slot = meeting.slot >= 0 ? meeting.slot : _given_slots[size_t(~meeting.slot)];
		if (meeting.collider != last) {
			last = meeting.collider;
			_statistics.colliders += p_colliders[last].force == ColliderShape::NO_FORCE;
			sign = sign_of(p_colliders[last]);
		}
		uint64_t &signature = _signatures[size_t(meeting.slot)];
		signature = mix(signature, sign);
	}
	for (const int slot : _met) {
		_stirred.insert_if(slot, _signatures[size_t(slot)] != _signatures_before[size_t(slot)]);
	}
}

// Handles the tiles that are met first, then the others: a branch between the two in one loop would be mispredicted.
void TileManager::deactivate_tiles(double p_delta) {
	_skipped.clear();
	_settling.take_difference(_settling, _met);
	_statistics.still = 0;
	for (const int slot : _met) {
		keep_awake(slot, _stirred.has(slot));
		const bool still = is_still(slot);
		_statistics.still += still;
		const bool is_skipped = still || (is_unstirred(slot) && !is_seen(slot));
		_skipped.insert_if(slot, is_skipped);
		_times[size_t(slot)].simulated += is_skipped ? 0.0 : p_delta;
	}
	_unmet.take_difference(_used, _met);
	for (const int slot : _unmet) {
		const bool is_unseen = is_unstirred(slot) && !is_seen(slot);
		if (blend_of(slot) >= 1.0f || ((is_unseen || _has_passed_unseen) && is_past(slot))) {
			retire(slot, true);
			_free.give_back(slot);
		} else if (is_unseen) {
			_skipped.insert(slot);
		} else if (should_settle(slot)) {
			settle(slot, p_delta);
		}
	}
	_has_passed_unseen = false;
}

void TileManager::keep_awake(int p_slot, bool p_is_stirred) {
	Times &times = _times[size_t(p_slot)];
	times = { _time, p_is_stirred ? _time : times.stirred, NEVER, p_is_stirred ? 0.0 : times.simulated };
	_motions[size_t(p_slot)] = { NO_ENERGY, uint32_t(_step_number) };
}

// Returns whether no collider has moved in the tile for a while.
bool TileManager::is_unstirred(int p_slot) const {
	return _time - _times[size_t(p_slot)].stirred >= CALM_TIME && !_stirred.has(p_slot);
}

// Returns whether the tile was simulated for so long since it was stirred that its blades have reached their final pose. Blades that two
// bodies crush would tremble for ever.
bool TileManager::is_still(int p_slot) const {
	return _params.sleep_mode == SleepMode::ENERGY && _times[size_t(p_slot)].simulated >= _params.still_delay;
}

bool TileManager::is_calm(int p_slot) const {
	return _params.sleep_mode == SleepMode::ENERGY && _motions[size_t(p_slot)].energy <= float(_params.sleep_energy) &&
			_time - _times[size_t(p_slot)].calm_since >= CALM_TIME;
}

// Returns whether the tile, while out of view, would have come to rest by now.
bool TileManager::is_past(int p_slot) const {
	return _settling.has(p_slot) || is_calm(p_slot) || _time - _times[size_t(p_slot)].met >= _params.sleep_delay + _params.settle_time;
}

bool TileManager::should_settle(int p_slot) const {
	if (_settling.has(p_slot) || is_calm(p_slot)) {
		return true;
	}
	double delay = _params.sleep_delay;
	if (_params.sleep_mode == SleepMode::ENERGY) { // the timer applies where nothing is reported
		delay = _motions[size_t(p_slot)].energy == NO_ENERGY ? std::max(delay, CALM_TIME) : LONGEST_AWAKE;
	}
	return _time - _times[size_t(p_slot)].met >= delay;
}

// Moves the tile by the share of the remaining way that brings it to rest in time, at an even pace.
void TileManager::settle(int p_slot, double p_delta) {
	Life &life = _lives[size_t(p_slot)];
	if (!_settling.has(p_slot)) {
		_settling.insert(p_slot);
		life.settle_left = is_calm(p_slot) ? std::min(_params.settle_time, CALM_SETTLE_TIME) : _params.settle_time;
	}
	// A remainder due to rounding is not a step of its own.
	const bool arrives = life.settle_left <= p_delta * 1.0001;
	life.blend = arrives ? 1.0f : float(p_delta / life.settle_left);
	life.settle_left -= p_delta;
}

void TileManager::stir(const TileRange &p_tiles) {
	if (p_tiles.count() == 0) {
		return;
	}
	_meetings.forget(); // their grass, or its height, has changed
	for (const int slot : _used) {
		const TileBounds::Tile tile = _places[size_t(slot)].tile;
		if (p_tiles.has(tile.x, tile.z)) {
			_stirred.insert(slot);
		}
	}
}

void TileManager::pass_unseen(double p_delta) {
	_time += std::isfinite(p_delta) ? std::max(p_delta, 0.0) : 0.0;
	_has_passed_unseen = true;
}

bool TileManager::is_seen(int p_slot) const {
	const TileBounds::Tile tile = _places[size_t(p_slot)].tile;
	return _view.sees(tile.x, tile.z);
}

// Records that the slot's tile is at rest from now on, and leaves the slot to the caller. p_is_at_rest: the tile was at rest before.
void TileManager::retire(int p_slot, bool p_is_at_rest) {
	const Place &place = _places[size_t(p_slot)];
	const int x = place.tile.x, z = place.tile.z;
	(p_is_at_rest ? _statistics.slept : _statistics.evicted)++;
	_records[_record_count++] = { { x, z, _grid.get_index(x, z), p_slot }, { place.start, 0, 0, GRASS_SLOT_RETIRED }, {}, {} };
	_slot_of_tile.erase(x, z);
	_used.erase(p_slot);
	_settling.erase(p_slot);
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "core/fill/live_fill.h"

#include <algorithm>

namespace grass {

LiveFill::Ground LiveFill::ground_of(const PaintMap &p_map, const MapKey &p_key) {
	const MapChunk *chunk = p_map.find(p_key);
	return chunk == nullptr ? Ground() : Ground{ chunk->channels[MAP_GROUND], chunk->channels[MAP_NORMAL], chunk->channels[MAP_LEDGE] };
}

void LiveFill::wait(const MapRegion &p_area) {
	for (const MapKey &key : chunks_in(_area.shared(p_area))) {
		_waiting.insert(key);
	}
}

void LiveFill::wait(const FillObstacle &p_obstacle) {
	if (!p_obstacle.is_nowhere()) {
		wait({ p_obstacle.get_min(), p_obstacle.get_max() });
	}
}

void LiveFill::touch_all() {
	if (!_rule.only_at_obstacles) {
		wait(_area);
		return;
	}
	for (const std::shared_ptr<const FillObstacle> &obstacle : _sources.obstacles) {
		wait(*obstacle);
	}
}

void LiveFill::set(const FillRule &p_rule, const FillSources &p_sources, const MapRegion &p_area) {
	const bool is_all_new = !_is_set || !(p_rule == _rule) || p_sources.has_mesh != _sources.has_mesh || p_sources.mesh != _sources.mesh ||
			!(p_area == _area) || (p_rule.asks_textures() && p_sources.terrain != _sources.terrain);
	FillSources before = std::move(_sources);
	_is_set = true;
	_rule = p_rule;
	_sources = p_sources;
	_area = p_area;
	if (is_all_new && !_rule.only_at_obstacles) {
		_waiting.clear();
		wait(_area);
		return;
	}
	if (is_all_new) {
		touch_all();
	}
	using Obstacles = std::set<std::shared_ptr<const FillObstacle>>;
	const Obstacles old(before.obstacles.begin(), before.obstacles.end()), now(_sources.obstacles.begin(), _sources.obstacles.end());
	std::vector<std::shared_ptr<const FillObstacle>> different;
	std::set_symmetric_difference(old.begin(), old.end(), now.begin(), now.end(), std::back_inserter(different));
	for (const std::shared_ptr<const FillObstacle> &obstacle : different) {
		wait(*obstacle);
	}
	if (_rule.only_at_obstacles) {
		_sources.gone = std::move(before.gone);
		std::ranges::copy_if(different, std::back_inserter(_sources.gone), [&old](const auto &p_one) { return old.contains(p_one); });
	}
}

void LiveFill::touch(const PaintMap &p_map, std::span<const MapKey> p_keys, bool p_replaced) {
	if (!_is_set) {
		return;
	}
	for (const MapKey &key : p_keys) {
		const MapRegion chunk = MapRegion::of_chunk(key);
		const auto filled = _filled_on.find(key);
		if (asks_ground() && filled != _filled_on.end() && filled->second != ground_of(p_map, key)) {
			wait(chunk.grown(info_of(MAP_GROUND).texel_size())); // its border blends into the neighbouring chunks
		} else if (p_replaced) {
			wait(chunk);
		}
	}
}

void LiveFill::touch_textures(const MapRegion &p_region) {
	if (_is_set && _rule.asks_textures()) {
		wait(p_region);
	}
}

FillResult LiveFill::work(PaintMap &r_map, int p_count, const ParallelFor &p_parallel_for) {
	std::vector<MapKey> keys(_waiting.begin(), _waiting.end());
	if (p_count >= 0 && keys.size() > size_t(p_count)) {
		keys.resize(size_t(p_count));
	}
	for (const MapKey &key : keys) {
		_waiting.erase(key);
		_filled_on[key] = ground_of(r_map, key);
	}
	FillResult result = fill(r_map, keys, _area, &_rule, _sources, p_parallel_for, FillRim::FILLED);
	std::erase_if(_sources.gone, [this](const auto &p_obstacle) { return !is_waiting(*p_obstacle); });
	return result;
}

bool LiveFill::is_waiting(const FillObstacle &p_obstacle) const {
	return std::ranges::any_of(_waiting, [&p_obstacle](const MapKey &p_key) {
		const MapRegion chunk = MapRegion::of_chunk(p_key);
		return p_obstacle.reaches(chunk.min, chunk.max);
	});
}

FillResult LiveFill::remove(PaintMap &r_map, const ParallelFor &p_parallel_for) {
	FillResult result;
	if (_is_set) {
		result = fill(r_map, chunks_in(_area), _area, nullptr, {}, p_parallel_for, FillRim::FILLED);
	}
	*this = LiveFill();
	return result;
}

} // namespace grass

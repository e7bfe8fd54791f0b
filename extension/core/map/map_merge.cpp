// SPDX-License-Identifier: MIT
#include "core/map/map_merge.h"

#include <algorithm>
#include <cstring>
#include <set>

namespace grass {

namespace {

class Merger {
public:
	Merger(const PaintMap &p_base, const PaintMap &p_theirs, const PaintMap &p_mine, bool p_prefers_theirs) :
			_base(p_base), _theirs(p_theirs), _mine(p_mine), _prefers_theirs(p_prefers_theirs), _map(p_mine) {}

	MapMerge run() {
		merge_base_density();
		merge_ground_grid();
		std::set<MapKey> keys;
		for (const PaintMap *map : { &_base, &_theirs, &_mine }) {
			for (const auto &[key, chunk] : map->get_chunks()) {
				keys.insert(key);
			}
		}
		for (const MapKey &key : keys) {
			for (int channel = 0; channel < MAP_CHANNELS && _result.reason.empty(); channel++) {
				merge_channel(key, MapChannel(channel));
			}
		}
		_map.drop_empty();
		_result.changed = _map.compare(_mine);
		return _result;
	}

	PaintMap &get_map() { return _map; }

private:
	void merge_base_density() {
		const double base = _base.get_base_density(), theirs = _theirs.get_base_density(), mine = _mine.get_base_density();
		const bool is_theirs = theirs != base && theirs != mine;
		_result.is_base_in_conflict = is_theirs && mine != base;
		_result.has_base_changed = is_theirs && (mine == base || _prefers_theirs);
		if (_result.has_base_changed) {
			_map.set_base_density(theirs);
		}
	}

	void merge_ground_grid() {
		const GroundGrid &base = _base.get_ground_grid(), &theirs = _theirs.get_ground_grid(), &mine = _mine.get_ground_grid();
		if (!(theirs == base) && !(theirs == mine) && (mine == base || _prefers_theirs)) {
			_map.set_ground_grid(theirs);
			_result.has_base_changed = true;
		}
	}

	static std::shared_ptr<const MapTexels> find(const PaintMap &p_map, const MapKey &p_key, MapChannel p_channel) {
		const MapChunk *chunk = p_map.find(p_key);
		return chunk != nullptr ? chunk->channels[size_t(p_channel)] : nullptr;
	}
	static MapTexels texels_of(const PaintMap &p_map, const MapKey &p_key, MapChannel p_channel) {
		const auto texels = find(p_map, p_key, p_channel);
		return texels != nullptr ? *texels : p_map.initial_texels(p_channel);
	}
	// Returns whether chunks without texels have the same codes in all three.
	bool is_initially_same(MapChannel p_channel) const {
		const double base = _base.get_base_density();
		return p_channel != MAP_DENSITY || (base == _theirs.get_base_density() && base == _mine.get_base_density());
	}

	void merge_channel(const MapKey &p_key, MapChannel p_channel) {
		const auto base = find(_base, p_key, p_channel), theirs = find(_theirs, p_key, p_channel), mine = find(_mine, p_key, p_channel);
		if ((!base && !theirs && !mine) || (is_initially_same(p_channel) && (theirs == base || theirs == mine))) {
			return; // the base density covers it, or they changed nothing
		}
		MapTexels merged = texels_of(_mine, p_key, p_channel);
		merge_texels(p_key, p_channel, texels_of(_base, p_key, p_channel), texels_of(_theirs, p_key, p_channel), merged);
		if (mine && *mine == merged) {
			return; // shares its texels
		}
		std::shared_ptr<const MapTexels> texels; // of what is as it was at first: none
		if (merged != _map.initial_texels(p_channel)) {
			texels = theirs && *theirs == merged ? theirs : std::make_shared<const MapTexels>(std::move(merged));
		}
		if (!_map.set_texels(p_key, p_channel, texels)) {
			_result.reason =
					"would have too many chunks: a map holds at most " + std::to_string(PaintMap::MAX_CHUNKS) + " that are painted";
		}
	}

	void merge_texels(const MapKey &p_key, MapChannel p_channel, const MapTexels &p_base, const MapTexels &p_theirs, MapTexels &r_mine) {
		const MapChannelInfo &info = info_of(p_channel);
		const size_t bytes = size_t(info.components * info.bytes);
		// Where one of them painted nothing, it only changed the density of everything that is not painted: paint stays above that.
		const bool is_base_bare = !find(_base, p_key, p_channel);
		const bool have_they_painted = !is_base_bare || find(_theirs, p_key, p_channel);
		const bool have_i_painted = !is_base_bare || find(_mine, p_key, p_channel);
		MergeConflict conflict{ p_key, p_channel, 0, {} };
		for (size_t at = 0; at < r_mine.size(); at += bytes) {
			const auto are_same = [&](const MapTexels &p_a, const MapTexels &p_b) { return std::memcmp(&p_a[at], &p_b[at], bytes) == 0; };
			if (are_same(p_theirs, p_base) || are_same(p_theirs, r_mine)) {
				continue;
			}
			const bool have_both_changed = !are_same(r_mine, p_base),
					   is_conflict = have_both_changed && have_they_painted && have_i_painted;
			if (have_both_changed && !have_they_painted) {
				continue;
			}
			if (is_conflict) {
				const int n = int(at / bytes);
				const Eigen::Vector2d corner(p_key.x * info.side + n % info.side, p_key.z * info.side + n / info.side);
				const MapRegion texel{ corner * info.texel_size(), (corner.array() + 1.0) * info.texel_size() };
				conflict.region = conflict.texels++ == 0 ? texel : conflict.region.joined(texel);
			}
			if (!is_conflict || _prefers_theirs) {
				std::memcpy(&r_mine[at], &p_theirs[at], bytes);
				_result.texels++;
			}
		}
		if (conflict.texels > 0) {
			_result.conflicts.push_back(conflict);
		}
	}

	const PaintMap &_base, &_theirs, &_mine;
	bool _prefers_theirs;
	PaintMap _map;
	MapMerge _result;
};

} // namespace

MapMerge merge_maps(const PaintMap &p_base, const PaintMap &p_theirs, PaintMap &r_mine, bool p_prefers_theirs, const ReadLimits &p_limits) {
	Merger merger(p_base, p_theirs, r_mine, p_prefers_theirs);
	MapMerge merge = merger.run();
	const size_t bytes = merger.get_map().get_memory_usage();
	if (merge.reason.empty() && bytes > p_limits.map_bytes && bytes > r_mine.get_memory_usage()) {
		merge.reason = "would take " + megabytes(bytes) + " of memory, but a map may take at most " + megabytes(p_limits.map_bytes) +
				p_limits.map_hint;
	}
	if (!merge.reason.empty()) {
		return { merge.reason, {}, 0, false, false, {} };
	}
	r_mine = std::move(merger.get_map());
	return merge;
}

} // namespace grass

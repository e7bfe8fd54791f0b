// SPDX-License-Identifier: MIT
// Where colliders go in a step: the tiles that each of them may meet.
#include "core/tiles/tile_meetings.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

// At most p_limit tiles of the range: those around (p_x, p_z).
TileRange shrink(const TileRange &p_range, int64_t p_limit, int p_x, int p_z) {
	if (p_range.count() <= p_limit) {
		return p_range;
	}
	if (p_limit <= 0) {
		return {};
	}
	int width = std::min(p_range.width(), std::max(1, int(std::sqrt(double(p_limit)))));
	const int depth = int(std::min<int64_t>(p_range.depth(), p_limit / width));
	width = int(std::min<int64_t>(p_range.width(), p_limit / depth));
	TileRange range;
	range.x_begin = std::clamp(p_x - width / 2, p_range.x_begin, p_range.x_end - width);
	range.z_begin = std::clamp(p_z - depth / 2, p_range.z_begin, p_range.z_end - depth);
	range.x_end = range.x_begin + width;
	range.z_end = range.z_begin + depth;
	return range;
}

} // namespace

void TileMeetings::add_collider(ColliderShape &r_collider, uint32_t p_index, Block &r_block) {
	Known &known = _known[p_index];
	const bool is_same = r_collider.stamp != 0 && r_collider.stamp == known.stamp;
	if (!is_same) {
		const char *reason = nullptr;
		known.stamp = r_collider.stamp;
		known.is_good = r_collider.sanitise(reason);
		known.is_complete = false;
	}
	r_block.bad_colliders += known.is_good ? 0 : 1;
	if (known.is_good && is_same) {
		r_block.ways.push_back({ known.swept, known.whole, p_index });
	} else if (known.is_good) {
		add_ways(r_collider, p_index, r_block);
	}
}

// The tiles that the collider may meet: those under the box around all of its way. Where these are more than can be awake, those under
// boxes around pieces of it: what crosses the field aslant in one step passes over few of the tiles between its ends.
void TileMeetings::add_ways(const ColliderShape &p_collider, uint32_t p_index, Block &r_block) {
	constexpr double MOST_PIECES = 256.0;
	const Bounds swept = p_collider.get_swept_bounds();
	const TileRange range = find_range(swept);
	const Eigen::Vector3d way = p_collider.now.position - p_collider.before.position;
	const double own = std::max(2.0 * p_collider.get_half_extents().norm(), 2.0 * _tiles->grid.get_tile_size());
	const double pieces = std::min(std::ceil(std::hypot(way.x(), way.z()) / own), MOST_PIECES);
	if (range.count() <= _tiles->params.pool_size || pieces < 2.0) {
		r_block.ways.push_back({ swept, range, p_index });
		_known[p_index].swept = swept;
		_known[p_index].whole = range;
		return;
	}
	_known[p_index].stamp = 0;
	ColliderShape piece = p_collider;
	for (double i = 0.0; i < pieces; i += 1.0) {
		piece.before.position = p_collider.before.position + way * (i / pieces);
		piece.now.position = p_collider.before.position + way * ((i + 1.0) / pieces);
		const Bounds bounds = piece.get_swept_bounds();
		r_block.ways.push_back({ bounds, find_range(bounds), p_index });
	}
}

// A body over more tiles than the pool holds, or bodies that together fill the list, get those around their centres.
void TileMeetings::limit_ranges(std::span<const ColliderShape> p_colliders) {
	int64_t total = 0, widest = 0;
	size_t ways = 0;
	for (const Block &block : get_blocks()) {
		ways += block.ways.size();
		for (const Way &way : block.ways) {
			total += way.range.count();
			widest = std::max(widest, way.range.count());
		}
	}
	if (_tiles->bounds && total > GRASS_START_COUNT / 4) {
		_tiles->bounds->prefetch();
	}
	const int64_t capacity = _tiles->params.list_capacity();
	const int64_t share = total <= capacity ? capacity : std::max<int64_t>(1, capacity / int64_t(ways));
	const int64_t most = std::min<int64_t>(share, _tiles->params.pool_size);
	if (total <= capacity && widest <= most) {
		return;
	}
	int64_t left = capacity;
	for (Block &block : get_blocks()) {
		for (Way &way : block.ways) {
			TileRange &range = way.range;
			if (const int64_t limit = std::min(most, left); range.count() > limit) {
				const TilePlace centre = _tiles->grid.get_place(p_colliders[way.collider].now.position);
				_tiles->statistics.capped += uint64_t(range.count());
				range = shrink(range, limit, centre.x, centre.z);
				_tiles->statistics.capped -= uint64_t(range.count());
			}
			left -= range.count();
		}
	}
}

// The tiles whose box could meet the collider's: squares grown by the widest overhang, lowest ground to highest tip.
TileRange TileMeetings::find_range(const Bounds &p_swept) const {
	if (p_swept.max.y() <= _tiles->params.low + TileBounds::LEAST_RISE || p_swept.min.y() > _tiles->params.height) {
		return {};
	}
	return _tiles->grid.get_range(p_swept.min.x(), p_swept.max.x(), p_swept.min.z(), p_swept.max.z(), _tiles->params.overhang);
}

} // namespace grass

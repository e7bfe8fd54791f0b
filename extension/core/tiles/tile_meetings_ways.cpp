// SPDX-License-Identifier: MIT
// The paths of colliders in a step: the tiles that each of them may meet.
#include "core/tiles/tile_meetings.h"

#include <cmath>

namespace grass {

namespace {

// Up to this number of tiles a body is small: most of its tiles are at its outline.
constexpr int64_t LARGE = 64;

// Returns at most p_limit tiles of the range: those around (p_x, p_z).
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

// Finds how a collider has grown. It is the same one as in the last step if it begins where that one ended, and not if it was put somewhere
// else.
void TileMeetings::follow_growth(ColliderShape &r_collider, Known &r_known) {
	constexpr double SAME_PLACE = 1e-6; // metres
	const bool is_same = r_known.type == r_collider.type && r_known.owner == r_collider.owner &&
			(r_collider.before.position - r_known.place).norm() < SAME_PLACE;
	r_collider.growth = 0.0;
	if (is_same && r_known.is_good) {
		r_collider.grow_from(r_known.half_extents);
	}
	r_known.owner = r_collider.owner;
	r_known.type = r_collider.type;
	r_known.half_extents = r_collider.get_half_extents();
	r_known.place = r_collider.now.position;
}

void TileMeetings::add_collider(ColliderShape &r_collider, uint32_t p_index, Block &r_block) {
	Known &known = _known[p_index];
	const bool is_same = r_collider.stamp != 0 && r_collider.stamp == known.stamp;
	if (!is_same) {
		const char *reason = nullptr;
		known.stamp = r_collider.stamp;
		known.is_good = r_collider.sanitise(reason);
		known.is_complete = false;
	}
	follow_growth(r_collider, known);
	r_block.bad_colliders += known.is_good ? 0 : 1;
	if (known.is_good && is_same) {
		r_block.ways.push_back({ known.swept, known.whole, p_index });
	} else if (known.is_good) {
		add_ways(r_collider, p_index, r_block);
	}
}

// Adds the tiles that the collider may meet: those under the box around its whole path. If these are more than can be awake, those under
// boxes around pieces of the path: a body that crosses the field diagonally in one step passes few of the tiles between its ends.
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

// Limits bodies to the tiles around their outlines: large ones if more tiles are met than can be awake, and all of them if together they
// fill the list.
void TileMeetings::limit_ranges(std::span<const ColliderShape> p_colliders) {
	constexpr int64_t WIDE_PART = 8; // a body that covers such a part of the pool is large too
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
	const int64_t pool = _tiles->params.pool_size;
	LimitsBySight limits = find_limits(total, ways);
	const int64_t most = std::min(limits[0].most, limits[1].most), wide = total > pool ? std::max(LARGE, pool / WIDE_PART) : most;
	if (total <= _tiles->params.list_capacity() && widest <= std::min(most, wide)) {
		return;
	}
	for (Block &block : get_blocks()) {
		limit_ways(p_colliders, wide, limits, block);
	}
}

// Finds how many tiles each way may meet. If the list has no room for all of them, ways in view come first, and the others share what is
// left.
TileMeetings::LimitsBySight TileMeetings::find_limits(int64_t p_total, size_t p_ways) {
	constexpr int64_t OTHERS_PART = 4; // of the list is kept for a tile each of the ways out of view
	const int64_t pool = _tiles->params.pool_size, capacity = _tiles->params.list_capacity();
	if (p_total <= capacity) {
		return { { { pool, capacity }, { pool, capacity } } };
	}
	int64_t seen_ways = 0, seen_total = 0;
	for (Block &block : get_blocks()) {
		for (Way &way : block.ways) {
			way.is_seen = !_tiles->view.sees_all() && _tiles->view.get_band(way.range, TileParams::SEEN_MARGIN) != TileView::UNSEEN;
			seen_ways += way.is_seen;
			seen_total += way.is_seen ? way.range.count() : 0;
		}
	}
	const int64_t other_ways = int64_t(p_ways) - seen_ways;
	const int64_t seen_room = seen_ways == 0 ? 0 : std::min(seen_total, capacity - std::min(other_ways, capacity / OTHERS_PART));
	const auto share = [pool](int64_t p_room, int64_t p_sharing) {
		return std::min(pool, std::max<int64_t>(1, p_room / std::max<int64_t>(1, p_sharing)));
	};
	_tiles->statistics.ranked += _tiles->view.sees_all() ? 0 : p_ways;
	return { { { share(capacity - seen_room, other_ways), capacity - seen_room },
			{ seen_room == seen_total ? pool : share(seen_room, seen_ways), seen_room } } };
}

void TileMeetings::limit_ways(std::span<const ColliderShape> p_colliders, int64_t p_wide, LimitsBySight &r_limits, Block &r_block) {
	std::vector<Way> &whole = r_block.whole;
	whole.swap(r_block.ways);
	r_block.ways.clear();
	for (size_t i = 0; i < whole.size(); i++) {
		const ColliderShape &collider = p_colliders[whole[i].collider];
		Limits &limits = r_limits[size_t(whole[i].is_seen)];
		const int64_t limit = std::min(limits.most, limits.left), count = whole[i].range.count();
		const bool is_hiding =
				count > p_wide && collider.force == ColliderShape::NO_FORCE && whole[i].swept.max.y() >= _tiles->params.height;
		const bool is_piece = (i > 0 && whole[i - 1].collider == whole[i].collider) ||
				(i + 1 < whole.size() && whole[i + 1].collider == whole[i].collider);
		int64_t kept = count;
		if (count <= limit && (is_piece || !is_hiding)) {
			r_block.ways.push_back(whole[i]);
		} else if (is_piece || count <= LARGE || collider.force != ColliderShape::NO_FORCE) {
			const TilePlace centre = _tiles->grid.get_place(collider.now.position);
			r_block.ways.push_back(whole[i]);
			TileRange &range = r_block.ways.back().range;
			range = shrink(range, limit, centre.x, centre.z);
			kept = range.count();
		} else {
			kept = narrow(collider, whole[i], limit, r_block);
		}
		_tiles->statistics.capped += uint64_t(count - kept);
		limits.left -= kept;
	}
}

// Replaces a range over everything under the body with ranges around its outline, where blades bend outwards, those in view first. A body
// lower than the grass gets the rest around its middle. Returns how many tiles they may meet, at most p_limit.
int64_t TileMeetings::narrow(const ColliderShape &p_collider, const Way &p_way, int64_t p_limit, Block &r_block) {
	_known[p_way.collider].stamp = 0;
	_known[p_way.collider].is_complete = false;
	const TilePlace centre = _tiles->grid.get_place(p_collider.now.position);
	const TileFootprint footprint(p_collider, p_way.swept, _tiles->grid, _tiles->params);
	int64_t left = p_limit;
	for (const bool seen : { true, false }) {
		add_outline(footprint, p_way, centre.z, seen, left, r_block);
	}
	int64_t inner = left;
	if (footprint.is_tall()) {
		inner = left == p_limit ? std::min<int64_t>(left, 1) : 0; // one, to find out whether it is in grass
	}
	if (inner > 0) {
		r_block.ways.push_back({ p_way.swept, shrink(p_way.range, inner, centre.x, centre.z), p_way.collider });
		left -= r_block.ways.back().range.count();
	}
	return p_limit - left;
}

// Adds the outline from the middle row outwards. p_seen: the tiles in view, or the others.
void TileMeetings::add_outline(
		const TileFootprint &p_footprint, const Way &p_way, int p_middle, bool p_seen, int64_t &r_left, Block &r_block) const {
	const TileRange &range = p_way.range;
	const int middle = std::clamp(p_middle, range.z_begin, range.z_end - 1);
	for (int n = 0; n < 2 * range.depth() && r_left > 0; n++) {
		const int z = middle + (n % 2 == 0 ? n / 2 : -(n + 1) / 2);
		if (z < range.z_begin || z >= range.z_end) {
			continue;
		}
		const TileFootprint::Span reached = p_footprint.find_reached(z, { range.x_begin, range.x_end });
		const TileFootprint::Span covered = reached.is_empty() ? reached : p_footprint.find_covered(z, reached);
		if (covered.is_empty()) {
			add_span(p_way, z, reached, p_seen, r_left, r_block);
		} else {
			add_span(p_way, z, { reached.begin, covered.begin }, p_seen, r_left, r_block);
			add_span(p_way, z, { covered.end, reached.end }, p_seen, r_left, r_block);
		}
	}
}

// Adds a span in gapless pieces, of tiles that the body meets.
void TileMeetings::add_span(
		const Way &p_way, int p_z, const TileFootprint::Span &p_span, bool p_seen, int64_t &r_left, Block &r_block) const {
	const auto is_wanted = [&](int p_x) {
		return _tiles->view.sees(p_x, p_z) == p_seen && (!_tiles->bounds || _tiles->bounds->meets(p_x, p_z, p_way.swept));
	};
	int begin = p_span.begin;
	for (int x = p_span.begin; x <= p_span.end && r_left > 0; x++) {
		if (x < p_span.end && x - begin < r_left && is_wanted(x)) {
			continue;
		}
		if (x > begin) {
			r_block.ways.push_back({ p_way.swept, { begin, x, p_z, p_z + 1 }, p_way.collider });
			r_left -= x - begin;
		}
		begin = x + 1;
	}
	r_block.looked_at += uint64_t(std::max(p_span.end - p_span.begin, 0));
}

// Returns the tiles whose box could meet the collider's: their squares enlarged by the widest overhang, from the lowest ground to the
// highest tip.
TileRange TileMeetings::find_range(const Bounds &p_swept) const {
	if (p_swept.max.y() <= _tiles->params.low + TileBounds::LEAST_RISE || p_swept.min.y() > _tiles->params.height) {
		return {};
	}
	return _tiles->grid.get_range(p_swept.min.x(), p_swept.max.x(), p_swept.min.z(), p_swept.max.z(), _tiles->params.overhang);
}

} // namespace grass

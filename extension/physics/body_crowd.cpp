// SPDX-License-Identifier: MIT
// How BodyTracker follows a crowd: plain bodies need only their own memory and their pose, so several threads read them at once
// (docs/decisions/0048-crowds-on-all-threads.md).
#include "physics/body_tracker.h"

#include <godot_cpp/classes/physics_server3d.hpp>

#include <algorithm>
#include <cstddef>

using namespace godot;

namespace grass {

namespace {

// The least number of moving bodies for which other threads help. Fewer: waking the threads takes longer than they save.
constexpr size_t CROWD = 256;
// How many bodies ahead memory is fetched: as many as are processed during a fetch.
constexpr size_t FETCH_AHEAD = 4;

// Prefetches p_bytes from p_place on.
void prefetch(const void *p_place, size_t p_bytes) {
#ifdef __GNUC__
	constexpr size_t LINE = 64; // of a cache line
	for (size_t i = 0; i < p_bytes; i += LINE) {
		__builtin_prefetch(static_cast<const char *>(p_place) + i);
	}
#else
	(void)p_place;
	(void)p_bytes;
#endif
}

} // namespace

bool BodyTracker::is_odd(const TrackedShape &p_shape) {
	return p_shape.is_bound || p_shape.type == PhysicsServer3D::SHAPE_HEIGHTMAP;
}

// According to the last look: it moves as its velocity says, and has shapes, none of which needs a warning.
bool BodyTracker::is_plain(const Body &p_body) {
	return p_body.is_driven && p_body.has_before && p_body.is_written && !p_body.shapes.empty() &&
			std::ranges::none_of(p_body.shapes, is_odd);
}

bool BodyTracker::is_plain_now(const Body &p_body) {
	return p_body.is_plain && !p_body.is_asleep && p_body.overlaps > 0 && p_body.next_look > 0;
}

// Reserves places for as many colliders as it has, since its shapes are not checked.
void BodyTracker::join_crowd(Body &r_body, const Following &p_following) {
	_crowd.push_back({ &r_body, p_following.stamps });
	p_following.stamps += r_body.colliders;
	const size_t end = size_t(r_body.first_collider) + r_body.colliders;
	p_following.colliders.resize(std::max(p_following.colliders.size(), end));
}

bool BodyTracker::is_crowded() const {
	return _crowd.size() >= CROWD;
}

void BodyTracker::follow_crowd(const Following &p_following, const ParallelFor &p_parallel_for) {
	struct Block {
		BodyReads reads;
		bool has_lost = false;
	};
	std::vector<Block> blocks(count_blocks(_crowd.size()));
	const auto follow_block = [&](int p_block) {
		const size_t begin = size_t(p_block) * PARALLEL_BLOCK, end = std::min(begin + PARALLEL_BLOCK, _crowd.size());
		Block block;
		for (size_t i = begin; i < end; i++) {
			fetch_ahead(i, end, p_following.colliders);
			uint64_t stamps = _crowd[i].stamps;
			Body &body = *_crowd[i].body;
			follow_member(body, { p_following.field, p_following.tick, p_following.colliders, block.reads, stamps });
			block.has_lost = block.has_lost || body.is_lost;
		}
		blocks[size_t(p_block)] = block;
	};
	(is_crowded() ? p_parallel_for : serial_for)(int(blocks.size()), follow_block);
	bool has_lost = false;
	for (const Block &block : blocks) {
		_reads.add(block.reads);
		has_lost = has_lost || block.has_lost;
	}
	if (has_lost) {
		_has_lost = true;
		drop_lost(p_following.colliders);
	}
}

void BodyTracker::follow_member(Body &r_body, const Following &p_following) {
	r_body.is_lost = !find_state(r_body, p_following.reads);
	if (r_body.is_lost) {
		return;
	}
	r_body.left_for = 0;
	r_body.next_look--;
	const Transform3D world = find_place(r_body, p_following.reads);
	follow_sleep(r_body, world, false);
	if (world != r_body.world_before || !keep_at_rest(r_body, p_following.field)) {
		follow(r_body, world, false, p_following);
	}
}

// Closes the gaps of bodies that were freed.
void BodyTracker::drop_lost(std::vector<ColliderShape> &r_colliders) {
	_written = 0;
	_mesh_pieces = 0;
	for (Body *body : _line) {
		if (body->is_lost) {
			watch_sleep(*body, false);
			continue;
		}
		if (body->first_collider != _written) {
			const auto first = r_colliders.begin() + body->first_collider;
			std::move(first, first + body->colliders, r_colliders.begin() + ptrdiff_t(_written));
			body->first_collider = uint32_t(_written);
		}
		_written += body->colliders;
		_mesh_pieces += body->mesh_pieces;
	}
}

// Prefetches what the walk over the line reads of body p_index. The memory of a crowd exceeds the caches.
void BodyTracker::fetch_head(size_t p_index) const {
	if (const size_t far = p_index + 4 * FETCH_AHEAD; far < _line.size()) {
		prefetch(_line[far], offsetof(Body, world_before));
	}
}

// Prefetches what following body p_index of the crowd reads, pointer by pointer: each pointer farther ahead than what it points to.
void BodyTracker::fetch_ahead(size_t p_index, size_t p_end, const std::vector<ColliderShape> &p_colliders) const {
	if (const size_t far = p_index + 3 * FETCH_AHEAD; far < p_end) {
		prefetch(_crowd[far].body, offsetof(Body, rid));
	}
	if (const size_t near = p_index + 2 * FETCH_AHEAD; near < p_end) {
		const Body &body = *_crowd[near].body;
		prefetch(body.state, 1);
		for (const TrackedShape &shape : body.shapes) {
			prefetch(&shape, offsetof(TrackedShape, rid));
		}
		prefetch(p_colliders.data() + body.first_collider, body.colliders * sizeof(ColliderShape));
	}
	if (const size_t next = p_index + FETCH_AHEAD; next < p_end) {
		for (const TrackedShape &shape : _crowd[next].body->shapes) {
			for (const ShapePart &part : shape.parts) {
				prefetch(&part, ShapePart::HOT);
			}
		}
	}
}

} // namespace grass

// SPDX-License-Identifier: MIT
// How BodyTracker follows a crowd: plain bodies need only their own memory and their pose, so several threads read them at once
// (docs/decisions/0048-crowds-on-all-threads.md).
#include "physics/body_tracker.h"

#include <godot_cpp/classes/physics_server3d.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// The least number of moving bodies for which other threads help. Fewer: waking the threads takes longer than they save.
constexpr size_t CROWD = 256;

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

} // namespace grass

// SPDX-License-Identifier: MIT
// How BodyTracker follows a crowd: plain bodies need only their own memory and their pose, so several threads read them at once
// (docs/history/0048-crowds-on-all-threads.md).
#include "physics/body_tracker.h"

#include <godot_cpp/classes/physics_server3d.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// The least number of moving bodies for which other threads help. Fewer: waking the threads takes longer than they save.
constexpr size_t CROWD = 256;

} // namespace

// Reserves places for as many colliders as it has, since its shapes are not checked.
void BodyTracker::join_crowd(TrackedBody &r_body, const BodyTick &p_tick) {
	r_body.colliders.place(_written);
	_crowd.push_back({ &r_body, p_tick.stamps });
	p_tick.stamps += r_body.colliders.count;
	const size_t end = size_t(r_body.colliders.first) + r_body.colliders.count;
	p_tick.colliders.resize(std::max(p_tick.colliders.size(), end));
}

bool BodyTracker::is_crowded() const {
	return _crowd.size() >= CROWD;
}

void BodyTracker::follow_crowd(const BodyTick &p_tick, const ParallelFor &p_parallel_for) {
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
			TrackedBody &body = *_crowd[i].body;
			body.read_pose(
					{ p_tick.field, p_tick.tick, p_tick.colliders, block.reads, stamps, p_tick.warnings, p_tick.woke, p_tick.look_every });
			block.has_lost = block.has_lost || body.state == TrackedBody::State::LOST;
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
		drop_lost(p_tick.colliders);
	}
}

// Closes the gaps of bodies that were freed.
void BodyTracker::drop_lost(std::vector<ColliderShape> &r_colliders) {
	_written = 0;
	_mesh_pieces = 0;
	for (TrackedBody *body : _line) {
		if (body->state == TrackedBody::State::LOST) {
			continue;
		}
		if (body->colliders.first != _written) {
			const auto first = r_colliders.begin() + body->colliders.first;
			std::move(first, first + body->colliders.count, r_colliders.begin() + ptrdiff_t(_written));
			body->colliders.first = uint32_t(_written);
		}
		_written += body->colliders.count;
		_mesh_pieces += body->colliders.mesh_pieces;
	}
}

} // namespace grass

// SPDX-License-Identifier: MIT
// Keeps baked ground up to date while a scene is edited: where a body below grass was moved, resized or removed, or the field itself was
// moved, the ground is read again. This is not a step of the undo history: undoing a motion is a motion too, and brings back the earlier
// ground.
#pragma once

#include "core/paint/lay_ground.h"
#include "editor/ground_bodies.h"
#include "nodes/grass_field.h"

#include <deque>
#include <map>
#include <memory>

namespace grass {

class GroundWatch {
public:
	// Must be called once in each frame. p_root: of the edited scene, or null.
	void update(godot::Node *p_root);
	// Reads all waiting ground at once. Call it before anything uses the ground or takes a snapshot.
	void finish(godot::Node *p_root);
	void forget();

	int64_t get_rays() const { return _rays; } // cast so far
	int64_t get_most_rays() const { return _most_rays; } // cast in one update()
	int64_t get_waiting() const { return int64_t(_pieces.size()); }
	double get_look_us() const { return _look_us; } // CPU time of checks in the longest frame of this round, microseconds

private:
	// Something that may move: its state at the last check, and its state when the ground was baked from it.
	template <typename T> struct Watched {
		T last, baked;
		bool is_ground = false; // grass was on it at some time, as far as its motion was seen
	};
	// Ground to be read. If a body has left it: the box of the body, in the field's space, and the map at that time. And what has been read
	// of it.
	struct Piece {
		uint64_t field_id;
		MapRegion region;
		Eigen::AlignedBox3d left;
		std::shared_ptr<const PaintMap> before;
		std::optional<GroundReading> reading;
	};

	bool begin_round(godot::Node *p_root);
	void look(size_t p_count);
	void look_at_body(uint64_t p_id, Watched<GroundBody> &r_body);
	void look_at_fields();
	std::vector<const GrassField *> find_fields() const;
	void add_body(Watched<GroundBody> &r_body, const GroundBody &p_now);
	bool may_lay(const GrassField &p_field);
	void add_pieces(const GrassField &p_field, const MapRegion &p_region, const Eigen::AlignedBox3d &p_left);
	void read(int64_t p_most);
	bool read_on(int64_t p_most);
	void lay(const godot::Ref<GrassMap> &p_map, const GroundReading &p_ground);

	uint64_t _root_id = 0; // of the watched scene; 0: none, since none of its fields has ground
	std::vector<uint64_t> _field_ids; // of fields with ground
	std::map<uint64_t, Watched<GroundBody>> _bodies; // by the node's id
	std::map<uint64_t, Watched<godot::Transform3D>> _poses; // of fields, by id
	std::deque<Piece> _pieces;
	bool _is_told = false; // that the ground below some field of this scene is not read
	uint64_t _next_body = 0; // id, at which this round goes on
	int _frames_left = 0, _rounds_left = 0; // to the next round; to the next search for bodies
	int64_t _rays = 0, _most_rays = 0;
	double _look_us = 0.0;
};

} // namespace grass

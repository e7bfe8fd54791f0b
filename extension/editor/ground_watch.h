// SPDX-License-Identifier: MIT
// Keeps ground that is baked true while a scene is edited: where a body that grass stands on was moved, resized or taken away,
// or the field itself was moved, the ground is read again. It is no step of the history: a motion that is undone is a motion,
// and brings the ground back that was there.
#pragma once

#include "editor/ground_bodies.h"
#include "nodes/grass_field.h"

#include <deque>
#include <map>

namespace grass {

class GroundWatch {
public:
	// Once a frame. p_root: of the scene that is edited, or null.
	void update(godot::Node *p_root);
	// All at once, for whoever goes by the ground now, or keeps a snapshot of it.
	void finish(godot::Node *p_root);
	void forget();

	int64_t get_rays() const { return _rays; } // cast so far
	int64_t get_waiting() const { return int64_t(_pieces.size()); }
	double get_look_us() const { return _look_us; } // CPU time of the last look at the scene, microseconds

private:
	// Something that moves: as it was at the last look, and as it was when the ground was baked by it.
	template <typename T> struct Watched {
		T last, baked;
		bool is_ground = false; // grass stood on it once, as far as it was seen to move
	};
	// Ground to be read, and the box of a body that has left it, in the field's space.
	struct Piece {
		uint64_t field_id;
		MapRegion region;
		Eigen::AlignedBox3d left;
	};

	void look(godot::Node *p_root);
	void look_at_bodies(godot::Node *p_root, bool p_is_first);
	void look_at_fields(bool p_is_first);
	void add_body(Watched<GroundBody> &r_body, const GroundBody &p_now);
	void add_pieces(const GrassField &p_field, const MapRegion &p_region, const Eigen::AlignedBox3d &p_left);
	int64_t bake(const Piece &p_piece);

	uint64_t _root_id = 0; // of the scene that is watched; 0: none, since no field of it has ground
	std::vector<GrassField *> _fields; // of this look
	std::map<uint64_t, Watched<GroundBody>> _bodies; // by the node's id
	std::map<uint64_t, Watched<godot::Transform3D>> _poses; // of fields, by id
	std::deque<Piece> _pieces;
	int _frames_to_look = 0;
	int64_t _rays = 0;
	double _look_us = 0.0;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// How many blades of a tile are simulated: those that the level of detail draws there, in the picture or in shadows, from where the cameras
// are (docs/history/0079-simulate-what-is-seen.md). Where they look does not matter: they may turn at any time. With a budget of time they
// may be fewer (docs/history/0090-a-budget-for-the-simulation.md); other drawn blades then follow them.
#pragma once

#include "core/lod/cull.h"
#include "core/lod/view.h"

#include <memory>
#include <unordered_map>

namespace grass {

// SEEN: blades that no camera needs are not simulated. WHOLE: all blades of awake tiles are, as on a server.
enum class SimulationDetail { SEEN, WHOLE };

class TileDetail {
public:
	// How far an eye may move before blades_of() may return another number, metres. Larger: more blades than necessary are simulated.
	// Smaller: the awake tiles are looked at more often.
	static constexpr float SLACK = 0.25f;
	// For how many frames a tile stays whole after ask().
	static constexpr int FRAMES_ASKED = 60;
	// Up to this distance from an eye, metres, every drawn blade is simulated whatever the coarseness: there a player watches single
	// bodies.
	static constexpr double FINE_DISTANCE = 4.0;

	// Simulates all blades of every tile. Returns whether blades_of() may return other numbers than before.
	bool see_all();
	// Simulates what p_view's cameras need; without cameras, everything. Must be called in each frame. p_cover: of the field's map, or
	// null. Returns whether blades_of() may return other numbers than before.
	bool see(const CullField &p_field, const FieldView &p_view, const std::shared_ptr<const TileCover> &p_cover);
	// Sets how many times coarser blades are simulated than drawn, at least 1. Returns whether simulated_of() may return other numbers than
	// before: changes too small to matter are kept for later.
	bool set_coarseness(float p_coarseness);
	float get_coarseness() const { return _sees_all ? 1.0f : _coarseness; }
	// Must be called when the grass of the field has changed: the next see() returns true.
	void forget() { _is_known = false; }
	// Keeps a tile whole for a while, since a script reads its blades. Returns false if it was kept whole already.
	bool ask(int p_tile);

	// Returns the number of blades that are drawn: a multiple of GRASS_DETAIL_BLADES. p_now: the number so far, which stays if it is not
	// far from what is needed; 0: none.
	int blades_of(int p_x, int p_z, int p_now) const;
	// Returns how many of them are simulated, in the same way. p_drawn: of blades_of().
	int simulated_of(int p_x, int p_z, int p_now, int p_drawn) const;
	// Returns whether an eye may be within p_distance metres of the tile's middle. True while everything is simulated whole.
	bool is_within(int p_x, int p_z, double p_distance) const;
	size_t get_memory_usage() const; // bytes

private:
	bool forget_asked();
	bool is_near(const CullField &p_field, const FieldView &p_view, const std::shared_ptr<const TileCover> &p_cover) const;
	Eigen::Vector3f middle_of(int p_x, int p_z, const TileCover::Tile &p_ground) const;
	int blades_within(int p_x, int p_z, const TileCover::Tile &p_ground, float p_slack, const LodParams &p_lod) const;
	int kept_blades(int p_x, int p_z, int p_now, const LodParams &p_lod) const;
	LodParams coarse_lod() const;

	bool _sees_all = true, _is_known = false;
	float _coarseness = 1.0f;
	// As of the last change:
	CullField _field;
	FieldView _view;
	std::shared_ptr<const TileCover> _cover;
	std::unordered_map<int, int> _asked; // tiles, and the frames for which they stay whole; only looked up
};

} // namespace grass

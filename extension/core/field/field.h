// SPDX-License-Identifier: MIT
// The field that runs: its setup, its awake tiles, its clock, and its views. A tick goes from bodies to tiles to a simulator. It needs no
// node and no engine: tests/unit/test_field.cpp runs it.
#pragma once

#include "core/blades/force.h"
#include "core/field/field_params.h"
#include "core/field/field_setup.h"
#include "core/field/knots.h"
#include "core/field/simulator.h"
#include "core/lod/view.h"
#include "core/map/map_layers.h"
#include "core/species/field_blades.h"
#include "core/tiles/tiles.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace grass {

class Field : private PoolBudget::Member {
public:
	using SpeciesPatches = std::vector<std::shared_ptr<const Patch>>;

	// Makes a field without blades. p_budget: of awake tiles, for all fields together. Null: only the field's own pool limits them.
	explicit Field(std::shared_ptr<PoolBudget> p_budget = nullptr);
	Field(const Field &) = delete;
	Field &operator=(const Field &) = delete;
	~Field();

	// Becomes this field, all of it at rest. p_map: what is painted on it, or null; must live until forget_map() or the field's end.
	// p_species: the patch of each species.
	void set(const FieldSetup &p_setup, const std::shared_ptr<TileBounds> &p_bounds, const MapLayers *p_map,
			const SpeciesPatches &p_species, const FieldParams &p_params);
	void forget_map();
	// Takes over from another field what blades of the same patch need. Must be called before set().
	void join(const Field &p_other) {
		_setup = p_other._setup;
		_bounds = p_other._bounds;
	}
	// Puts every blade to rest at once. The next simulator has no slots.
	void rest();

	// Sets the params for the next step. Ignores their method: the field keeps the one that it was made with.
	void set_params(const FieldParams &p_params);
	void set_tint(float p_tint) { _setup.clump.tint = p_tint; } // of the clumps: only the picture has it
	// Changes the number of tiles that may be awake. Awake ones keep their blades; if there are too many, the calmest come to rest.
	void set_pool_size(Simulator &r_simulator, int p_slots);
	// Applies the params to the tiles; blades at rest may move.
	void stir();
	// Must be called when the map has changed under these tiles.
	void regrow(const TileRange &p_tiles);
	// Returns the tiles that set() or regrow() may have changed since the last call.
	TileRange take_changed_tiles() { return std::exchange(_changed_tiles, {}); }

	// Sets the views of a frame's cameras. If no picture of its world is shown, the field of a visible node counts as seen: scripts and
	// tests observe such a world in ways that are unknown here. r_simulator poses the blades that join the simulated ones because an eye
	// has come nearer.
	void see(Simulator &r_simulator, const FieldView &p_view, bool p_is_visible);
	// Simulates all blades of these tiles for a while, since a script reads them.
	void ask(Simulator &r_simulator, std::span<const int> p_tiles);
	bool is_seen() const { return _is_seen; } // or one of its shadows

	// Begins a tick of p_delta seconds. Returns false if nobody could notice its effect: then the rest of it is skipped.
	bool begin_tick(Simulator &r_simulator, bool p_is_listened, double p_delta);
	// Returns true while slots exist: ticks must go on, so that they are freed.
	bool holds_slots() const { return _room > 0 || _tiles.get_room() > 0 || _tiles.get_room_plan().get_wanted() > 0; }
	// Returns true once after skipped ticks: bodies have moved meanwhile, and must not sweep the grass on their way.
	bool resume();
	// Wakes tiles, moves blades, puts tiles to sleep. Returns true if blades moved. p_forces: at most GRASS_MAX_FORCES, whose shapes are
	// among the colliders.
	bool tick(Simulator &r_simulator, std::span<ColliderShape> p_colliders, double p_delta, std::span<const Force> p_forces = {},
			const ParallelFor &p_parallel_for = serial_for);

	const FieldSetup &get_setup() const { return _setup; }
	const TileGrid &get_grid() const { return _setup.grid; }
	const TileManager &get_tiles() const { return _tiles; }
	const FieldBlades &get_blades() const { return _blades; }
	const TileBounds *get_bounds() const { return _bounds.get(); }
	const TileCover *get_cover() const { return _map != nullptr ? _map->get_cover().get() : nullptr; }
	const MapLayers *get_layers() const { return _map; } // null: no map
	const SpeciesPatches &get_species() const { return _species; }
	double ground_relief() const; // metres that the ground rises above or falls below the field
	double ground_range() const; // metres from the lowest ground to the highest
	int64_t get_unseen_ticks() const { return _unseen_ticks; } // number of skipped ticks
	// Returns how many times coarser blades are simulated than drawn, to keep within the budget; 1: every drawn blade is.
	float get_coarseness() const { return _tiles.get_detail().get_coarseness(); }
	// Returns true if there is a budget, but so many steps have brought no time that the device seems to have no timestamps.
	bool is_budget_blind() const { return _untimed_steps >= MOST_UNTIMED; }
	double get_tiles_ms() const { return _tiles_ms; } // CPU time of choosing tiles, in the last tick

	// Returns the boxes of the tiles of a field that follows this one.
	std::shared_ptr<TileBounds> bounds_of(const FieldSetup &p_next) const;
	// Returns the knots of a blade in field space. p_simulated: from Backend::find_knots(); without any, the blade is at rest.
	KnotsOf<double> find_knots(BladeNumber p_blade, const SimulatedKnots &p_simulated) const;
	// Returns where a blade leaves the ground, in field space.
	Eigen::Vector3d get_root(const FieldBlades::Pose &p_pose, int p_tile_x, int p_tile_z) const {
		return root_of(p_pose.root, p_tile_x, p_tile_z) + Eigen::Vector3d(0.0, p_pose.ground, 0.0);
	}
	// Returns the tiles in which blades within p_radius of a place may grow.
	TileRange tiles_around(const Eigen::Vector2d &p_place, double p_radius) const;
	// Returns the blades that grow up to p_radius metres from a place, in ascending order.
	std::vector<BladeNumber> find_blades(const Eigen::Vector2d &p_place, double p_radius) const;

private:
	PoolDemand find_demand() override { return _tiles.find_demand(); }
	void fit_pool(Simulator &r_simulator, std::span<const SlotMove> p_moves = {});
	void prepare_pool(Simulator &r_simulator);
	TileParams tile_params() const;
	TileRange all_tiles() const { return { 0, _setup.grid.get_tiles_x(), 0, _setup.grid.get_tiles_z() }; }
	std::span<const SlotGrowth> grow_tiles();
	void see_tiles(const FieldView &p_view, bool p_is_visible);
	bool has_budget() const { return _params.budget > 0.0 && _params.detail == SimulationDetail::SEEN; }
	void spend_budget(Simulator &r_simulator);
	bool see_detail(Simulator &r_simulator, const FieldView &p_view);
	void widen(Simulator &r_simulator);
	void step(Simulator &r_simulator, double p_delta, std::span<const Force> p_forces);
	Eigen::Vector3d root_of(const Eigen::Vector2f &p_root, int p_x, int p_z) const;

	FieldSetup _setup;
	FieldParams _params;
	std::shared_ptr<TileBounds> _bounds;
	const MapLayers *_map = nullptr;
	SpeciesPatches _species;
	FieldBlades _blades;
	TileManager _tiles;
	std::shared_ptr<PoolBudget> _pool_budget;
	int _room = 0; // slots that the simulator has
	StepClock _clock;
	static constexpr int MOST_UNTIMED = 240;
	SimulationBudget _budget;
	uint64_t _times_read = 0; // of StepTime::count
	int _untimed_steps = 0; // while there is a budget, without a time of any
	GrassStep _step; // of the last tick that moved blades
	std::vector<GrassStep> _species_steps; // of this tick
	std::vector<GrassForce> _forces; // of this tick
	std::vector<SlotGrowth> _growth; // of this tick
	TileRange _changed_tiles; // of take_changed_tiles()
	TileRange _regrown; // tiles below which the map changed since the last tick
	bool _is_seen = true; // in the last frame; always true if no frames are drawn
	bool _can_simulate = false; // in this tick
	double _unseen_time = 0.0; // seconds of skipped ticks since the last one that was not skipped
	int64_t _unseen_ticks = 0;
	double _tiles_ms = 0.0;
};

} // namespace grass

// SPDX-License-Identifier: MIT
// Chooses the plants that get a node: those nearest to the eyes, within a budget. Looks at tiles from each eye outwards, ring by ring, a
// few in each call, so that its cost depends neither on the size of the field nor on how fast eyes move. docs/internals/species.md,
// "Plants with a scene".
#pragma once

#include "core/field/field.h"
#include "core/field/knots.h"

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

namespace grass {

// Number of plants of a field that have a node at once. More: the physics server and the scene tree have more to do.
inline constexpr Tunable PLANT_NODES_MAX{ "plant_nodes_max", "", 0.0, 1024.0, 1.0, 64.0, true };

// Somebody for whom plants must exist.
struct PlantEye {
	Eigen::Vector3d place; // field space, metres
	double reach = 0.0; // metres; no plant farther away matters
	bool operator==(const PlantEye &) const = default;
};

// A plant that is neither mown nor thinned out: all stems with one root.
struct StandingScene {
	BladeNumber blade = 0; // its first such stem
	int species = 0;
	Eigen::Vector3d root = Eigen::Vector3d::Zero(); // field space, metres
	float angle = 0.0f, length = 0.0f; // of that stem: FieldBlades::Standing
	bool operator==(const StandingScene &) const = default;
};

class PlantSearch {
public:
	// A plant counts while this share of its stem is left, neither mown nor thinned out.
	static constexpr float STANDS = 0.5f;
	// How much farther away a plant with a node may be than one without: as a share of the distance, and at least, in metres.
	static constexpr double KEEP_SHARE = 0.1, KEEP_LEAST = 0.5;

	struct Params {
		std::array<float, GRASS_MAX_SPECIES> distance{}; // metres; 0: plants of the species get no node
		int most = 0; // plants that are chosen at once
		FieldBlades::Border border;
		bool operator==(const Params &) const = default;
	};

	// Must be called when these tiles of the field may have changed.
	void forget(const TileRange &p_tiles);
	void clear();
	// Looks at some tiles, and chooses. p_held: the plants that have a node. The result is valid until the next call: the nearest first.
	std::span<const StandingScene> choose(
			const Field &p_field, std::span<const PlantEye> p_eyes, const Params &p_params, std::span<const StandingScene> p_held);
	// Returns false while an eye has not seen all that it reaches.
	bool is_done() const;

	int64_t get_stems_looked_at() const { return _stems; } // blades whose species was found out, so far
	int64_t get_tiles_looked_at() const { return _visits; } // steps of all walks so far, tiles outside of the field too
	size_t get_memory_usage() const; // bytes

private:
	using Plants = std::vector<StandingScene>;
	struct Near {
		double distance;
		StandingScene plant;
	};
	// What an eye has found, and how far its walk has come.
	struct Walk {
		PlantEye eye; // that the walk began with
		bool is_done = false;
		bool is_outdated = false; // tiles changed after it began: another walk must follow
		TilePlace tile;
		double reach = 0.0; // on the ground, metres
		int ring = 0, step = 0; // the next tile
		std::vector<Near> found; // of this walk
		std::vector<Near> nearest; // of the last walk until this one is done
	};

	void begin(Walk &r_walk, const Field &p_field, const PlantEye &p_eye) const;
	bool walk(Walk &r_walk, const Field &p_field);
	bool visit(Walk &r_walk, const Field &p_field, int p_x, int p_z);
	void finish(Walk &r_walk) const;
	const Plants *find(const Field &p_field, int p_x, int p_z);
	void read(const Field &p_field, int p_x, int p_z, Plants &r_plants);
	void drop_far();
	void rank(const Field &p_field, std::span<const PlantEye> p_eyes, std::span<const StandingScene> p_held);
	double distance_to(const StandingScene &p_plant, std::span<const PlantEye> p_eyes, double p_more) const;

	TileGrid _grid; // of the field
	Params _params;
	std::unordered_map<int, Plants> _known; // by tile; only looked up, so its order does not matter
	std::vector<Walk> _walks; // of the eyes
	size_t _next = 0; // the walk that goes on first
	int _steps = 0, _reads = 0; // left in this call
	bool _is_stale = true; // the choice may differ from the last one
	std::vector<StandingScene> _chosen;
	int64_t _stems = 0, _visits = 0;
};

} // namespace grass

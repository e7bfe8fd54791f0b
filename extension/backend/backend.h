// SPDX-License-Identifier: MIT
// What a field needs from whatever simulates and draws it. Two implementations: gpu/gpu_backend.h
// (Forward+, Mobile) and backend/cpu_backend.h (headless, Compatibility, and the oracle of the tests).
#pragma once

#include "core/base/tile_grid.h"
#include "core/blades/clump.h"
#include "core/blades/patch.h"
#include "core/detail/lod.h"
#include "core/map/tile_cover.h"
#include "core/plants/species.h"
#include "core/solver/solver_params.h"
#include "core/solver/step.h"

#include <Eigen/Core>

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <vector>

namespace grass {

// What a backend is built for.
struct FieldSetup {
	TileGrid grid;
	std::shared_ptr<const Patch> patch;
	ClumpParams clump;
	int pool_tiles = 0; // tiles that may be awake at once
	int drawn_tiles_max = int(DRAWN_TILES_MAX.initial);
	uint32_t seed = 0;
	bool is_mapped = false; // a map says what grows where
	float follow_slope = 0.0f; // FOLLOW_SLOPE
	std::shared_ptr<const SpeciesMix> species; // null: one, and nothing that has to do with species costs anything

	Method method = Method::DIRECT; // that it begins with

	float card_size = 0.0f; // farthest that a card reaches from its tip, metres; 0: no species has one

	// Whether the meshes of the one fit the other, as long as the MultiMeshes are large enough.
	bool has_meshes_of(const FieldSetup &p_other) const {
		return drawn_tiles_max == p_other.drawn_tiles_max && (card_size > 0.0f) == (p_other.card_size > 0.0f);
	}
	// Tiles that the MultiMeshes of picture and shadows have room for: powers of two, so that a field that grows finds room at most times.
	int instance_capacity() const { return capacity(uint64_t(drawn_tiles_max)); }
	int shadow_capacity() const { return capacity(uint64_t(drawn_tiles_max) / 4); }
	// Of the longest blade at rest, grown by its clump: length, height above the root, horizontal reach; the latter two with its card.
	// Metres.
	float blade_length() const { return patch->max_length * CLUMP_TALLEST; }
	float blade_height() const { return std::min(patch->max_height * CLUMP_TALLEST + blade_lean(), blade_length()) + card_size; }
	float blade_reach() const { return std::min(patch->max_reach * CLUMP_TALLEST + blade_lean(), blade_length()) + card_size; }
	// Of the mean blade.
	BladeSize blade_size() const { return { patch->mean_width, patch->mean_length }; }

private:
	int capacity(uint64_t p_most) const { return int(std::min(std::bit_ceil(uint64_t(grid.get_tile_count())), p_most)); }
	// How far a clump's lean, and the slope that blades follow, moves a tip, at most: the chord of the angle whose half has
	// that tangent, on both axes.
	float blade_lean() const {
		return (2.0f * 1.4143f * float(GRASS_CLUMP_LEAN) + (is_mapped ? slope_lean(follow_slope) : 0.0f)) * blade_length();
	}
};

// A camera that sees the field. Field space, metres.
struct ViewCamera {
	Frustum planes = {}; // n.x <= d inside
	Eigen::Vector3f eye = Eigen::Vector3f::Zero();
	float near = 0.05f; // distance of its near plane
	float pixel = 0.0f, pixel_slope = 0.0f; // metres in a pixel at a distance: pixel + pixel_slope * distance

	float pixel_at(float p_distance) const { return pixel + pixel_slope * p_distance; }
	bool operator==(const ViewCamera &) const = default;
};

// From where, and how finely, the field is drawn in a frame. Field space, metres.
struct FieldView {
	std::vector<ViewCamera> cameras; // all whose picture this frame shows
	LodParams lod;
	float shadow_distance = 0.0f; // tiles farther from every camera cast no shadow; 0: none does
	float shadow_margin = 0.0f; // how far outside of a frustum a tile still casts its shadow, whatever the light
	std::vector<Eigen::Vector3f> falls; // of each directional light: from the tallest tip to where its shadow ends

	bool operator==(const FieldView &) const = default;
};

// What a backend did; counts since it was made, unless said otherwise.
struct BackendStatistics {
	int64_t steps = 0; // simulation dispatches (GPU) or passes over the awake tiles (CPU)
	int64_t simulated_blades = 0; // blades stepped
	int64_t edge_tile_steps = 0; // GPU: steps of tiles with a collider that blades' edges must meet
	int64_t free_tile_steps = 0; // GPU: steps of tiles without a collider
	int64_t compiling = 0; // GPU: passes that the driver is still compiling: until then sharp colliders are met with knots only,
						   // free tiles by whole solves; after a change of method all by the one before
	int64_t uploaded_bytes = 0; // GPU: travelled to the device
	int64_t buffer_bytes = 0; // now: of the buffers and textures on the device, patch and MultiMesh excepted
	int64_t culls = 0; // culling passes
	int64_t instance_updates = 0; // times that the renderer was told anything of the node: place, world, visibility, layers
	// In the newest frame known (GPU: about two frames late): tiles of each level, blades in the picture and in shadows.
	std::array<int64_t, GRASS_ALL_LEVELS> drawn_tiles{};
	int64_t drawn_blades = 0, shadow_blades = 0;
	std::array<int64_t, 2> left_out_tiles{}; // that had no room in the MultiMeshes of picture and shadows
	double upload_ms = 0.0; // CPU time of handing a step's records to the GPU: copies, uploads, recording the pass
	double simulate_ms = 0.0, cull_ms = 0.0; // of one step, of one cull: GPU timestamps, or CPU time; 0 until known
};

class Backend {
public:
	virtual ~Backend() = default;

	// Gets ready for a field that has what this one has not yet: makes its shaders and passes, one a call at most. Whether all are there.
	virtual bool prepare(const FieldSetup &p_setup) = 0;
	// Goes on with another field, all of its blades at rest; with a map, set_cover() follows. False if it cannot: then make another
	// backend.
	virtual bool set_field(const FieldSetup &p_setup) = 0;
	// Whether step() can do its work: the driver may still compile the pass. Until then all blades stand at rest, and nobody calls step().
	virtual bool can_simulate() { return true; }
	// The method to simulate by from now on: p_wanted, as soon as all of its passes are there.
	virtual Method choose_method(Method p_wanted) { return p_wanted; }
	// Whether blades are simulated as they always will be: no pass is being compiled that another one stands in for.
	virtual bool is_complete() const { return true; }
	// Simulates the awake tiles for one tick. p_input is read before the call returns.
	virtual void step(const StepInput &p_input) = 0;
	// In every tick, whether there is a step or not: gives back memory that nothing has needed for a while.
	virtual void tidy() {}
	// Chooses what is drawn in this frame.
	virtual void draw(const FieldView &p_view) = 0;
	// Follows the node's transform (orthonormal), world, visibility, layers, shadows.
	virtual void follow(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform) = 0;
	// Of fields with a map: what it says about the tiles, of which those in p_changed may differ from the last call.
	virtual void set_cover(const std::shared_ptr<const TileCover> &p_cover, const TileRange &p_changed) = 0;
	// Sets a uniform of the blade shader.
	virtual void set_uniform(const godot::StringName &p_name, const godot::Variant &p_value) = 0;

	// Whether BackendStatistics' times are taken: it costs a little on the GPU.
	virtual void set_measure_time(bool p_measure) = 0;

	// Knots of p_count blades of an awake tile from p_blade on, blade space, metres: GRASS_KNOTS points each. Waits for the GPU: for
	// tests and tools.
	virtual std::vector<Eigen::Vector3f> read_knots(int p_slot, int p_blade, int p_count) = 0;
	// The newest that is known, without waiting; holds until the next call.
	virtual EnergyReport read_energy() = 0;
	virtual BackendStatistics get_statistics() = 0;
	virtual int64_t get_memory_usage() const = 0; // bytes, all of the field's own buffers and textures
	virtual const char *get_name() const = 0;
};

} // namespace grass

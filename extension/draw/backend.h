// SPDX-License-Identifier: MIT
// The interface of the code that simulates and draws a field. Two implementations: gpu/gpu_backend.h (Forward+, Mobile) and
// cpu/cpu_backend.h (headless, Compatibility, and the reference in tests).
#pragma once

#include "core/field/backend_statistics.h"
#include "core/field/field_setup.h"
#include "core/field/knots.h"
#include "core/field/simulator.h"
#include "core/lod/plant_cull.h"
#include "core/lod/view.h"
#include "core/map/tile_cover.h"
#include "draw/drawn_plant.h"
#include "draw/map_textures.h"
#include "draw/shared_shader.h"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace grass {

// The memory of a field's own buffers and textures, in bytes.
struct BackendMemory {
	int64_t all = 0;
	int64_t shared = 0; // of that, with other fields of the same patch
	int64_t pool = 0; // of that, what the pool uses now
	int64_t pool_tile = 0; // what each tile of a larger pool takes: at once, or on the CPU once it is awake
};

class Backend : public Simulator {
public:
	// Prepares the passes that a field needs and this backend does not have yet. Returns whether all are ready.
	virtual bool prepare(const FieldSetup &p_setup) = 0;
	// Switches to another field, with all of its blades at rest; if it has a map, set_cover() must follow. Returns false if that is
	// impossible: make another backend then.
	virtual bool set_field(const FieldSetup &p_setup) = 0;
	// Returns whether the backend can never work, since the driver has rejected a pass.
	virtual bool is_refused() const { return false; }
	// Chooses what this frame draws.
	virtual void draw(const FieldView &p_view) = 0;
	// Shows the blades between two steps. Must be called in each rendered frame, before show_motion(). p_is_between: whether the engine
	// draws bodies, and so the blades that they bend, between two ticks; p_share: share of the last step, 0..1; the rest is the state
	// before that step.
	virtual void show_between(bool p_is_between, float p_share) = 0;
	// Makes motion vectors right. Must be called in each rendered frame, before follow(). p_is_read: whether anything reads motion vectors;
	// p_has_blown: whether the wind's clock has advanced since the last frame. The engine calls vertex() a second time with the
	// MODEL_MATRIX of the frame before, and a shader cannot distinguish the calls otherwise. So in frames in which blades move, the
	// instance of the picture flips y over, or back, and the shader reverses that. Without vectors, which is the default, moving blades
	// blur.
	virtual void show_motion([[maybe_unused]] bool p_is_read, [[maybe_unused]] bool p_has_blown) {}
	// Follows the node: p_transform (orthonormal), its world, visibility, layers and shadows.
	virtual void follow(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform) = 0;
	// Sets the cover of the tiles, in fields with a map. Tiles in p_changed may differ from the last call.
	virtual void set_cover(const std::shared_ptr<const TileCover> &p_cover, const TileRange &p_changed) = 0;
	// Sets the meshes of the field's species, after the field was made; its uniforms must be set again. p_plants_of: see
	// PlantCull::choose(); it must stay valid as long as the field exists.
	virtual void set_plants(const std::vector<DrawnPlant> &p_plants, const PlantCull::PlantsOf &p_plants_of) = 0;
	// Binds what shaders and passes read of the field's map. Must be called after set_plants(), and whenever that changes.
	virtual void set_map(const MapBinding &p_map) {
		p_map.set_uniforms([this](const godot::StringName &p_name, const godot::Variant &p_value) { set_uniform(p_name, p_value); });
	}
	// Sets a uniform of the shaders of blades and plants.
	virtual void set_uniform(const godot::StringName &p_name, const godot::Variant &p_value) = 0;
	// Draws blades with p_look's shaders, which must be ready (prepare_shaders()). Nothing is drawn before the first call.
	virtual void set_look(const Look &p_look) = 0;

	// Sets whether to measure the times in BackendStatistics, which costs a little on the GPU.
	virtual void set_measure_time(bool p_measure) = 0;

	using SlotOf = std::function<int(int)>; // returns the slot of a tile; GRASS_NO_SLOT: it is at rest

	// Returns where these blades are, one answer for each, without waiting. Answers are at most two frames old. They are unknown until
	// read_asked() has run after the first call with a blade.
	virtual std::vector<SimulatedKnots> find_knots(std::span<const WantedBlade> p_blades) = 0;
	// Returns where they are after the last step. Waits for the GPU.
	virtual std::vector<SimulatedKnots> wait_for_knots(std::span<const WantedBlade> p_blades) = 0;
	// Requests from the GPU what find_knots() returns later. Must be called once in each frame, after its ticks.
	virtual void read_asked(const SlotOf &p_slot_of) { (void)p_slot_of; }
	// Returns a hash of where all simulated blades are after the last step, bit for bit; 0: unknown, since they are on a GPU.
	virtual uint64_t hash_blades() const { return 0; }
	virtual BackendStatistics get_statistics() = 0;
	virtual BackendMemory get_memory() const = 0;
	virtual const char *get_name() const = 0;
};

} // namespace grass

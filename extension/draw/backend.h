// SPDX-License-Identifier: MIT
// What a field needs of the code that simulates and draws it. Two implementations: gpu/gpu_backend.h
// (Forward+, Mobile) and cpu/cpu_backend.h (headless, Compatibility, and the oracle of the tests).
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

class Backend : public Simulator {
public:
	// Prepares a field that needs passes which this one lacks. Returns whether all are ready.
	virtual bool prepare(const FieldSetup &p_setup) = 0;
	// Goes on with another field, all of its blades at rest; with a map, set_cover() follows. False if it cannot: make another
	// backend then.
	virtual bool set_field(const FieldSetup &p_setup) = 0;
	// Whether it can never do its work, since the driver has refused a pass.
	virtual bool is_refused() const { return false; }
	// Chooses what is drawn in this frame.
	virtual void draw(const FieldView &p_view) = 0;
	// Before show_motion(), in each frame that is drawn. p_is_between: whether the engine draws bodies between two ticks, and so the blades
	// that they bend; p_share: of the last step, 0..1; the rest is the step's before.
	virtual void show_between(bool p_is_between, float p_share) = 0;
	// Before follow(), in each frame that is drawn. p_is_read: whether somebody reads motion vectors; p_has_blown: whether the wind's clock
	// ran since the last frame. The engine calls vertex() once more with the MODEL_MATRIX of the frame before, and nothing else lets a
	// shader know which call it is: so in frames in which blades move the instance of the picture turns y over, or back, and the
	// shader turns it back. Without vectors (default): blades blur where they move.
	virtual void show_motion(bool p_is_read, bool p_has_blown) {
		(void)p_is_read;
		(void)p_has_blown;
	}
	// Follows the node's transform (orthonormal), world, visibility, layers, shadows.
	virtual void follow(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform) = 0;
	// For fields with a map: the cover of the tiles. Those in p_changed may differ from the last call.
	virtual void set_cover(const std::shared_ptr<const TileCover> &p_cover, const TileRange &p_changed) = 0;
	// The meshes of the field's species, after it was made: uniforms follow. p_plants_of: as PlantCull::choose() takes it; it must hold as
	// long as the field.
	virtual void set_plants(const std::vector<DrawnPlant> &p_plants, const PlantCull::PlantsOf &p_plants_of) = 0;
	// Binds what shaders and passes read of the field's map, after set_plants() and whenever that is something else.
	virtual void set_map(const MapBinding &p_map) {
		p_map.set_uniforms([this](const char *p_name, const godot::Variant &p_value) { set_uniform(p_name, p_value); });
	}
	// Sets a uniform of the shaders of blades and plants.
	virtual void set_uniform(const godot::StringName &p_name, const godot::Variant &p_value) = 0;
	// Draws blades with p_look's shaders, which are ready (prepare_shaders()). Before the first call nothing is drawn.
	virtual void set_look(const Look &p_look) = 0;

	// Whether to measure BackendStatistics' times, which costs a little on the GPU.
	virtual void set_measure_time(bool p_measure) = 0;

	using SlotOf = std::function<int(int)>; // of a tile; GRASS_NO_SLOT: it is at rest

	// Where these blades are, one answer a blade, without waiting: as they were two frames ago at most, if read_asked() ran since
	// the first call with this blade; before that nothing is known.
	virtual std::vector<SimulatedKnots> find_knots(std::span<const WantedBlade> p_blades) = 0;
	// Where they are after the last step. Waits for the GPU.
	virtual std::vector<SimulatedKnots> wait_for_knots(std::span<const WantedBlade> p_blades) = 0;
	// Once a frame, after its ticks: requests from the device what find_knots() returns later.
	virtual void read_asked(const SlotOf &p_slot_of) { (void)p_slot_of; }
	virtual BackendStatistics get_statistics() = 0;
	virtual int64_t get_memory_usage() const = 0; // bytes, all of the field's own buffers and textures
	virtual int64_t get_shared_memory() const = 0; // what of that other fields of the same patch have as well
	virtual int64_t get_pool_memory() const = 0; // what of that is the pool, now
	virtual int64_t get_pool_tile_memory() const = 0; // bytes a tile of the pool needs, used or not
	virtual const char *get_name() const = 0;
};

} // namespace grass

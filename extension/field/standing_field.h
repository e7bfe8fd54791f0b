// SPDX-License-Identifier: MIT
// The field that runs at present: its blades, the map that it shows, its backend and its picture.
// field/field_life.h prepares the next one. This class prints nothing: it returns what the node must report.
#pragma once

#include "core/field/field.h"
#include "core/field/field_statistics.h"
#include "draw/backend.h"
#include "draw/patch_texture.h"
#include "field/field_picture.h"
#include "field/field_properties.h"
#include "field/project_pool.h"
#include "field/shown_map.h"
#include "field/wanted_field.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace grass {

// The memory used by a field, including its map.
struct FieldMemory : BackendMemory {
	const void *patch = nullptr; // only for comparison; null: there is no field
};

class StandingField {
public:
	// p_properties: the node's. They may differ from this field until it is made again.
	explicit StandingField(const FieldProperties &p_properties) : _parts(p_properties) {}

	// Becomes p_wanted, with all of it at rest. Keeps the buffers, MultiMeshes and materials that still fit. show() must be called next.
	// With p_in_parts, show() makes a new backend.
	void make(WantedField &&p_wanted, bool p_in_parts);
	// Draws the field with the properties' hook as soon as the shaders are ready. Returns false if they do not compile with it.
	bool show(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform);
	// Stops simulating and drawing until the field is made again.
	void drop_backend();
	// Does the same, and drops the map too.
	void clear();
	// Returns true if the driver has refused a pass of the field that runs on it.
	bool is_refused() const { return _parts.backend != nullptr && _parts.backend->is_refused(); }
	// Puts all blades to rest; show() makes another backend, which is the CPU's after a refusal.
	void leave_device();
	bool stands() const { return _parts.backend != nullptr; }

	// Updates what a field reads from the properties without being made again.
	void update_params();
	void update_measuring();
	// Continues the gusts of another field with the same blades. Must be called before this field is made for the first time.
	void join(const StandingField &p_other) {
		_picture.join(p_other._picture);
		_parts.field.join(p_other._parts.field);
	}
	// Scales what the shaders know, and the pool, by another level of quality. Nothing is made again.
	void update_quality();
	void update_tint(); // of the clumps
	void fit_pool(); // to the properties, without putting its blades to rest
	// Updates the species' colours and frequencies. Returns false if the change requires making the field again.
	bool update_species();

	// Takes over the map's changes since the last call: a few chunks at once, more as frames have time. Returns false if the map has more
	// painted chunks under the field than the field can show.
	bool update_map();
	bool is_map_waiting() const { return _parts.map && (_parts.map->get_waiting() > 0 || _parts.map->is_growing()); } // see update_map()
	TileRange take_changed_tiles() { return _parts.field.take_changed_tiles(); }
	ShownMap *get_map() const { return _parts.map.get(); } // null: none
	// Returns the map's current layers at a place, whether or not the field shows them already. The result is valid until the next call;
	// null without a map.
	const MapLayers *layers_at(const Eigen::Vector2f &p_place) const;

	// Sets whether to show and simulate everything, as a server does, whatever cameras see, and to take over changes of the map at once.
	void set_whole(bool p_is_whole) { _is_whole = p_is_whole; }
	// Sets how many tiles may be awake and, if it is not null, what ticks read of the properties, as a record has them.
	void replay(int p_slots, const FieldParams *p_new);
	FieldParams find_params() const; // as the properties have them
	uint64_t hash_blades() const { return stands() ? _parts.backend->hash_blades() : 0; } // 0: unknown

	// Begins a tick; tick() then applies the bodies' motion. See Field.
	bool begin_tick(bool p_is_listened, double p_delta);
	bool resume() { return _parts.field.resume(); }
	// Simulates a tick. Returns true if blades moved. p_params: of find_params().
	bool tick(const FieldParams &p_params, std::span<ColliderShape> p_colliders, std::span<const Force> p_forces, double p_delta,
			const ParallelFor &p_parallel_for);
	// Must be called in each frame before FieldPicture::show_motion(). See Backend.
	void show_between(bool p_is_between, float p_share) { _parts.backend->show_between(p_is_between, p_share); }
	// Simulates these blades, even if no camera needs them, for a while.
	void ask(std::span<const BladeNumber> p_blades);
	void read_asked(); // reads the blades that scripts query
	// Draws a frame. p_is_visible: the node is visible. Returns true once after the field was made, as soon as more tiles are in view than
	// it has room for.
	bool draw(const FieldView &p_view, bool p_is_visible);
	bool is_crowded() const { return _is_crowded; }
	// Return whether `simulation_budget` does nothing since the device measures no times; the second once, as soon as this is known.
	bool is_budget_blind() const { return stands() && _parts.field.is_budget_blind(); }
	bool notice_blind_budget() { return !std::exchange(_was_blind, is_budget_blind()) && _was_blind; }

	bool holds_slots() const { return _parts.field.holds_slots(); } // awake tiles, or memory that ticks free

	FieldPicture &get_picture() { return _picture; }
	const FieldPicture &get_picture() const { return _picture; }
	const Field &get_field() const { return _parts.field; }
	Backend *get_backend() const { return _parts.backend.get(); } // null: there is no field
	const std::vector<GrownSpecies> &get_species() const { return _parts.species; }
	// Return, before there is a field, the value of the one that the properties describe.
	TileGrid get_grid() const { return stands() ? _parts.field.get_grid() : _parts.properties.grid(); }
	godot::AABB get_bounds() const;
	void measure_time(); // starts measuring, whatever the property says
	int64_t get_memory_usage() const; // bytes
	DrawnStatistics count_drawn() const; // only while there is a field
	void add_to(FieldStatistics &r_statistics) const;

private:
	void make_backend();
	bool leaves_tiles_out() const;

	StandingParts _parts;
	FieldPicture _picture{ _parts };
	mutable MapLayers _layers_there; // of layers_at(): around one place
	bool _is_crowded = false; // more tiles were seen, since the field was made, than it has room for
	bool _was_blind = false; // of notice_blind_budget()
	bool _is_whole = false; // see set_whole()
	bool _is_measured = false; // something reads the monitors of times
	int64_t _builds = 0; // backends made
};

} // namespace grass

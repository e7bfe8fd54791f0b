// SPDX-License-Identifier: MIT
// The field that runs at present: its blades, the map that it shows, its backend, its ground and the shaders' uniforms.
// field/field_life.h prepares the next one. This class prints nothing: it returns what the node must report.
#pragma once

#include "core/field/field.h"
#include "core/field/field_statistics.h"
#include "draw/backend.h"
#include "draw/ground.h"
#include "draw/patch_texture.h"
#include "field/field_properties.h"
#include "field/field_uniforms.h"
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
	explicit StandingField(const FieldProperties &p_properties) : _properties(p_properties), _field(project_pool()) {}

	// Lets worker threads prepare the passes of a first field, while the main thread makes the rest.
	void begin_passes() const;
	// Becomes p_wanted, with all of it at rest. Keeps the buffers, MultiMeshes and materials that still fit. show() must be called next.
	// With p_in_parts, show() makes a new backend.
	void make(WantedField &&p_wanted, bool p_in_parts);
	// Returns true while the drawn field does not match the properties yet; call show() in each frame then.
	bool is_look_waiting() const { return _part != Part::NOTHING && (_part != Part::ALL || _look != find_look()); }
	// Draws the field with the properties' hook as soon as the shaders are ready. Returns false if they do not compile with it.
	bool show(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform);
	// Stops simulating and drawing until the field is made again.
	void drop_backend();
	// Does the same, and drops the map too.
	void clear();
	// Returns true if the driver has refused a pass of the field that runs on it.
	bool is_refused() const { return _backend != nullptr && _backend->is_refused(); }
	// Puts all blades to rest; show() makes another backend, which is the CPU's after a refusal.
	void leave_device();
	// Returns the warning that the driver refused a pass, so that the CPU runs the field; empty: it refused none.
	godot::String refusal_warning() const;
	// Appends warnings: why the field cannot use the graphics device, or is smaller there than its properties.
	void warn_of_device(godot::PackedStringArray &r_warnings) const;
	bool stands() const { return _backend != nullptr; }
	bool is_shown() const { return _part == Part::ALL; } // all of it: a streamed field comes in parts while it is hidden

	// Updates what a field reads from the properties without being made again.
	void update_params();
	void update_measuring();
	// Continues the gusts of another field with the same blades. Must be called before this field is made for the first time.
	void join(const StandingField &p_other) {
		_uniforms.join_wind(p_other._uniforms);
		_field.join(p_other._field);
	}
	// Scales what the shaders know, and the pool, by another level of quality. Nothing is made again.
	void update_quality();
	void update_tint(); // of the clumps
	void fit_pool(); // to the properties, without putting its blades to rest
	void update_wind() { _uniforms.set_wind(_properties, _set); }
	// Updates the species' colours and frequencies. Returns false if the change requires making the field again.
	bool update_species();
	void set_uniform(const godot::StringName &p_name, const godot::Variant &p_value); // of blades and ground
	// An idle editor, and a game in low processor mode, draw only after something in the rendering server has changed.
	void request_draw() { set_uniform("tile_size", _field.get_grid().get_tile_size()); }

	// Takes over the map's changes since the last call: a few chunks at once, more as frames have time. Returns false if the map has more
	// painted chunks under the field than the field can show.
	bool update_map();
	bool is_map_waiting() const { return _map && (_map->get_waiting() > 0 || _map->is_growing()); } // see update_map()
	TileRange take_changed_tiles() { return _field.take_changed_tiles(); }
	ShownMap *get_map() const { return _map.get(); } // null: none
	// Returns the map's current layers at a place, whether or not the field shows them already. The result is valid until the next call;
	// null without a map.
	const MapLayers *layers_at(const Eigen::Vector2f &p_place) const;

	// Begins a tick; tick() then applies the bodies' motion. See Field.
	bool begin_tick(bool p_is_listened, double p_delta);
	bool resume() { return _field.resume(); }
	// Returns true if blades moved.
	bool tick(std::span<ColliderShape> p_colliders, std::span<const Force> p_forces, double p_delta, const ParallelFor &p_parallel_for);
	// Must be called in each frame of a renderer that adds light in sRGB.
	void show_light(const godot::Vector4 &p_other) { _uniforms.set_light(p_other, _set); }
	void show_sun_map(const godot::Vector4 &p_map) { _uniforms.set_sun_map(p_map, _set); } // see find_sun_map(); in each frame
	// Advances the wind. Must be called in each frame before drawing begins.
	void blow(std::span<const Force> p_forces, double p_delta);
	// Must be called in each frame before show_motion(). See Backend.
	void show_between(bool p_is_between, float p_share) { _backend->show_between(p_is_between, p_share); }
	// Must be called in each frame once its cameras are known. p_is_read: something reads motion vectors; p_is_visible: the node is
	// visible.
	void show_motion(bool p_is_read) { _backend->show_motion(p_is_read, p_is_read && _uniforms.keep_wind_clock(_set_of_blades)); }
	void follow(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform);
	// Simulates these blades, even if no camera needs them, for a while.
	void ask(std::span<const BladeNumber> p_blades);
	void read_asked(); // reads the blades that scripts query
	// Returns true once after the field was made, as soon as more tiles are in view than it has room for.
	bool draw(const FieldView &p_view, bool p_is_visible);
	bool is_crowded() const { return _is_crowded; }
	godot::String crowded_warning() const;
	// Return whether `simulation_budget` does nothing since the device measures no times; the second once, as soon as this is known.
	bool is_budget_blind() const { return stands() && _field.is_budget_blind(); }
	bool notice_blind_budget() { return !std::exchange(_was_blind, is_budget_blind()) && _was_blind; }
	static godot::String blind_warning();

	bool holds_slots() const { return _field.holds_slots(); } // awake tiles, or memory that ticks free

	const Field &get_field() const { return _field; }
	Backend *get_backend() const { return _backend.get(); } // null: there is no field
	const std::vector<GrownSpecies> &get_species() const { return _species; }
	// Before there is a field, returns the value of the one that the properties describe.
	TileGrid get_grid() const { return stands() ? _field.get_grid() : _properties.grid(); }
	godot::AABB get_bounds() const;
	const SetUniform &setter() const { return _set; } // set_uniform()
	void measure_time(); // starts measuring, whatever the property says
	int64_t get_memory_usage() const; // bytes
	DrawnStatistics count_drawn() const; // only while there is a field
	void add_to(FieldStatistics &r_statistics) const;

private:
	bool wants_device() const; // whether the device is wanted and there is one
	godot::String obstacle_warning() const;
	void make_backend();
	bool has_ledges() const { return _map != nullptr && !_map->get_layers().get_ledge_layers().empty(); }
	Look find_look() const {
		return { shader_features(_field.get_setup()) | (has_ledges() ? SHADER_LEDGES : 0), _properties.hook.get_text() };
	}
	// What comes next of the field that was made, in this order. NOTHING: there is no field. ALL: it is shown.
	enum class Part { NOTHING, BACKEND, LOOK, GROUND, PLANTS, UNIFORMS, SPECIES, MAP, COVER, ALL };
	void show_parts(const Look &p_look, bool p_is_hidden);
	void show_part(const Look &p_look);
	void bind_map(bool p_all);
	void set_species_uniforms() {
		_uniforms.set_species(
				_field.get_setup(), _species, _plants, float(_properties.quality.factor(QUALITY_PLANT_DISTANCE)), _set, _set_of_blades);
	}
	void set_plants();
	bool leaves_tiles_out() const;

	const FieldProperties &_properties;
	Field _field;
	std::vector<GrownSpecies> _species;
	std::vector<DrawnPlant> _plants; // of the species
	std::unique_ptr<ShownMap> _map;
	mutable MapLayers _layers_there; // of layers_at(): around one place
	std::unique_ptr<Backend> _backend;
	Ground _ground;
	// Of blades and ground; of the blades alone, while there is a backend.
	const SetUniform _set{ [this](const godot::StringName &p_name, const godot::Variant &p_value) { set_uniform(p_name, p_value); } };
	const SetUniform _set_of_blades{ [this](const godot::StringName &p_name, const godot::Variant &p_value) {
		_backend->set_uniform(p_name, p_value);
	} };
	FieldUniforms _uniforms;
	Part _part = Part::NOTHING;
	int _rows_shown = 0; // of the cover
	Look _look; // that it is shown with
	bool _is_carried = false; // its ground is shown, and has the colour of the blades that are not
	bool _is_crowded = false; // more tiles were seen, since the field was made, than it has room for
	bool _was_blind = false; // of notice_blind_budget()
	bool _is_measured = false; // somebody reads the monitors of times
	int64_t _builds = 0; // backends made
	int64_t _wind_updates = 0; // frames that passed the wind's clock to the materials
};

} // namespace grass

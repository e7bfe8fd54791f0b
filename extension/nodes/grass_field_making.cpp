// SPDX-License-Identifier: MIT
// GrassField's wiring: what a change of properties, species, map or fill rule sets going.
#include "nodes/grass_field.h"

#include "backend/cpu_backend.h"
#include "convert.h"
#include "core/base/cpu_clock.h"
#include "draw/frame_share.h"
#include "gpu/gpu_backend.h"
#include "nodes/editor_hooks.h"
#include "nodes/main_thread.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

// Chunks of the map (64 m) that may change without waiting for anything: less than 1 ms each. More: frames stutter when a large brush is
// used. Less: what is painted with it comes in pieces.
constexpr int CHUNKS_AT_ONCE = 4;

} // namespace

void GrassField::request_rebuild() {
	_maker.request();
	update_gizmos();
	update_configuration_warnings();
}

void GrassField::build() {
	if (!_maker.is_waiting() || !is_inside_tree()) {
		return;
	}
	CpuClock clock;
	start_fill();
	if (_maker.prepare(_properties, _field, _backend.get())) {
		make();
	}
	_maker.add_time(clock.lap());
}

void GrassField::make() {
	_is_crowded = false;
	WantedField wanted = _maker.take();
	_field.set(wanted.setup, wanted.bounds, wanted.map ? &wanted.map->get_field() : nullptr, patches_of(wanted.species),
			_properties.field_params(wanted.species));
	_mix = std::move(wanted.mix);
	_species = std::move(wanted.species);
	_map = std::move(wanted.map);
	report_warnings();
	_ground.free();
	const FieldSetup &setup = _field.get_setup();
	if (setup.patch->is_empty() || !_backend || !_backend->set_field(setup)) {
		make_backend();
	}
	if (_backend) {
		_ground.create(setup.grid, setup.is_mapped);
		follow();
		_uniforms.set_all(_properties, setup, uniform_setter(true));
		set_wind_clock();
		_uniforms.set_species(setup, _species, uniform_setter(true), uniform_setter(false));
		show_map();
	}
}

// Once each, in the console; in the editor beside the node.
void GrassField::report_warnings() {
	if (Engine::get_singleton()->is_editor_hint()) {
		update_configuration_warnings();
		return;
	}
	const PackedStringArray warnings = _get_configuration_warnings();
	for (const String &warning : warnings) {
		if (!_warned_of.has(warning)) {
			WARN_PRINT(vformat("%s: %s", label(), warning));
		}
	}
	_warned_of = warnings;
}

void GrassField::make_backend() {
	_backend.reset();
	if (_field.get_setup().patch->is_empty()) {
		return;
	}
	const bool has_device = RenderingServer::get_singleton()->get_rendering_device() != nullptr;
	const FieldSetup &setup = _field.get_setup();
	if (has_device && !_properties.is_on_cpu) {
		_backend = std::make_unique<GpuBackend>(setup);
	} else {
		_backend = std::make_unique<CpuBackend>(setup);
	}
	_backend->set_measure_time(_properties.measure_time || _is_watched);
	_builds++;
}

// What a field that goes on as it is reads from the properties.
void GrassField::update_tiles() {
	if (_backend) { // else build() will
		_field.set_params(_properties.field_params(_species));
		_field.stir();
	}
}

void GrassField::set_uniform(const StringName &p_name, const Variant &p_value) {
	if (_backend) {
		_backend->set_uniform(p_name, p_value);
		_ground.set_uniform(p_name, p_value);
	}
}

// p_ground: of the ground, too, not of the blades alone.
FieldUniforms::Set GrassField::uniform_setter(bool p_ground) {
	return [this, p_ground](const char *p_name, const Variant &p_value) {
		if (p_ground) {
			set_uniform(p_name, p_value);
		} else {
			_backend->set_uniform(p_name, p_value);
		}
	};
}

// The ground has no wind.
void GrassField::set_wind_clock() {
	_uniforms.set_wind_clock(uniform_setter(false));
}

// An idle editor, and a game in low processor mode, draw only after something of the rendering server's has been set.
void GrassField::request_draw() {
	set_uniform("tile_size", _field.get_grid().get_tile_size());
}

void GrassField::set_species(const TypedArray<GrassSpecies> &p_species) {
	GRASS_MAIN_THREAD_ONLY();
	_properties.species.set(p_species, callable_mp(this, &GrassField::_species_changed));
	_has_own_species = false;
	request_rebuild();
}

// Colours and frequencies take effect at once; what changes blades makes the field anew.
void GrassField::_species_changed() {
	if (!is_main_thread()) { // a part of the resource changed on another one
		callable_mp(this, &GrassField::_species_changed).call_deferred();
		return;
	}
	const FieldSpecies &species = _properties.species;
	const FieldSetup &setup = _field.get_setup();
	if (_backend && !_maker.is_waiting() && species.prepare_patches() && species.is_joined() && species.find_mix() == _mix &&
			species.is_plain() == (setup.species == nullptr) && species.find_card_size() == setup.card_size) {
		_uniforms.set_species(_field.get_setup(), _species, uniform_setter(true), uniform_setter(false));
		update_tiles();
	} else {
		request_rebuild();
	}
}

void GrassField::set_map(const Ref<GrassMap> &p_map) {
	GRASS_MAIN_THREAD_ONLY();
	const Callable changed = callable_mp(this, &GrassField::_map_changed);
	if (_properties.map.is_valid()) {
		_properties.map->disconnect("chunks_changed", changed);
	}
	_properties.map = p_map;
	_recovery.reset();
	_filler.forget_map();
	if (_properties.map.is_valid()) {
		_properties.map->connect("chunks_changed", changed);
	}
	_is_map_bare = is_map_bare();
	request_rebuild();
}

// Nothing grows on it, nor will by a rule.
bool GrassField::is_map_bare() const {
	const Ref<GrassMap> &map = _properties.map;
	return map.is_valid() && map->is_readable() && !_filler.is_active() && map->get_base_density() == 0.0 &&
			!map->get_map().uses(MAP_DENSITY);
}

// The editor reads a node's warnings only when it is notified, and then draws its whole tree of nodes anew.
void GrassField::watch_bare_map() {
	if (_is_map_bare != is_map_bare()) {
		_is_map_bare = !_is_map_bare;
		update_configuration_warnings();
	}
}

// However often the map changes, it is read once, at the next tick or frame.
void GrassField::_map_changed(const TypedArray<Vector2i> &p_chunks, const Rect2 &p_region) {
	_filler.touch(_properties.map, p_chunks);
	watch_bare_map();
	const MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	for (ShownMap *map : shown_maps()) {
		if (map != nullptr && map->get_map() == _properties.map) {
			map->touch(region);
		}
	}
	request_draw();
}

// All of it, to a backend that has not seen it yet.
void GrassField::show_map() {
	if (!_map) {
		MapTextures::clear_uniforms(uniform_setter(true));
		return;
	}
	_map->set_uniforms(uniform_setter(true));
	const TileGrid &grid = _field.get_grid();
	_backend->set_cover(_map->get_field().get_cover(), { 0, grid.get_tiles_x(), 0, grid.get_tiles_z() });
}

// Takes over what changed in the map since the last call: a few chunks at once, more of them as frames have time.
void GrassField::update_map() {
	if (!_map || _map->get_waiting() == 0) {
		return;
	}
	const bool are_few = _map->get_waiting() <= CHUNKS_AT_ONCE;
	const FieldMap::Changes changes = _map->update([are_few] { return are_few || FrameShare::has_time(); });
	if (changes.tiles.count() == 0) {
		return;
	}
	_map->set_uniforms(uniform_setter(true));
	_backend->set_cover(_map->get_field().get_cover(), changes.tiles);
	_field.regrow(changes.tiles);
	if (_field.get_layers()->is_full()) {
		WARN_PRINT_ONCE(vformat(
				"%s: `map` has more painted chunks under the field than it can show (%d, about 8 km\u00b2); the rest stays bare. Use "
				"several smaller fields.",
				label(), GRASS_MAX_LAYERS));
	}
}

void GrassField::set_fill_rule(const Ref<GrassFillRule> &p_rule) {
	GRASS_MAIN_THREAD_ONLY();
	_filler.set_rule(p_rule, callable_mp(this, &GrassField::_fill_rule_changed), _properties.map);
	_fill_rule_changed();
	notify_property_list_changed();
}

void GrassField::set_fill_live(bool p_live) {
	GRASS_MAIN_THREAD_ONLY();
	_filler.set_live(p_live, _properties.map);
	update_configuration_warnings();
	notify_property_list_changed();
}

void GrassField::_fill_rule_changed() {
	if (!is_main_thread()) { // a part of the resource changed on another one
		callable_mp(this, &GrassField::_fill_rule_changed).call_deferred();
		return;
	}
	_filler.rule_changed();
	update_configuration_warnings();
}

FieldFiller::Place GrassField::fill_place() const {
	return { const_cast<GrassField *>(this), field_transform(), MapRegion::of_grid(_properties.grid()) };
}

// A field that comes into the tree is full from its first frame on; one that stands is filled piece by piece.
void GrassField::start_fill() {
	if (!_filler.is_active() || _filler.is_set()) {
		return;
	}
	if (_properties.map.is_null()) {
		make_map();
	}
	_filler.start(_properties.map, fill_place(), !_backend);
}

void GrassField::update_fill() {
	start_fill();
	if (_filler.is_set() && _filler.update(_properties.map, fill_place())) {
		emit_signal("fill_finished"); // last: who listens may change the field
	}
}

// The inspector's button.
void GrassField::_fill_pressed() {
	if (_filler.get_rule().is_valid() && is_inside_tree() && editor_hooks.fill != nullptr) {
		editor_hooks.fill(*this);
	}
}

Callable GrassField::get_fill_button() const {
	return callable_mp(const_cast<GrassField *>(this), &GrassField::_fill_pressed);
}

} // namespace grass

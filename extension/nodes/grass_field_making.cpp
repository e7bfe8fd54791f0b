// SPDX-License-Identifier: MIT
// GrassField's making: from properties to a field. One that enters the tree is made at once, so that its grass is there from the first
// tick on. One that stands goes on as it is until all that takes long has been made beside it: patches and passes by other threads,
// shaders and the map piece by piece, as frames have time for it (draw/frame_share.h).
#include "nodes/grass_field.h"

#include "backend/cpu_backend.h"
#include "core/base/cpu_clock.h"
#include "draw/frame_share.h"
#include "gpu/gpu_backend.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

// However many properties change, the field is made once, at the next tick or frame.
void GrassField::request_rebuild() {
	_dirty = true;
	_build_ms = 0.0;
	_wanted.reset();
	update_gizmos();
	update_configuration_warnings();
}

void GrassField::build() {
	if (!_dirty || !is_inside_tree()) {
		return;
	}
	CpuClock clock;
	start_fill();
	const bool in_parts = _backend != nullptr;
	if (prepare(in_parts) && (!in_parts || FrameShare::has_time())) {
		make();
	}
	_build_ms = std::max(_build_ms, clock.lap());
}

void GrassField::make() {
	_dirty = _is_crowded = false;
	take_wanted();
	_tiles.set_grid(_standing.setup.grid);
	_tiles.set_params(tile_params());
	_tiles.set_bounds(_standing.bounds);
	_tiles.reset();
	_clock.reset();
	if (Engine::get_singleton()->is_editor_hint()) { // there they stand beside the node
		update_configuration_warnings();
	} else {
		const PackedStringArray warnings = _get_configuration_warnings();
		for (const String &warning : warnings) {
			if (!_warned_of.has(warning)) {
				WARN_PRINT(vformat("%s: %s", label(), warning));
			}
		}
		_warned_of = warnings;
	}
	_ground.free();
	_makings++;
	if (_standing.setup.patch->is_empty() || !_backend || !_backend->set_field(_standing.setup)) {
		make_backend();
	}
	if (_backend) {
		_ground.create(_standing.setup.grid, _standing.setup.is_mapped);
		follow();
		set_all_uniforms();
		show_map();
	}
}

// Whether all is there that a field of these properties takes. In parts: does no more of it than this frame has time for.
bool GrassField::prepare(bool p_in_parts) {
	if (p_in_parts && !prepare_patches()) {
		return false;
	}
	const auto has_time = [p_in_parts] { return !p_in_parts || FrameShare::has_time(); };
	if (!_wanted && has_time()) {
		_wanted = find_wanted();
	}
	if (_wanted && !_wanted->bounds && has_time()) {
		_wanted->bounds = find_bounds(_wanted->setup);
	}
	if (!_wanted || !_wanted->bounds) {
		return false;
	}
	const bool has_shaders = !p_in_parts || (_backend->prepare(_wanted->setup) && Ground::prepare(_wanted->setup.is_mapped));
	return has_shaders && prepare_map(p_in_parts);
}

// Those that are not there are being made from now on.
bool GrassField::prepare_patches() const {
	bool are_there = true;
	for (const Ref<GrassSpecies> &species : _species) {
		are_there = (species.is_null() || species->prepare_patch()) && are_there;
	}
	return are_there && (!_species.empty() || _patch.is_null() || const_cast<GrassPatch *>(_patch.ptr())->prepare());
}

bool GrassField::prepare_map(bool p_in_parts) {
	if (!_wanted->setup.is_mapped || _wanted->setup.patch->is_empty()) {
		return true;
	}
	const auto has_time = [p_in_parts] { return !p_in_parts || FrameShare::has_time(); };
	std::unique_ptr<ShownMap> &map = _wanted->map;
	if (!map && has_time()) {
		map = std::make_unique<ShownMap>(_map, _wanted->setup);
	}
	while (map && has_time()) {
		if (!map->work()) {
			return true;
		}
	}
	return false;
}

GrassField::Wanted GrassField::find_wanted() const {
	Wanted wanted;
	FieldSetup &setup = wanted.setup;
	setup.grid = TileGrid::make(_size.x, _size.y, param(PARAM_DENSITY));
	setup.patch = find_patch();
	setup.clump = { float(param(PARAM_CLUMP_SIZE)), float(param(PARAM_CLUMP_HEIGHT)), float(param(PARAM_CLUMP_LEAN)),
		float(param(PARAM_CLUMP_TINT)) };
	setup.pool_tiles = int(_pool_tiles);
	setup.method = _backend ? _method_now : Method(_solver_method); // another backend of this field goes on by passes that are there
	setup.drawn_tiles_max = int(param(PARAM_DRAWN_TILES_MAX));
	setup.seed = uint32_t(_seed);
	setup.is_mapped = _map.is_valid();
	setup.follow_slope = float(param(PARAM_FOLLOW_SLOPE));
	setup.card_size = card_size();
	wanted.mix = species_mix();
	setup.species = _species.empty() ? nullptr : std::make_shared<const SpeciesMix>(wanted.mix, setup.grid, setup.seed);
	for (const Ref<GrassSpecies> &species : used_species()) {
		wanted.species.push_back({ species, species->find_patch() });
	}
	return wanted;
}

// The boxes of the tiles of a field that follows this one.
std::shared_ptr<TileBounds> GrassField::find_bounds(const FieldSetup &p_next) const {
	const FieldSetup &now = _standing.setup;
	const bool same_blades = _standing.bounds && now.patch == p_next.patch && now.clump == p_next.clump && now.seed == p_next.seed &&
			now.is_mapped == p_next.is_mapped && (now.species == nullptr) == (p_next.species == nullptr) &&
			now.card_size == p_next.card_size && now.follow_slope == p_next.follow_slope;
	return same_blades ? std::make_shared<TileBounds>(*_standing.bounds, p_next.grid)
					   : std::make_shared<TileBounds>(*p_next.patch, p_next.grid, p_next.clump, p_next.seed);
}

std::shared_ptr<const Patch> GrassField::find_patch() const {
	if (!_species.empty()) {
		return join_species();
	}
	return _patch.is_valid() ? const_cast<GrassPatch *>(_patch.ptr())->get_patch() : GrassPatch::get_default();
}

// From here on the field is what was prepared.
void GrassField::take_wanted() {
	static_cast<Wanted &>(_standing) = std::move(*_wanted);
	_wanted.reset();
	const FieldSetup &setup = _standing.setup;
	const FieldMap *map = _standing.map ? &_standing.map->get_field() : nullptr;
	_standing.bounds->set_cover(
			map != nullptr ? map->get_cover() : nullptr, map != nullptr ? slope_lean(setup.follow_slope) * setup.blade_length() : 0.0);
	_standing.blades = FieldBlades(setup.grid, setup.patch, setup.clump, setup.seed, setup.species, map);
}

void GrassField::make_backend() {
	_backend.reset();
	if (_standing.setup.patch->is_empty()) {
		return;
	}
	const bool has_device = RenderingServer::get_singleton()->get_rendering_device() != nullptr;
	if (has_device && _backend_mode == BACKEND_AUTO) {
		_backend = std::make_unique<GpuBackend>(_standing.setup);
	} else {
		_backend = std::make_unique<CpuBackend>(_standing.setup);
	}
	_backend->set_measure_time(_measure_time || _is_watched);
	_builds++;
}

} // namespace grass

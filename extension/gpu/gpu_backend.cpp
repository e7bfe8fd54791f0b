// SPDX-License-Identifier: MIT
#include "gpu/gpu_backend.h"

#include "draw/frame_share.h"
#include "draw/patch_texture.h"
#include "gpu/gpu_field.h"
#include "gpu/view_records.h"
#include "shared/convert.h"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

GpuBackend::GpuBackend(const FieldSetup &p_setup) :
		_setup(p_setup),
		_patch_texture(patch_texture(p_setup.patch)),
		_report(std::make_shared<GpuReport>()),
		_jobs(std::make_shared<GpuField>(_report)),
		_knots(_jobs) {
	_pool_texture.instantiate();
	_pool_before_texture.instantiate();
	_drawn_texture.instantiate();
	_bounds = field_bounds(_setup);
	_materials.set("patch_knots", _patch_texture);
	_materials.set("pool_knots", _pool_texture);
	_materials.set("is_listed", true);
	_materials.set("drawn_tiles", _drawn_texture);
	_materials.set("blade_length", _setup.blade_length());
	_jobs.post([setup = _setup, patch = _patch_texture, pool = _pool_texture, drawn = _drawn_texture](
					   GpuField &r_field) { r_field.create(setup, patch->get_rid(), pool, drawn); });
}

GpuBackend::~GpuBackend() {
	set_uniform("pool_knots_before", Variant());
	_materials.set("drawn_tiles", Variant());
	set_uniform("pool_knots", Variant()); // otherwise the engine looks it up again, and may find another thread's new texture
	_jobs.post([multimeshes = multimeshes()](GpuField &r_field) { r_field.free(multimeshes); });
}

void GpuBackend::set_look(const Look &p_look) {
	_materials.set_look(p_look);
	_plants.set_look(p_look);
	if (!_picture.is_created()) { // an instance without our shaders would be drawn with the engine's own
		_picture.create(
				find_mesh(PICTURE_LEVELS), _materials.picture(), _setup.instance_capacity(), Written::LISTED, _bounds, Role::PICTURE);
		_shadows.create(find_mesh(CASTING_LEVELS), _materials.shadows(), _setup.shadow_capacity(), Written::LISTED, _bounds, Role::SHADOWS);
		_is_fitted = false;
		set_bounds(_bounds);
	}
}

FieldMultiMeshes GpuBackend::multimeshes() const {
	return { _picture.multimesh(), _shadows.multimesh(), uint32_t(_picture.capacity()), uint32_t(_shadows.capacity()) };
}

bool GpuBackend::prepare(const FieldSetup &p_setup) {
	const bool has_passes = kind_of(p_setup) == kind_of(_setup) || prepare_passes(kind_of(p_setup));
	const bool has_plants = !p_setup.has_plants || GpuPass::prepare(PlantPasses::code(p_setup.is_mapped));
	return has_passes && has_plants && prepare_patch(p_setup.patch);
}

// Makes the texture of the next field's patch: some megabytes.
bool GpuBackend::prepare_patch(const std::shared_ptr<const Patch> &p_patch) {
	if (p_patch == _setup.patch || p_patch == _next_patch || p_patch->is_empty()) {
		return true;
	}
	if (FrameShare::Turn turn(&_next_patch); turn.has_time()) {
		_next_patch_texture = patch_texture(p_patch);
		_next_patch = p_patch;
	}
	return p_patch == _next_patch;
}

bool GpuBackend::set_field(const FieldSetup &p_setup) {
	const bool has_room = p_setup.instance_capacity() <= _picture.capacity() && p_setup.shadow_capacity() <= _shadows.capacity();
	if (!p_setup.has_meshes_of(_setup) || (_picture.is_created() && !has_room) || needs_refused_pass(p_setup)) {
		return false;
	}
	const bool has_other_blades = p_setup.patch != _setup.patch;
	_setup = p_setup;
	_is_fitted = false;
	_next_room.drop(); // its blades may grow otherwise
	_knots.clear();
	if (has_other_blades) { // plants are set again
		_patch_texture = _next_patch == _setup.patch ? _next_patch_texture : patch_texture(_setup.patch);
		_materials.set("patch_knots", _patch_texture);
		_materials.set("blade_length", _setup.blade_length());
	}
	_next_patch_texture.unref();
	_next_patch.reset();
	set_bounds(field_bounds(_setup));
	_jobs.post([setup = _setup, patch = _patch_texture](GpuField &r_field) { r_field.set_field(setup, patch->get_rid()); });
	return true;
}

bool GpuBackend::is_complete() const {
	return CompileQueue::get().is_complete();
}

void GpuBackend::step(const StepInput &p_input) {
	_has_stepped = true;
	_steps++;
	_jobs.post([records = StepRecords(p_input, _energy, kind_of(_setup)), measure = _measure](
					   GpuField &r_field) { r_field.step(records, measure); });
}

void GpuBackend::join(std::span<const GrassSlot> p_slots, const GrassStep &p_step) {
	_jobs.post([slots = std::vector<GrassSlot>(p_slots.begin(), p_slots.end()), step = p_step](
					   GpuField &r_field) { r_field.join(slots, step); });
}

void GpuBackend::resize_pool(int p_slots, std::span<const SlotMove> p_moves) {
	_share = -1.0f; // the next frame mixes again, if frames do
	_jobs.post([p_slots, moves = std::vector<SlotMove>(p_moves.begin(), p_moves.end()), room = _next_room.take(p_slots)](
					   GpuField &r_field) { r_field.resize_pool(p_slots, moves, room.get()); });
}

bool GpuBackend::prepare_pool(int p_slots) {
	const bool has_species = kind_of(_setup).species;
	return _next_room.prepare(p_slots, { _setup.is_mapped || has_species, has_species, _is_between, _has_motion });
}

void GpuBackend::draw(const FieldView &p_view) {
	const bool is_same = _jobs.get_posted() == _drawn_jobs && _is_fitted && _view == p_view && _report->settled == _frames;
	if (is_same && !_measure && !_has_motion) {
		return;
	}
	fit_meshes(p_view);
	ViewRecords view = to_records(p_view, _setup, _levels, _surfaces);
	view.painted = _painted;
	view.plant_reach = p_view.plant_reach;
	view.number = ++_frames;
	_jobs.post([records = std::move(view), multimeshes = multimeshes(), measure = _measure](
					   GpuField &r_field) { r_field.draw(records, multimeshes, measure); });
	_drawn_jobs = _jobs.get_posted();
}

SharedMesh GpuBackend::find_mesh(LevelSet p_all) const {
	return shared_blade_mesh(_surfaces & p_all, _setup.card_size > 0.0f);
}

// Gives the meshes the surfaces that p_view needs, and draws no instance that could not show anything.
void GpuBackend::fit_meshes(const FieldView &p_view) {
	if (_is_fitted && _view == p_view) {
		return;
	}
	_is_fitted = true;
	_view = p_view;
	_levels = find_levels(_setup.cull_field(), p_view, _ground);
	for (const auto &[instance, all] : { std::pair{ &_picture, PICTURE_LEVELS }, std::pair{ &_shadows, CASTING_LEVELS } }) {
		_surfaces = (_surfaces & ~all) | find_surfaces(_surfaces, _levels, all);
		instance->set_mesh(find_mesh(all));
		instance->need((_levels & all) != 0);
	}
	_plants.fit(_setup.cull_field(), p_view, _ground);
}

void GpuBackend::show_between(bool p_is_between, float p_share) {
	if (_is_between != p_is_between) {
		_is_between = p_is_between;
		_share = -1.0f; // no frame has shown a mix yet
		_jobs.post([p_is_between](GpuField &r_field) { r_field.set_between(p_is_between); });
	}
	if (_is_between && _steps > 0 && (_has_stepped || _share != p_share)) {
		_share = p_share;
		_has_stepped = true; // the blades of this frame have moved, also for motion vectors
		_jobs.post([p_share](GpuField &r_field) { r_field.mix(p_share); });
	}
}

void GpuBackend::show_motion(bool p_is_read, bool p_has_blown) {
	if (_has_motion != p_is_read) {
		_has_motion = p_is_read;
		_jobs.post([texture = _has_motion ? _pool_before_texture : Ref<Texture2DRD>()](GpuField &r_field) { r_field.set_motion(texture); });
		set_uniform("pool_knots_before", _has_motion ? Variant(_pool_before_texture) : Variant());
		set_bounds(_bounds);
	}
	const bool flip = _has_motion && (p_has_blown || _has_stepped) ? !_is_flipped : _has_motion && _is_flipped;
	if (_is_flipped != flip) {
		_is_flipped = flip;
		set_uniform("is_flipped", _is_flipped);
	}
	_has_stepped = false;
}

void GpuBackend::set_bounds(const AABB &p_bounds) {
	_bounds = p_bounds;
	AABB picture = p_bounds;
	if (_has_motion) { // upright and flipped
		const real_t most = std::max(std::abs(p_bounds.position.y), std::abs(p_bounds.position.y + p_bounds.size.y));
		picture.position.y = -most;
		picture.size.y = 2 * most;
	}
	_picture.set_bounds(picture);
	_plants.set_bounds(picture);
	_shadows.set_bounds(p_bounds);
}

void GpuBackend::follow(GeometryInstance3D *p_node, const Transform3D &p_transform) {
	_picture.follow(p_node, p_transform, _is_flipped);
	_plants.follow(p_node, p_transform, _is_flipped);
	_shadows.follow(p_node, p_transform);
}

void GpuBackend::set_cover(const std::shared_ptr<const TileCover> &p_cover, const TileRange &p_changed) {
	set_bounds(field_bounds(_setup, p_cover.get()));
	_ground = p_cover->get_extremes();
	_is_fitted = false;
	if (p_changed.count() > 0) { // whole rows, with a single copy
		const int64_t first = _setup.grid.get_index(0, p_changed.z_begin), count = int64_t(p_changed.depth()) * _setup.grid.get_tiles_x();
		const auto tiles = p_cover->get_tiles().subspan(size_t(first), size_t(count));
		_jobs.post([first, bytes = to_bytes(tiles)](GpuField &r_field) { r_field.set_cover(first, bytes); });
	}
}

EnergyReport GpuBackend::read_energy() {
	std::lock_guard lock(_report->mutex);
	if (_energy_step != _report->energy_step) { // swapped, so that the next report reuses the memory of the last one
		_energy_step = _report->energy_step;
		_energy.swap(_report->energy);
		_bends.swap(_report->bends);
	}
	return { _energy_step, _energy, _bends };
}

StepTime GpuBackend::read_step_time() {
	std::lock_guard lock(_report->mutex);
	return { uint64_t(_report->statistics.timed_steps), _report->statistics.simulate_ms };
}

BackendStatistics GpuBackend::get_statistics() {
	BackendStatistics statistics;
	{
		std::lock_guard lock(_report->mutex);
		statistics = _report->statistics;
	}
	_knots.add_to(statistics, _steps);
	statistics.render_jobs = _jobs.get_posted();
	statistics.instance_updates = _picture.get_updates() + _shadows.get_updates() + _plants.get_updates();
	statistics.compiling = CompileQueue::get().count_compiling();
	statistics.undrawn_batches = RenderQueue::get_singleton()->get_undrawn_batches();
	return statistics;
}

BackendMemory GpuBackend::get_memory() const {
	BackendMemory memory;
	memory.shared = int64_t(_setup.patch->texels.size()) * 2; // as a texture
	memory.pool_tile = PoolRoom::find_slot_bytes(_is_between);
	const int64_t instances = int64_t(_picture.capacity() + _shadows.capacity()) * GRASS_LISTED_FLOATS * 4;
	std::lock_guard lock(_report->mutex);
	memory.pool = _report->statistics.pool_bytes;
	memory.all = memory.shared + instances + _plants.get_memory_usage() + mesh_bytes(_surfaces, _setup.card_size > 0.0f) +
			_report->statistics.buffer_bytes + int64_t(_energy.capacity() * 4 + _knots.get_memory_usage());
	return memory;
}

} // namespace grass

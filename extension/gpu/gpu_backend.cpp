// SPDX-License-Identifier: MIT
#include "gpu/gpu_backend.h"

#include "draw/blade_mesh.h"
#include "draw/patch_texture.h"
#include "gpu/gpu_field.h"
#include "gpu/render_queue.h"

#include <godot_cpp/classes/rendering_server.hpp>

using namespace godot;

namespace grass {

namespace {

vec4 to_vec4(const Eigen::Vector4f &p_v) {
	return { p_v.x(), p_v.y(), p_v.z(), p_v.w() };
}

GrassView to_record(const FieldView &p_view, const FieldSetup &p_setup) {
	GrassView record;
	for (size_t i = 0; i < p_view.planes.size(); i++) {
		record.planes[i] = to_vec4(p_view.planes[i]);
	}
	record.eye = { p_view.eye.x(), p_view.eye.y(), p_view.eye.z(), p_view.shadow_margin };
	record.lod = { p_view.lod.near, p_view.lod.far, p_view.lod.fine, p_view.lod.medium };
	record.field = { float(p_setup.grid.get_tiles_x()), float(p_setup.grid.get_tiles_z()), float(p_setup.grid.get_tile_size()),
		p_setup.blade_height() };
	record.blades = { p_setup.blade_reach(), float(p_view.debug_view), 0.0f, 0.0f };
	record.patch_seed = { p_setup.seed, 0, 0, 0 };
	return record;
}

} // namespace

GpuBackend::GpuBackend(const FieldSetup &p_setup) :
		_setup(p_setup),
		_patch_texture(make_patch_texture(*p_setup.patch)),
		_report(std::make_shared<GpuReport>()),
		_field(std::make_shared<GpuField>(_report)) {
	_pool_texture.instantiate();
	_materials.set("patch_knots", _patch_texture);
	_materials.set("pool_knots", _pool_texture);

	Ref<ArrayMesh> mesh;
	mesh.instantiate();
	for (int level = 0; level < GRASS_LOD_LEVELS; level++) {
		add_lod_surface(mesh, level, _materials.level(level));
	}
	_instance.create(mesh, _setup.instance_capacity(), true, field_bounds(_setup));
	RenderQueue::get_singleton()->post([field = _field, setup = _setup, patch = _patch_texture, pool = _pool_texture] {
		field->create(setup, patch->get_rid(), pool);
	});
}

GpuBackend::~GpuBackend() {
	RenderQueue::get_singleton()->post([field = _field, multimesh = _instance.multimesh()] { field->free(multimesh); });
}

bool GpuBackend::set_grid(const TileGrid &p_grid) {
	_setup.grid = p_grid;
	if (_setup.instance_capacity() > _instance.capacity()) {
		return false;
	}
	_instance.set_bounds(field_bounds(_setup));
	RenderQueue::get_singleton()->post([field = _field, tiles = p_grid.get_tile_count()] { field->set_tiles(tiles); });
	return true;
}

void GpuBackend::step(const StepInput &p_input) {
	RenderQueue::get_singleton()->post(
			[field = _field, records = StepRecords(p_input), measure = _measure] { field->step(records, measure); });
}

void GpuBackend::draw(const FieldView &p_view) {
	RenderQueue::get_singleton()->post([field = _field, view = to_record(p_view, _setup), multimesh = _instance.multimesh(),
											   measure = _measure] { field->draw(view, multimesh, measure); });
}

void GpuBackend::follow(GeometryInstance3D *p_node, const Transform3D &p_transform) {
	_instance.follow(p_node, p_transform);
}

std::vector<Eigen::Vector3f> GpuBackend::read_knots(int p_slot, int p_blade) {
	auto knots = std::make_shared<std::vector<Eigen::Vector3f>>();
	RenderQueue::get_singleton()->post([field = _field, knots, p_slot, p_blade] { *knots = field->read_knots(p_slot, p_blade); });
	RenderingServer::get_singleton()->force_sync(); // the render thread may be another one: until then `knots` is its own
	return *knots;
}

EnergyReport GpuBackend::read_energy() {
	std::lock_guard lock(_report->mutex);
	_energy = _report->energy;
	return { _report->energy_step, _energy };
}

BackendStatistics GpuBackend::get_statistics() {
	std::lock_guard lock(_report->mutex);
	return _report->statistics;
}

int64_t GpuBackend::get_memory_usage() const {
	const int64_t patch = int64_t(_setup.patch->texels.size()) * 2;
	const int64_t instances = int64_t(_instance.capacity()) * GRASS_INSTANCE_FLOATS * 4;
	std::lock_guard lock(_report->mutex);
	return patch + instances + mesh_bytes() + _report->statistics.buffer_bytes + int64_t(_energy.capacity() * 4);
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "gpu/view_records.h"

#include <algorithm>

namespace grass {

namespace {

vec4 to_vec4(const Eigen::Vector4f &p_v) {
	return { p_v.x(), p_v.y(), p_v.z(), p_v.w() };
}

GrassCamera to_record(const ViewCamera &p_camera) {
	GrassCamera record;
	for (size_t i = 0; i < p_camera.planes.size(); i++) {
		record.planes[i] = to_vec4(p_camera.planes[i]);
	}
	record.eye = { p_camera.eye.x(), p_camera.eye.y(), p_camera.eye.z(), p_camera.near };
	record.pixel = { p_camera.pixel, p_camera.pixel_slope, 0.0f, 0.0f };
	return record;
}

} // namespace

ViewRecords to_records(const FieldView &p_view, const FieldSetup &p_setup, LevelSet p_levels, LevelSet p_surfaces) {
	ViewRecords records;
	GrassView &view = records.view;
	const BladeSize size = p_setup.blade_size();
	view.lod = { p_view.lod.far, p_view.lod.error, p_view.lod.pixels_min, p_view.lod.shadow_coarseness };
	view.field = { float(p_setup.grid.get_tiles_x()), float(p_setup.grid.get_tiles_z()), float(p_setup.grid.get_tile_size()),
		p_setup.blade_height() };
	view.blades = { p_setup.blade_spread(), size.width, size.length, p_view.lod.is_carried ? 1.0f : 0.0f };
	view.shadow = { p_view.shadow_margin, p_view.shadow_distance, 0.0f, 0.0f };
	const size_t falls = std::min(p_view.falls.size(), std::size(view.falls));
	for (size_t i = 0; i < falls; i++) {
		view.falls[i] = { p_view.falls[i].x(), p_view.falls[i].y(), p_view.falls[i].z(), 0.0f };
	}
	view.counts = { uint32_t(p_view.cameras.size()), uint32_t(falls), p_setup.seed, p_setup.is_mapped ? 1u : 0u };
	view.levels = { uint32_t(p_levels), uint32_t(p_levels >> 32), uint32_t(p_surfaces), uint32_t(p_surfaces >> 32) };
	for (const ViewCamera &camera : p_view.cameras) {
		records.cameras.push_back(to_record(camera));
	}
	return records;
}

} // namespace grass

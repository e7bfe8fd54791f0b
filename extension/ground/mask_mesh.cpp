// SPDX-License-Identifier: MIT
#include "ground/mask_mesh.h"

#include "shared/convert.h"
#include "shared/script_call.h"

#include <godot_cpp/variant/packed_color_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

namespace {

// Adds a surface's triangles with the red of their vertex colours, or 1 where the mesh has none.
void add_triangles(FillMesh &r_mesh, const Array &p_arrays, const Eigen::Affine3d &p_pose) {
	if (p_arrays.size() <= Mesh::ARRAY_INDEX) { // a script's
		return;
	}
	const PackedVector3Array places = p_arrays[Mesh::ARRAY_VERTEX];
	const PackedColorArray colors = p_arrays[Mesh::ARRAY_COLOR];
	const PackedInt32Array indices = p_arrays[Mesh::ARRAY_INDEX];
	const int64_t count = indices.is_empty() ? places.size() : indices.size();
	const auto corner = [&](int64_t p_n) {
		const int64_t i = indices.is_empty() ? p_n : int64_t(indices[p_n]);
		return FillMesh::Corner{ p_pose * to_eigen(places[i]), i < colors.size() ? std::clamp(double(colors[i].r), 0.0, 1.0) : 1.0 };
	};
	const auto is_there = [&](int64_t p_n) { return indices.is_empty() || (indices[p_n] >= 0 && int64_t(indices[p_n]) < places.size()); };
	for (int64_t n = 0; n + 2 < count; n += 3) {
		if (is_there(n) && is_there(n + 1) && is_there(n + 2)) {
			r_mesh.add(corner(n), corner(n + 1), corner(n + 2));
		}
	}
}

FillMesh mesh_of(const MaskMesh::Parts &p_parts) {
	FillMesh made;
	for (const MaskMesh::Part &part : p_parts) {
		for (int32_t surface = 0; surface < part.mesh->get_surface_count(); surface++) {
			add_triangles(made, part.mesh->surface_get_arrays(surface), part.pose);
		}
	}
	return made;
}

} // namespace

void MaskMesh::listen(const Callable &p_changed) {
	watch({});
	_changed = p_changed;
	_parts.clear();
	_mesh.reset();
}

void MaskMesh::watch(const Parts &p_parts) {
	const std::vector<Ref<Mesh>> before = std::exchange(_watched, {});
	for (const Part &part : p_parts) {
		if (_changed.is_valid() && std::ranges::find(_watched, part.mesh) == _watched.end()) {
			_watched.push_back(part.mesh);
		}
	}
	for (const Ref<Mesh> &mesh : before) {
		if (std::ranges::find(_watched, mesh) == _watched.end()) {
			mesh.ptr()->disconnect("changed", _changed);
		}
	}
	for (const Ref<Mesh> &mesh : _watched) {
		if (std::ranges::find(before, mesh) == before.end()) {
			mesh.ptr()->connect("changed", _changed);
		}
	}
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): a script that runs meanwhile may read other parts
bool MaskMesh::read(const Node3D &p_field, Parts p_parts) {
	if (_is_reading || (_mesh && !_has_changed && p_parts == _parts)) {
		return true;
	}
	watch(p_parts);
	_has_changed = false;
	_is_reading = true;
	FillMesh made;
	if (!outlives(p_field, [&] { made = mesh_of(p_parts); })) {
		return false;
	}
	_is_reading = false;
	_parts = std::move(p_parts);
	if (!_mesh || !(made == *_mesh)) {
		_mesh = std::make_shared<const FillMesh>(std::move(made));
	}
	return true;
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "draw/blade_mesh.h"

#include <godot_cpp/variant/packed_int32_array.hpp>

#include <map>
#include <utility>

using namespace godot;

namespace grass {

static_assert(GRASS_BLADES_PER_TILE * (2 * GRASS_SEGMENTS + 1 + GRASS_CARD_CORNERS) <= GRASS_LEVEL_VERTICES);

int lod_blades(int p_level) {
	return get_lod_level(p_level).blades;
}
int lod_segments(int p_level) {
	return get_lod_level(p_level).segments;
}

namespace {
bool has_cards(int p_level, bool p_cards) {
	return p_cards && p_level < GRASS_LOD_LEVELS && lod_segments(p_level) >= GRASS_CARD_SEGMENTS;
}

bool has_level(LevelSet p_levels, int p_level) {
	return (p_levels >> p_level & 1) != 0;
}
} // namespace

int lod_triangles_per_blade(int p_level, bool p_cards) {
	return 2 * lod_segments(p_level) - 1 + (has_cards(p_level, p_cards) ? GRASS_CARD_TRIANGLES : 0);
}

int64_t mesh_bytes(LevelSet p_levels, bool p_cards) {
	int64_t indices = 0;
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		indices += has_level(p_levels, level) ? 3 * int64_t(lod_blades(level)) * lod_triangles_per_blade(level, p_cards) : 0;
	}
	return 4 * indices;
}

namespace {

// Returns the numbers of the vertices of a level's triangles.
PackedInt32Array make_indices(int p_level, bool p_cards) {
	const int blades = lod_blades(p_level), segments = lod_segments(p_level);
	const int begin = segments * GRASS_SEGMENT_VERTICES + p_level * GRASS_LEVEL_VERTICES;
	PackedInt32Array indices;
	indices.resize(int64_t(blades) * lod_triangles_per_blade(p_level, p_cards) * 3);
	int32_t *next = indices.ptrw();
	for (int blade = 0; blade < blades; blade++) {
		const int first = begin + blade * (2 * segments + 1); // two vertices for each row, one at the tip
		for (int row = 0; row < segments; row++) {
			const int left = first + 2 * row, right = left + 1;
			*next++ = left;
			*next++ = left + 2;
			*next++ = right;
			if (row + 1 < segments) { // otherwise `left + 2` is the tip
				*next++ = right;
				*next++ = left + 2;
				*next++ = right + 2;
			}
		}
	}
	for (int blade = 0; blade < blades && has_cards(p_level, p_cards); blade++) {
		const int first = begin + GRASS_BLADES_PER_TILE * (2 * segments + 1) + GRASS_CARD_CORNERS * blade;
		for (const int corner : { 0, 2, 1, 1, 2, 3 }) {
			*next++ = first + corner;
		}
	}
	return indices;
}

Ref<ArrayMesh> make_blade_mesh(LevelSet p_levels, bool p_cards) {
	Ref<ArrayMesh> mesh;
	mesh.instantiate();
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		if (has_level(p_levels, level)) {
			Array arrays;
			arrays.resize(Mesh::ARRAY_MAX);
			arrays[Mesh::ARRAY_INDEX] = make_indices(level, p_cards);
			mesh->add_surface_from_arrays(
					Mesh::PRIMITIVE_TRIANGLES, arrays, TypedArray<Array>(), Dictionary(), Mesh::ARRAY_FLAG_USES_EMPTY_VERTEX_ARRAY);
		}
	}
	return mesh;
}

} // namespace

SharedMesh shared_blade_mesh(LevelSet p_levels, bool p_cards) {
	static std::map<std::pair<LevelSet, bool>, std::weak_ptr<const Ref<ArrayMesh>>> meshes;
	SharedMesh mesh = meshes[{ p_levels, p_cards }].lock();
	if (!mesh) {
		std::erase_if(meshes, [](const auto &p_entry) { return p_entry.second.expired(); });
		mesh = std::make_shared<const Ref<ArrayMesh>>(make_blade_mesh(p_levels, p_cards));
		meshes[{ p_levels, p_cards }] = mesh;
	}
	return mesh;
}

} // namespace grass

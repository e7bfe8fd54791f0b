// SPDX-License-Identifier: MIT
#include "draw/blade_mesh.h"

#include "core/lod/lod.h"

#include <godot_cpp/variant/packed_int32_array.hpp>

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
} // namespace

int lod_triangles_per_blade(int p_level, bool p_cards) {
	return 2 * lod_segments(p_level) - 1 + (has_cards(p_level, p_cards) ? GRASS_CARD_TRIANGLES : 0);
}

int64_t mesh_bytes(bool p_cards) {
	int64_t indices = 0;
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		indices += 3 * int64_t(lod_blades(level)) * lod_triangles_per_blade(level, p_cards);
	}
	return 4 * indices;
}

void add_lod_surface(const Ref<ArrayMesh> &p_mesh, int p_level, const Ref<Material> &p_material, bool p_cards) {
	const int blades = lod_blades(p_level), segments = lod_segments(p_level), begin = p_level * GRASS_LEVEL_VERTICES;
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
	Array arrays;
	arrays.resize(Mesh::ARRAY_MAX);
	arrays[Mesh::ARRAY_INDEX] = indices;
	p_mesh->add_surface_from_arrays(
			Mesh::PRIMITIVE_TRIANGLES, arrays, TypedArray<Array>(), Dictionary(), Mesh::ARRAY_FLAG_USES_EMPTY_VERTEX_ARRAY);
	p_mesh->surface_set_material(p_mesh->get_surface_count() - 1, p_material);
}

} // namespace grass

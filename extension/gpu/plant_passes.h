// SPDX-License-Identifier: MIT
// The passes of a frame that select the plants to draw by a mesh or by its impostor (shaders/species/plants.glsl), one for each. They live
// on the render thread, in GpuCull.
#pragma once

#include "core/field/backend_statistics.h"
#include "core/field/field_setup.h"
#include "core/lod/plant_cull.h"
#include "core/species/species.h"
#include "gpu/device.h"

#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/classes/texture2d_array.hpp>
#include <godot_cpp/variant/vector2.hpp>

#include <memory>
#include <vector>

namespace grass {

// The textures of a field's map that show where species are painted.
struct PaintedSpecies {
	godot::Ref<godot::Texture2D> pages;
	godot::Ref<godot::Texture2DArray> painted;
	godot::Vector2 origin;
};

// A MultiMesh of plants.
struct PlantTarget {
	godot::RID multimesh;
	int number, room, surfaces; // number: as PlantCull::Kinds
	PlantKind kind;
};

class PlantPasses {
public:
	static const PassCode &code(bool p_is_mapped); // of a field with or without a map
	// Sets the field and its plants. p_setup: must have several species; it is not read if there are no targets.
	void set(const FieldSetup &p_setup, const std::vector<PlantTarget> &p_targets);
	bool is_empty() const { return _targets.empty(); }
	// Sets the share of their distances up to which plants are drawn with a mesh.
	void set_reach(float p_reach) {
		_is_new = _is_new || _reach != p_reach;
		_reach = p_reach;
	}
	// Sets the buffers that cull.glsl reads too, and the patch's texture.
	struct Shared {
		godot::RID view, cameras, table, cover, patch, sampler;
	};
	// Binds what has changed. Returns false if the MultiMeshes are not ready yet.
	bool bind(const Shared &p_shared, const PaintedSpecies &p_painted);
	// Returns true if a binding has changed since the last dispatch.
	bool has_changed() const;
	void dispatch(int64_t p_list, int p_cameras, const PaintedSpecies &p_painted);
	void clear_counts();
	godot::RID counts() const { return _counts.rid(); }
	static constexpr int COUNT_BYTES = GRASS_MAX_SPECIES * GRASS_PLANT_STAGES * 4;
	std::vector<PlantTarget> get_targets() const;
	// Counts the plants with room, and those without.
	static void count(const std::vector<PlantTarget> &p_targets, const godot::PackedByteArray &p_counts, BackendStatistics &r_statistics);
	int64_t get_memory_usage() const { return _mix.size() + _counts.size(); }
	// Frees everything, the MultiMeshes' command buffers too, since the engine never does (seen in 4.6).
	void free();

private:
	struct Mix { // the layout in plants.glsl
		std::array<ivec4, GRASS_MAX_SPECIES> mix, origin;
		std::array<int32_t, GRASS_MAX_SPECIES> stems, fray;
		int32_t count, texel, unused[2];
	};
	struct Choosing {
		PlantTarget target;
		std::unique_ptr<GpuPass> pass;
	};

	TileGrid _grid;
	bool _is_mapped = false, _is_new = false;
	float _reach = 1.0f;
	std::vector<Choosing> _targets;
	GpuBuffer _mix, _counts; // of the species; plants chosen, by number
};

} // namespace grass

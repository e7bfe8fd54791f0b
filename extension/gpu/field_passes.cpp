// SPDX-License-Identifier: MIT
#include "gpu/field_passes.h"

#include "compute_shaders.gen.h"
#include "gpu/device.h"
#include "gpu/knot_reader.h"
#include "gpu/obstacles.h"
#include "gpu/plant_passes.h"

namespace grass {

namespace {

bool is_compiled(const PassCode &p_code) {
	const CompileQueue::Pipeline &pipeline = CompileQueue::get().find(p_code);
	return pipeline.is_done && pipeline.pipeline.is_valid();
}

} // namespace

const PassCode CULL_CODE = { shader::CULL_SPIRV, "GrassField cull", PassOrder::CULL };

PassCode simulate_code(const PassKind &p_kind, Tiles p_tiles) {
	struct Variant {
		std::span<const uint32_t> grass, species;
		const char *name;
		PassOrder order;
	};
	static const Variant variants[] = {
		{ shader::SIMULATE_SPIRV, shader::SIMULATE_GRASS_SPECIES_SPIRV, "GrassField simulate", PassOrder::SIMULATE },
		{ shader::SIMULATE_GRASS_EDGES_SPIRV, shader::SIMULATE_GRASS_SPECIES_EDGES_SPIRV, "GrassField simulate edges", PassOrder::EDGES },
		{ shader::SIMULATE_GRASS_FREE_SPIRV, shader::SIMULATE_GRASS_SPECIES_FREE_SPIRV, "GrassField simulate free", PassOrder::FREE },
		{ shader::SIMULATE_GRASS_EDGES_SPIRV, shader::SIMULATE_GRASS_SPECIES_EDGES_SPIRV, "GrassField simulate crowds", PassOrder::CROWDS },
	};
	const Variant &variant = variants[p_tiles];
	const bool crowd = p_tiles == TILES_WITH_CROWDS;
	return { p_kind.species ? variant.species : variant.grass, variant.name, variant.order, int(p_kind.method), crowd, p_tiles != TILES_ALL,
		device_limits().has_quick_arrays };
}

// If it is refused, all blades of awake tiles are simulated.
PassCode join_code(const PassKind &p_kind) {
	const std::span<const uint32_t> code = p_kind.species ? std::span<const uint32_t>(shader::JOIN_GRASS_SPECIES_SPIRV) : shader::JOIN_SPIRV;
	return { code, "GrassField join", PassOrder::JOIN, PassCode::NO_METHOD, false, true };
}

void begin_passes(const FieldPasses &p_passes) {
	if (main_device() == nullptr) {
		return;
	}
	GpuPass::prepare(CULL_CODE, Need::WANTED);
	if (p_passes.has_plants) {
		PlantPasses::prepare(p_passes.is_mapped, Need::WANTED);
	}
	GpuPass::prepare(simulate_code(p_passes.kind, TILES_ALL), Need::WANTED);
}

bool prepare_passes(const PassKind &p_kind) {
	const bool is_done = GpuPass::prepare(simulate_code(p_kind, TILES_ALL));
	GpuPass::prepare(join_code(p_kind));
	GpuPass::prepare(simulate_code(p_kind, TILES_FREE));
	GpuPass::prepare(simulate_code(p_kind, TILES_WITH_EDGES));
	return is_done;
}

bool can_simulate(const PassKind &p_kind) {
	return is_compiled(simulate_code(p_kind, TILES_ALL));
}

bool can_join(const PassKind &p_kind) {
	return is_compiled(join_code(p_kind));
}

const char *find_refused(const FieldPasses &p_passes) {
	for (const PassCode &code : { CULL_CODE, simulate_code(p_passes.kind, TILES_ALL) }) {
		if (CompileQueue::get().is_refused(code)) {
			return code.name;
		}
	}
	const char *gather = KnotReader::find_refused();
	return gather != nullptr || !p_passes.has_plants ? gather : PlantPasses::find_refused(p_passes.is_mapped);
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "gpu/field_passes.h"

#include "compute_shaders.gen.h"
#include "gpu/device.h"
#include "gpu/knot_reader.h"
#include "gpu/obstacles.h"
#include "gpu/plant_passes.h"

#include <algorithm>
#include <array>
#include <vector>

namespace grass {

namespace {

bool is_compiled(const PassCode &p_code) {
	const CompileQueue::Pipeline &pipeline = CompileQueue::get().find(p_code);
	return pipeline.is_done && pipeline.pipeline.is_valid();
}

} // namespace

const PassCode CULL_CODE = { shader::CULL_SPIRV, "GrassField cull", PassOrder::CULL };

PassCode simulate_code(const PassKind &p_kind, SlotPass p_pass, bool p_many) {
	struct Variant {
		SpirvCode grass, species;
		const char *name, *many_name;
		PassOrder order;
	};
	static const std::array<Variant, SLOT_PASSES> variants{ {
			{ shader::SIMULATE_GRASS_EDGES_SPIRV, shader::SIMULATE_GRASS_SPECIES_EDGES_SPIRV, "GrassField simulate crowds", nullptr,
					PassOrder::CROWDS },
			{ shader::SIMULATE_GRASS_EDGES_SPIRV, shader::SIMULATE_GRASS_SPECIES_EDGES_SPIRV, "GrassField simulate edges",
					"GrassField simulate edges of many", PassOrder::EDGES },
			{ shader::SIMULATE_SPIRV, shader::SIMULATE_GRASS_SPECIES_SPIRV, "GrassField simulate", "GrassField simulate many",
					PassOrder::SIMULATE },
			{ shader::SIMULATE_GRASS_FREE_SPIRV, shader::SIMULATE_GRASS_SPECIES_FREE_SPIRV, "GrassField simulate free",
					"GrassField simulate free of many", PassOrder::FREE },
			{ shader::STRAINS_SPIRV, shader::STRAINS_GRASS_SPECIES_SPIRV, nullptr, "GrassField simulate strains", PassOrder::STRAINS },
	} };
	const Variant &variant = variants[size_t(p_pass)];
	const SpirvCode &code = p_kind.species ? variant.species : variant.grass;
	const Variant &plain = variants[size_t(SlotPass::PLAIN)];
	const PassKey all_kinds{ (p_kind.species ? plain.species : plain.grass).data(), int(p_kind.method), GRASS_TILES_ONE };
	if (p_pass == SlotPass::STRAINS) { // only for fields of METHOD_DIRECT
		return { code, variant.many_name, variant.order, PassCode::NO_METHOD, GRASS_TILES_ONE, true, false, all_kinds };
	}
	const int tiles = p_many ? GRASS_TILES_MANY : p_pass == SlotPass::CROWD ? GRASS_TILES_CROWD : GRASS_TILES_ONE;
	const bool is_variant = p_many || p_pass != SlotPass::PLAIN;
	return { code, p_many ? variant.many_name : variant.name, p_many ? PassOrder::MANY : variant.order, int(p_kind.method), tiles,
		is_variant, device_limits().has_quick_arrays, is_variant ? std::optional(all_kinds) : std::nullopt };
}

// Returns the code of join. If it is refused, all blades of awake tiles are simulated.
PassCode join_code(const PassKind &p_kind) {
	const SpirvCode &code = p_kind.species ? shader::JOIN_GRASS_SPECIES_SPIRV : shader::JOIN_SPIRV;
	return { code, "GrassField join", PassOrder::JOIN, PassCode::NO_METHOD, GRASS_TILES_ONE, true };
}

void begin_passes(const FieldPasses &p_passes) {
	if (main_device() == nullptr) {
		return;
	}
	GpuPass::prepare(CULL_CODE, Need::WANTED);
	if (p_passes.has_plants) {
		GpuPass::prepare(PlantPasses::code(p_passes.is_mapped), Need::WANTED);
	}
	GpuPass::prepare(simulate_code(p_passes.kind, SlotPass::PLAIN), Need::WANTED);
}

bool prepare_passes(const PassKind &p_kind) {
	const bool is_done = GpuPass::prepare(simulate_code(p_kind, SlotPass::PLAIN));
	GpuPass::prepare(join_code(p_kind));
	GpuPass::prepare(simulate_code(p_kind, SlotPass::FREE));
	if (p_kind.method == Method::DIRECT) {
		GpuPass::prepare(simulate_code(p_kind, SlotPass::STRAINS, true));
	}
	GpuPass::prepare(simulate_code(p_kind, SlotPass::EDGES));
	return is_done;
}

bool can_simulate(const PassKind &p_kind) {
	return is_compiled(simulate_code(p_kind, SlotPass::PLAIN));
}

bool can_share(const PassKind &p_kind) {
	bool can = true;
	for (const SlotPass pass : { SlotPass::FREE, SlotPass::PLAIN, SlotPass::EDGES }) {
		can = is_compiled(simulate_code(p_kind, pass, true)) && can; // all of them are asked for
	}
	return can;
}

bool has_strains(const PassKind &p_kind) {
	return is_compiled(simulate_code(p_kind, SlotPass::STRAINS, true));
}

bool can_join(const PassKind &p_kind) {
	return is_compiled(join_code(p_kind));
}

const char *find_refused(const FieldPasses &p_passes) {
	std::vector<PassCode> needed{ CULL_CODE, simulate_code(p_passes.kind, SlotPass::PLAIN), KnotReader::CODE };
	if (p_passes.has_plants) {
		needed.push_back(PlantPasses::code(p_passes.is_mapped));
	}
	const auto refused = std::ranges::find_if(needed, [](const PassCode &p_code) { return CompileQueue::get().is_refused(p_code); });
	return refused == needed.end() ? nullptr : refused->name;
}

} // namespace grass

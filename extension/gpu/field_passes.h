// SPDX-License-Identifier: MIT
// The passes that a field needs before it is simulated and drawn, and whether the driver has compiled them. Call these functions on any
// thread.
#pragma once

#include "core/field/field_setup.h"
#include "core/solver/slot_passes.h"
#include "gpu/compile_queue.h"

namespace grass {

// The properties of a field for which its simulation passes are compiled.
struct PassKind {
	bool species = false; // whether it has any
	Method method = Method::DIRECT;

	bool operator==(const PassKind &p_other) const = default;
};
inline PassKind kind_of(const FieldSetup &p_setup) {
	return { p_setup.species != nullptr, p_setup.method };
}

// Returns the code of a pass that simulates tiles. p_many: several in a workgroup, always true for SlotPass::STRAINS. SlotPass::PLAIN
// simulates all kinds, if need be.
PassCode simulate_code(const PassKind &p_kind, SlotPass p_pass, bool p_many = false);
PassCode join_code(const PassKind &p_kind);
extern const PassCode CULL_CODE;

struct FieldPasses {
	PassKind kind;
	bool has_plants = false, is_mapped = false;
};
inline FieldPasses passes_of(const FieldSetup &p_setup) {
	return { kind_of(p_setup), p_setup.has_plants, p_setup.is_mapped };
}
// Makes a worker thread compile the passes for a field that enters the tree, while the main thread makes the rest.
void begin_passes(const FieldPasses &p_passes);
// Makes a worker thread compile the passes that simulate a field to come. Returns true once the driver has compiled or refused the one for
// all kinds of tiles.
bool prepare_passes(const PassKind &p_kind);
// Returns whether the pass that simulates all kinds of tiles is compiled.
bool can_simulate(const PassKind &p_kind);
// Returns whether the passes for several tiles in a workgroup are compiled. The first call starts to compile them.
bool can_share(const PassKind &p_kind);
// Returns whether the pass that moves blades by their strains is compiled; until then such tiles have chains.
bool has_strains(const PassKind &p_kind);
// Returns whether blades can join the simulated ones of their tile.
bool can_join(const PassKind &p_kind);
// Returns the name of a pass that the driver has refused; null: none so far.
const char *find_refused(const FieldPasses &p_passes);

} // namespace grass

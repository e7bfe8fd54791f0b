// SPDX-License-Identifier: MIT
// Determines which pass of the GPU simulates which slot (docs/history/0019-dispatches-without-barriers.md), and in which workgroup
// (docs/history/0079-simulate-what-is-seen.md).
#pragma once

#include "core/solver/step.h"

#include <array>
#include <cstdint>
#include <span>

namespace grass {

// The kinds of tiles by their colliders, each with a pass of its own, in the order of their work. CROWD: more than a workgroup shares.
// EDGES: one is sharper than a blade's segment is long. PLAIN: the others; retired tiles too. FREE: none. STRAINS: none for some time.
enum class SlotPass { CROWD, EDGES, PLAIN, FREE, STRAINS };
inline constexpr int SLOT_PASSES = 5;

// Consecutive workgroups.
struct SlotGroups {
	uint32_t first = 0, count = 0;
	int tiles = 0; // that they simulate
	int64_t blades = 0; // of these
};

// The workgroups of a pass: those of one tile, and those of several tiles, of which few blades are simulated. Of STRAINS all are of the
// second kind, although one may have a single tile.
struct PassGroups {
	SlotGroups single, many;
	int tiles() const { return single.tiles + many.tiles; }
};
// The limits of workgroups.
struct GroupLimits {
	uint32_t room = 0; // workgroups for which there is room to work at once; 0: none is needed
	bool may_share = true; // one may have several tiles
	bool has_strains = true; // SlotPass::STRAINS may be used
};
using SlotPasses = std::array<PassGroups, SLOT_PASSES>; // by SlotPass

// Copies p_input.slots to r_slots, which has room for as many, in the order of the workgroups that simulate them, and sets GrassSlot.group
// of as many records as there are workgroups. Those that take longest come first: by pass; then, within a pass, tiles with a fast collider,
// then, if there are more tiles than a GPU simulates at once, those with the liveliest blades (docs/history/0047-lively-tiles-first.md).
// p_energies: J/kg, by slot, as last reported; slots beyond its end have no known energy and come last.
SlotPasses choose_passes(const StepInput &p_input, std::span<const float> p_energies, GroupLimits p_limits, std::span<GrassSlot> r_slots);

} // namespace grass

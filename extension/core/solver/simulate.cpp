// SPDX-License-Identifier: MIT
#include "core/solver/simulate.h"

#include "core/base/functions.h"
#include "core/base/half.h"
#include "core/base/resize_exactly.h"
#include "core/blades/blade.h"
#include "core/solver/constants.h"
#include "core/solver/join.h"
#include "core/solver/strain/strain.h"
#include "core/solver/tile_state.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace grass {

namespace {

constexpr int BLADES = GRASS_BLADES_PER_TILE;

Eigen::Vector3f knot_of(const TileState &p_state, int p_knot, int p_blade) {
	Eigen::Vector3f knot;
	for (int c = 0; c < 3; c++) {
		knot[c] = p_knot < GRASS_CLAMPED_KNOTS ? p_state.rest[c][p_knot][p_blade] : p_state.knots[c][p_knot - GRASS_CLAMPED_KNOTS][p_blade];
	}
	return knot;
}

// Returns how many blades a step leaves out: whole groups of lanes, so that all versions of the step do the same. p_wanted: of a record.
int whole_groups(float p_wanted) {
	return std::clamp(int(p_wanted), 0, BLADES - 1) / MOST_LANES * MOST_LANES;
}

// [Eq M5] Returns the mean bend of the simulated blades.
Eigen::Vector3f bend_of(const TileState &p_state) {
	Eigen::Vector3f sum = Eigen::Vector3f::Zero();
	for (int b = 0; b < BLADES - p_state.left_out; b++) {
		Eigen::Vector3f first, away;
		for (int c = 0; c < 3; c++) {
			first[c] = p_state.rest[c][1][b] - p_state.rest[c][0][b];
			away[c] = p_state.knots[c][GRASS_FREE_KNOTS - 1][b] - p_state.rest[c][GRASS_KNOTS - 1][b];
		}
		sum += away / std::max(blade_length(first), 1e-5f);
	}
	return sum / float(BLADES - p_state.left_out);
}

glsl::vec4 to_glsl(const vec4 &p_a) {
	return { p_a.x, p_a.y, p_a.z, p_a.w };
}

// [Eq W6] Computes what forces do to the blades, from the air at their roots.
void find_air_load(const TileState &p_state, const GrassSlot &p_slot, const StepInput &p_input, AirLoad &r_air) {
	for (int b = 0; b < BLADES - p_state.left_out; b++) {
		glsl::vec3 air(0.0f);
		for (uint32_t left = p_slot.list.w >> GRASS_SLOT_FORCES; left != 0; left &= left - 1) {
			const size_t index = size_t(std::countr_zero(left));
			if (index >= p_input.forces.size()) {
				break;
			}
			const GrassForce &force = p_input.forces[index];
			const float x = float(p_slot.tile.x - force.anchor.x) * p_input.step.field.x,
						z = float(p_slot.tile.y - force.anchor.y) * p_input.step.field.x;
			const glsl::vec3 from(
					p_state.root[0][b] + x - force.place.x, p_state.root[1][b] - force.place.y, p_state.root[2][b] + z - force.place.z);
			air += glsl::grass_force_air(force.place.w, to_glsl(force.blow), to_glsl(force.ring), to_glsl(force.beat), from);
		}
		r_air.drag[b] = glsl::grass_force_drag(glsl::length(air));
		r_air.load[0][b] = air.x * r_air.drag[b];
		r_air.load[1][b] = air.y * r_air.drag[b];
		r_air.load[2][b] = air.z * r_air.drag[b];
	}
}

} // namespace

CpuPool::CpuPool(std::shared_ptr<const Patch> p_patch, int p_slots) :
		_patch(std::move(p_patch)),
		_slots(size_t(std::max(p_slots, 0))),
		_energy(_slots.size(), 0.0f),
		_bends(_slots.size(), Eigen::Vector3f::Zero()) {}

CpuPool::~CpuPool() = default;

// Hashes by FNV-1a, a word at a time.
uint64_t CpuPool::hash() const {
	uint64_t hash = 0xcbf29ce484222325u;
	const auto add = [&hash](uint32_t p_word) { hash = (hash ^ p_word) * 0x100000001b3u; };
	const auto add_floats = [&add](const float *p_first, size_t p_bytes) {
		std::for_each(p_first, p_first + p_bytes / sizeof(float), [&add](float p_value) { add(std::bit_cast<uint32_t>(p_value)); });
	};
	for (size_t slot = 0; slot < _slots.size(); slot++) {
		if (const TileState *state = _slots[slot].get()) {
			add(uint32_t(slot));
			add_floats(&state->knots[0][0][0], sizeof(state->knots));
			add_floats(&state->twist[0][0], sizeof(state->twist));
		}
	}
	return hash;
}

void CpuPool::resize(int p_slots, std::span<const SlotMove> p_moves) {
	for (const SlotMove &move : p_moves) {
		if (move.to != GRASS_NO_SLOT) {
			const size_t from = size_t(move.from), to = size_t(move.to);
			_slots[to] = std::move(_slots[from]);
			_energy[to] = _energy[from];
			_bends[to] = _bends[from];
		}
	}
	resize_exactly(_slots, size_t(p_slots));
	_energy.resize(size_t(p_slots), 0.0f);
	_bends.resize(size_t(p_slots), Eigen::Vector3f::Zero());
}

void CpuPool::step(const StepInput &p_input, const ParallelFor &p_parallel_for, TileStep p_step) {
	std::vector<AwakeSlot> awake;
	awake.reserve(p_input.slots.size());
	const std::span<const GrassStep> steps =
			p_input.species.size() == size_t(_patch->species) ? p_input.species : std::span(&p_input.step, 1);
	const std::span<const StrainSection<float>> sections = _sections.find(steps);
	auto growth = p_input.growth.begin();
	for (const GrassSlot &slot : p_input.slots) {
		const bool is_known = slot.tile.w >= 0 && size_t(slot.tile.w) < _slots.size() && slot.list.x <= GRASS_PATCH_BLADES - BLADES &&
				uint64_t(slot.list.y) + slot.list.z <= p_input.collider_list.size();
		if (!is_known || (slot.list.w & GRASS_SLOT_RETIRED)) {
			continue;
		}
		std::unique_ptr<TileState> &state = _slots[size_t(slot.tile.w)];
		const bool is_fresh = slot.list.w & GRASS_SLOT_FRESH;
		if (!state && !is_fresh) {
			continue;
		}
		if (!state) {
			state = std::make_unique<TileState>();
		}
		state->left_out = whole_groups(slot.blend.y);
		state->sections = takes_strains(slot, p_input) ? sections.data() : nullptr;
		state->is_far = slot.list.w & GRASS_SLOT_FAR;
		const int blades = BLADES - state->left_out;
		_simulated_blades += blades;
		_strain_blades += state->sections != nullptr ? blades : 0;
		for (; growth != p_input.growth.end() && growth->slot < slot.tile.w; ++growth) { // both ascend by slot
			_growth_looks++;
		}
		_growth_looks++;
		awake.push_back({ slot, growth != p_input.growth.end() && growth->slot == slot.tile.w ? &*growth : nullptr });
	}
	p_parallel_for(int(awake.size()), [&](int p_index) { step_slot(awake[size_t(p_index)], p_input, steps, p_step); });
	p_parallel_for(int(p_input.followers.size()), [&](int p_index) { join(p_input.followers[size_t(p_index)]); });
}

// Computes the rest pose: the patch's, grown by the clump at the root, or as a map and species define it (p_growth).
void CpuPool::find_rest(const GrassSlot &p_slot, const GrassStep &p_step, const SlotGrowth *p_growth) {
	TileState &state = *_slots[size_t(p_slot.tile.w)];
	const Eigen::Vector2f tile(float(p_slot.tile.x), float(p_slot.tile.y)), tiles(p_step.field.y, p_step.field.z);
	const ClumpParams params{ p_step.clump.x, p_step.clump.y, p_step.clump.z, p_step.clump.w };
	for (int b = 0; b < BLADES; b++) {
		state.species[b] = p_growth ? std::min(p_growth->species[size_t(b)], uint8_t(_patch->species - 1)) : uint8_t(0);
		const int blade = int(p_slot.list.x) + b + GRASS_PATCH_BLADES * int(state.species[b]);
		const auto texel = [&](int p_knot) {
			const uint16_t *halves = &_patch->texels[Patch::texel_index(blade, p_knot)];
			return Eigen::Vector3f(half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]));
		};
		const Eigen::Vector3f first = texel(0);
		const Eigen::Vector2f place = first.head<2>();
		state.width[0][b] = float(cosine(double(first.z())));
		state.width[1][b] = float(sine(double(first.z())));
		const vec4 growth = p_growth ? p_growth->blades[size_t(b)] : vec4();
		Clump clump = NO_CLUMP;
		if (p_growth) {
			clump.height = growth.x;
			clump.lean = { growth.y, growth.z };
		} else {
			clump = clump_at(root_place(tile, place, tiles, p_step.field.x), params);
		}
		state.root[0][b] = (place.x() - 0.5f) * p_step.field.x;
		state.root[1][b] = growth.w;
		state.root[2][b] = (place.y() - 0.5f) * p_step.field.x;
		for (int k = 0; k < GRASS_KNOTS; k++) {
			const Eigen::Vector3f rest = rest_knot(texel(k), k, clump);
			for (int c = 0; c < 3; c++) {
				state.rest[c][k][b] = rest[c];
			}
		}
	}
}

// [Eq M6] Keeps the shape of blades that were cut or have grown.
void CpuPool::keep_shapes(const GrassSlot &p_slot) {
	TileState &state = *_slots[size_t(p_slot.tile.w)];
	for (int b = 0; b < BLADES; b++) {
		Eigen::Vector3f wanted, found;
		for (int c = 0; c < 3; c++) {
			wanted[c] = state.rest[c][GRASS_CLAMPED_KNOTS + 1][b] - state.rest[c][GRASS_CLAMPED_KNOTS][b];
			found[c] = state.knots[c][1][b] - state.knots[c][0][b];
		}
		const float ratio = wanted.norm() / std::max(found.norm(), 1e-12f);
		if (!(std::abs(ratio - 1.0f) > LEAST_GROWTH)) {
			continue;
		}
		for (int c = 0; c < 3; c++) {
			for (int k = 0; k < GRASS_FREE_KNOTS; k++) {
				state.knots[c][k][b] *= ratio;
				state.before[c][k][b] *= ratio;
			}
		}
	}
}

// Puts every blade at rest.
void CpuPool::wake(const GrassSlot &p_slot) {
	TileState &state = *_slots[size_t(p_slot.tile.w)];
	for (int c = 0; c < 3; c++) {
		std::memcpy(state.knots[c], state.rest[c][GRASS_CLAMPED_KNOTS], sizeof(state.knots[c]));
		std::memcpy(state.before[c], state.rest[c][GRASS_CLAMPED_KNOTS], sizeof(state.before[c]));
	}
	std::memset(state.twist, 0, sizeof(state.twist));
	std::memset(state.calm, 0, sizeof(state.calm));
}

void CpuPool::step_slot(const AwakeSlot &p_awake, const StepInput &p_input, std::span<const GrassStep> p_steps, TileStep p_step) {
	const GrassSlot &record = p_awake.record;
	const bool is_fresh = record.list.w & GRASS_SLOT_FRESH;
	if (is_fresh || p_awake.growth != nullptr) {
		find_rest(record, p_input.step, p_awake.growth);
	}
	if (is_fresh) {
		wake(record);
	} else if (p_awake.growth != nullptr) {
		keep_shapes(record);
	}
	std::vector<TileCollider> colliders;
	colliders.reserve(record.list.z);
	for (const uint32_t index : p_input.collider_list.subspan(record.list.y, record.list.z)) {
		TileCollider collider;
		if (index < p_input.colliders.size() &&
				make_tile_collider(
						p_input.colliders[index], record.tile.x, record.tile.y, p_input.step.field.x, p_input.planes, collider)) {
			colliders.push_back(collider);
		}
	}
	AirLoad air;
	TileState &state = *_slots[size_t(record.tile.w)];
	state.air = record.list.w >> GRASS_SLOT_FORCES != 0 ? &air : nullptr;
	if (state.air != nullptr) {
		find_air_load(state, record, p_input, air);
	}
	const float blend = record.list.w & GRASS_SLOT_SETTLING ? record.blend.x : 0.0f;
	const size_t slot = size_t(record.tile.w);
	_energy[slot] = p_step(state, p_steps, blend, colliders);
	state.air = nullptr;
	_bends[slot] = bend_of(state);
}

void CpuPool::join(const GrassSlot &p_slot) {
	const bool is_known = p_slot.tile.w >= 0 && size_t(p_slot.tile.w) < _slots.size() && _slots[size_t(p_slot.tile.w)];
	if (is_known) {
		const vec4 &blend = p_slot.blend;
		join_blades(*_slots[size_t(p_slot.tile.w)],
				{ BLADES - whole_groups(blend.w), BLADES - whole_groups(blend.z), BLADES - whole_groups(blend.y), blend.x });
	}
}

std::vector<Eigen::Vector3f> CpuPool::get_knots(int p_slot, int p_blade) const {
	if (p_slot < 0 || size_t(p_slot) >= _slots.size() || !_slots[size_t(p_slot)] || p_blade < 0 || p_blade >= BLADES) {
		return {};
	}
	std::vector<Eigen::Vector3f> knots;
	for (int k = 0; k < GRASS_KNOTS; k++) {
		knots.push_back(knot_of(*_slots[size_t(p_slot)], k, p_blade));
	}
	return knots;
}

void CpuPool::set_knots(int p_slot, int p_blade, std::span<const Eigen::Vector3f> p_knots, std::span<const Eigen::Vector3f> p_before) {
	TileState &state = *_slots[size_t(p_slot)];
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		for (int c = 0; c < 3; c++) {
			state.knots[c][k - GRASS_CLAMPED_KNOTS][p_blade] = p_knots[size_t(k)][c];
			state.before[c][k - GRASS_CLAMPED_KNOTS][p_blade] = p_before[size_t(k)][c];
		}
	}
}

void CpuPool::pack_row(int p_slot, std::span<uint16_t> r_texels) const {
	std::fill(r_texels.begin(), r_texels.end(), uint16_t(0));
	if (p_slot < 0 || size_t(p_slot) >= _slots.size() || !_slots[size_t(p_slot)]) {
		return;
	}
	const TileState &state = *_slots[size_t(p_slot)];
	r_texels[3] = float_to_half(float(BLADES - state.left_out));
	for (int b = 0; b < BLADES; b++) {
		for (int k = 1; k < GRASS_KNOTS; k++) {
			uint16_t *texel = &r_texels[size_t((GRASS_POOL_BLADES_PER_ROW * k + b) * 4)];
			const Eigen::Vector3f knot = knot_of(state, k, b);
			for (int c = 0; c < 3; c++) {
				texel[c] = float_to_half(knot[c] - state.rest[c][k][b]);
			}
			texel[3] = float_to_half(k < GRASS_CLAMPED_KNOTS ? 0.0f : state.twist[k - GRASS_CLAMPED_KNOTS][b]);
		}
	}
}

int64_t CpuPool::find_slot_bytes() {
	return int64_t(sizeof(TileState) + sizeof(_slots[0]) + sizeof(_energy[0]) + sizeof(_bends[0]));
}

int64_t CpuPool::get_memory_usage() const {
	const auto used = std::count_if(_slots.begin(), _slots.end(), [](const auto &p_state) { return p_state != nullptr; });
	return int64_t(used) * int64_t(sizeof(TileState)) +
			int64_t(_slots.size() * (sizeof(_slots[0]) + sizeof(_energy[0]) + sizeof(_bends[0])));
}

} // namespace grass

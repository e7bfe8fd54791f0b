// SPDX-License-Identifier: MIT
#include "core/simulate.h"

#include "core/blade.h"
#include "core/half.h"
#include "core/solver.h"

#include <algorithm>
#include <cstring>

#if defined(__x86_64__)
#define GRASS_HAS_AVX2 1
#endif

namespace grass {

// A tile's blades, one after the other within each knot's component, as the GPU's buffers have them. Rest pose and roots
// are made when the tile wakes, the rest changes every step.
struct CpuPool::SlotState {
	alignas(32) float rest[3][GRASS_KNOTS][GRASS_BLADES_PER_TILE]; // metres, blade space
	alignas(32) float knots[3][GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE]; // likewise
	alignas(32) float before[3][GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE]; // one step earlier
	alignas(32) float root[3][GRASS_BLADES_PER_TILE]; // metres from the tile's centre
	uint32_t first_blade; // in the patch
};

namespace {

constexpr int BLADES = GRASS_BLADES_PER_TILE;

template <class T>
constexpr int LANE_COUNT = 1;
template <>
constexpr int LANE_COUNT<Lanes> = Lanes::COUNT;

template <class T>
GRASS_INLINE T load(const float *p_from) {
	return T(*p_from);
}
template <>
GRASS_INLINE Lanes load<Lanes>(const float *p_from) {
	Lanes lanes;
	std::memcpy(&lanes.values, p_from, sizeof(lanes.values));
	return lanes;
}

GRASS_INLINE void store(float p_value, float *r_to) { *r_to = p_value; }
GRASS_INLINE void store(double p_value, float *r_to) { *r_to = float(p_value); }
GRASS_INLINE void store(const Lanes &p_value, float *r_to) { std::memcpy(r_to, &p_value.values, sizeof(p_value.values)); }

template <class T, int N>
GRASS_INLINE Vec3<T> load_knot(const float (&p_from)[3][N][BLADES], int p_knot, int p_blade) {
	return { load<T>(&p_from[0][p_knot][p_blade]), load<T>(&p_from[1][p_knot][p_blade]), load<T>(&p_from[2][p_knot][p_blade]) };
}
template <class T, int N>
GRASS_INLINE void store_knot(const Vec3<T> &p_value, float (&r_to)[3][N][BLADES], int p_knot, int p_blade) {
	store(p_value.x, &r_to[0][p_knot][p_blade]);
	store(p_value.y, &r_to[1][p_knot][p_blade]);
	store(p_value.z, &r_to[2][p_knot][p_blade]);
}

float largest(float p_value) { return p_value; }
float largest(double p_value) { return float(p_value); }
GRASS_INLINE float largest(const Lanes &p_value) {
	float most = p_value[0];
	for (int lane = 1; lane < Lanes::COUNT; lane++) {
		most = std::max(most, p_value[lane]);
	}
	return most;
}

// Steps all blades of a tile; the energy of the liveliest.
template <class T, class State>
GRASS_INLINE float step_blades(State &r_state, const GrassStep &p_step, float p_blend, std::span<const TileCollider> p_colliders) {
	const StepTerms<T> terms = make_terms<T>(p_step, p_blend, p_colliders);
	float liveliest = 0.0f;
	for (int first = 0; first < BLADES; first += LANE_COUNT<T>) {
		Blade<T> blade;
		for (int k = 0; k < GRASS_KNOTS; k++) {
			blade.rest[k] = load_knot<T>(r_state.rest, k, first);
			const int free = k - GRASS_CLAMPED_KNOTS;
			blade.knots[k] = free < 0 ? blade.rest[k] : load_knot<T>(r_state.knots, free, first);
			blade.before[k] = free < 0 ? blade.rest[k] : load_knot<T>(r_state.before, free, first);
		}
		blade.root = { load<T>(&r_state.root[0][first]), load<T>(&r_state.root[1][first]), load<T>(&r_state.root[2][first]) };
		step_blade(blade, terms);
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			store_knot(blade.knots[k], r_state.knots, k - GRASS_CLAMPED_KNOTS, first);
			store_knot(blade.before[k], r_state.before, k - GRASS_CLAMPED_KNOTS, first);
		}
		liveliest = std::max(liveliest, largest(measure_energy(blade, p_step)));
	}
	return liveliest;
}

template <class State>
float step_lanes(State &r_state, const GrassStep &p_step, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_blades<Lanes>(r_state, p_step, p_blend, p_colliders);
}

#ifdef GRASS_HAS_AVX2
// The same arithmetic, bit for bit, in half the instructions.
template <class State>
__attribute__((target("avx2"))) float step_lanes_avx2(State &r_state, const GrassStep &p_step, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_blades<Lanes>(r_state, p_step, p_blend, p_colliders);
}
#endif

template <class State>
float step_state(State &r_state, const GrassStep &p_step, float p_blend, std::span<const TileCollider> p_colliders, Precision p_precision) {
	switch (p_precision) {
		case Precision::SCALAR_FLOAT:
			return step_blades<float>(r_state, p_step, p_blend, p_colliders);
		case Precision::SCALAR_DOUBLE:
			return step_blades<double>(r_state, p_step, p_blend, p_colliders);
		default:
#ifdef GRASS_HAS_AVX2
			if (__builtin_cpu_supports("avx2")) {
				return step_lanes_avx2(r_state, p_step, p_blend, p_colliders);
			}
#endif
			return step_lanes(r_state, p_step, p_blend, p_colliders);
	}
}

} // namespace

void serial_for(int p_count, const std::function<void(int)> &p_body) {
	for (int i = 0; i < p_count; i++) {
		p_body(i);
	}
}

CpuPool::CpuPool(std::shared_ptr<const Patch> p_patch, int p_slots) :
		_patch(std::move(p_patch)), _slots(size_t(std::max(p_slots, 0))), _energy(_slots.size(), 0.0f) {}

CpuPool::~CpuPool() = default;

void CpuPool::step(const StepInput &p_input, const ParallelFor &p_parallel_for, Precision p_precision) {
	std::vector<const GrassSlot *> awake;
	for (const GrassSlot &slot : p_input.slots) {
		const bool is_known = slot.tile.w >= 0 && size_t(slot.tile.w) < _slots.size() && slot.list.x <= GRASS_PATCH_BLADES - BLADES &&
				uint64_t(slot.list.y) + slot.list.z <= p_input.collider_list.size();
		if (!is_known || (slot.list.w & GRASS_SLOT_RETIRED)) {
			continue;
		}
		std::unique_ptr<SlotState> &state = _slots[size_t(slot.tile.w)];
		const bool is_fresh = slot.list.w & GRASS_SLOT_FRESH;
		if (!state && !is_fresh) {
			continue;
		}
		if (!state) {
			state = std::make_unique<SlotState>();
		}
		awake.push_back(&slot);
	}
	p_parallel_for(int(awake.size()), [&](int p_index) { step_slot(*awake[size_t(p_index)], p_input, p_precision); });
	_simulated_blades += int64_t(awake.size()) * BLADES;
}

void CpuPool::wake(const GrassSlot &p_slot, const GrassStep &p_step) {
	SlotState &state = *_slots[size_t(p_slot.tile.w)];
	state.first_blade = p_slot.list.x;
	const Eigen::Vector2f tile(float(p_slot.tile.x), float(p_slot.tile.y)), tiles(p_step.field.y, p_step.field.z);
	const ClumpParams params{ p_step.clump.x, p_step.clump.y, p_step.clump.z, p_step.clump.w };
	for (int b = 0; b < BLADES; b++) {
		const int blade = int(p_slot.list.x) + b;
		const auto texel = [&](int p_knot) {
			const uint16_t *halves = &_patch->texels[Patch::texel_index(blade, p_knot)];
			return Eigen::Vector3f(half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]));
		};
		const Eigen::Vector2f place = texel(0).head<2>();
		const Clump clump = clump_at(root_place(tile, place, tiles, p_step.field.x), params);
		state.root[0][b] = (place.x() - 0.5f) * p_step.field.x;
		state.root[1][b] = 0.0f;
		state.root[2][b] = (place.y() - 0.5f) * p_step.field.x;
		for (int k = 0; k < GRASS_KNOTS; k++) {
			const Eigen::Vector3f rest = rest_knot(texel(k), k, clump);
			for (int c = 0; c < 3; c++) {
				state.rest[c][k][b] = rest[c];
				if (k >= GRASS_CLAMPED_KNOTS) {
					state.knots[c][k - GRASS_CLAMPED_KNOTS][b] = rest[c];
					state.before[c][k - GRASS_CLAMPED_KNOTS][b] = rest[c];
				}
			}
		}
	}
}

void CpuPool::step_slot(const GrassSlot &p_slot, const StepInput &p_input, Precision p_precision) {
	if (p_slot.list.w & GRASS_SLOT_FRESH) {
		wake(p_slot, p_input.step);
	}
	std::vector<TileCollider> colliders;
	colliders.reserve(p_slot.list.z);
	for (const uint32_t index : p_input.collider_list.subspan(p_slot.list.y, p_slot.list.z)) {
		TileCollider collider;
		if (index < p_input.colliders.size() &&
				make_tile_collider(p_input.colliders[index], p_slot.tile.x, p_slot.tile.y, p_input.step.field.x, p_input.planes, collider)) {
			colliders.push_back(collider);
		}
	}
	const float blend = p_slot.list.w & GRASS_SLOT_SETTLING ? p_slot.blend.x : 0.0f;
	const size_t slot = size_t(p_slot.tile.w);
	_energy[slot] = step_state(*_slots[slot], p_input.step, blend, colliders, p_precision);
}

std::vector<Eigen::Vector3f> CpuPool::get_knots(int p_slot, int p_blade) const {
	if (p_slot < 0 || size_t(p_slot) >= _slots.size() || !_slots[size_t(p_slot)] || p_blade < 0 || p_blade >= BLADES) {
		return {};
	}
	const SlotState &state = *_slots[size_t(p_slot)];
	std::vector<Eigen::Vector3f> knots;
	for (int k = 0; k < GRASS_KNOTS; k++) {
		const int free = k - GRASS_CLAMPED_KNOTS;
		const Vec3<float> knot = free < 0 ? load_knot<float>(state.rest, k, p_blade) : load_knot<float>(state.knots, free, p_blade);
		knots.emplace_back(knot.x, knot.y, knot.z);
	}
	return knots;
}

void CpuPool::set_knots(int p_slot, int p_blade, std::span<const Eigen::Vector3f> p_knots, std::span<const Eigen::Vector3f> p_before) {
	SlotState &state = *_slots[size_t(p_slot)];
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
	const SlotState &state = *_slots[size_t(p_slot)];
	for (int b = 0; b < BLADES; b++) {
		for (int k = 1; k < GRASS_KNOTS; k++) {
			uint16_t *texel = &r_texels[size_t((k + GRASS_KNOTS * b) * 4)];
			for (int c = 0; c < 3; c++) {
				texel[c] = float_to_half(k < GRASS_CLAMPED_KNOTS ? state.rest[c][k][b] : state.knots[c][k - GRASS_CLAMPED_KNOTS][b]);
			}
			texel[3] = _patch->texels[Patch::texel_index(int(state.first_blade) + b, k) + 3];
		}
	}
}

int64_t CpuPool::get_memory_usage() const {
	const auto used = std::count_if(_slots.begin(), _slots.end(), [](const auto &p_state) { return p_state != nullptr; });
	return int64_t(used) * int64_t(sizeof(SlotState)) + int64_t(_slots.size() * (sizeof(_slots[0]) + sizeof(float)));
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "gpu/pool_room.h"

#include "core/field/device_fit.h"

#include <utility>

using namespace godot;

namespace grass {

PoolRoom::PoolRoom(int p_slots, const Kind &p_kind) : _slots(p_slots) {
	knots.create(p_slots * SLOT_BYTES);
	halves.create(p_slots * int64_t(sizeof(uint32_t)));
	twists.create(p_slots * TWIST_BYTES);
	energy.create(p_slots * int64_t(sizeof(vec4)));
	growth.create(p_kind.has_growth ? p_slots * GROWTH_BYTES : 0);
	if (p_kind.has_species) {
		blade_species.create(p_slots * SPECIES_BYTES);
	}
	const std::array<bool, ALL_ROWS> has_rows{ true, p_kind.has_motion, p_kind.is_mixed, p_kind.is_mixed };
	for (size_t rows = 0; rows < has_rows.size(); rows++) {
		_rows[rows] = has_rows[rows] ? make_rows(Rows(rows), p_slots) : RID();
	}
}

PoolRoom::~PoolRoom() {
	for (const RID &rows : _rows) {
		if (rows.is_valid()) {
			main_device()->free_rid(rows);
		}
	}
}

void PoolRoom::clear() {
	for (GpuBuffer *buffer : { &knots, &halves, &twists, &energy, &growth, &blade_species }) {
		if (buffer->rid().is_valid()) {
			buffer->clear();
		}
	}
}

int64_t PoolRoom::find_slot_bytes(bool p_is_mixed) {
	return (p_is_mixed ? 4 : 2) * POOL_ROW_BYTES + SLOT_BYTES + TWIST_BYTES + int64_t(sizeof(uint32_t) + sizeof(vec4)) + GROWTH_BYTES +
			SPECIES_BYTES;
}

RID PoolRoom::take_rows(Rows p_rows) {
	const RID made = std::exchange(_rows[size_t(p_rows)], RID());
	return made.is_valid() ? made : make_rows(p_rows, _slots);
}

} // namespace grass

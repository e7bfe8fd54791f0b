// SPDX-License-Identifier: MIT
// The bodies near fields that rest. Until one of them stirs, these fields have nothing to do. One read of a body serves all of them.
#pragma once

#include "core/bodies/body_reads.h"

#include <godot_cpp/variant/transform3d.hpp>

#include <cstdint>
#include <map>
#include <vector>

namespace grass {

// A body that rests, or an area without wind.
struct RestingBody {
	uint64_t object = 0; // instance id: of the node that the body is put to, else of its state in the physics server; or of the area
	godot::Transform3D place; // global

	bool has_stirred(BodyReads &r_reads) const;
};

class RestingBodies {
public:
	// Watches p_body for a field, by its instance id.
	void add(const RestingBody &p_body, uint64_t p_field);
	void remove(uint64_t p_field);
	// Must be called once a tick. Returns the fields near bodies that have moved or left, and near areas that blow.
	std::vector<uint64_t> find_stirred(BodyReads &r_reads);

private:
	// Bodies read in a tick. Fewer: where many rest, the grass notices later that a script moves one.
	static constexpr size_t READS_A_TICK = 128;

	struct Watched {
		RestingBody body;
		std::vector<uint64_t> fields;
	};
	std::map<uint64_t, Watched> _bodies; // by `object`
	std::map<uint64_t, std::vector<uint64_t>> _of_fields; // the bodies of each
	uint64_t _last = 0; // that was read
};

} // namespace grass

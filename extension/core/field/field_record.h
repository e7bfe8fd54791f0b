// SPDX-License-Identifier: MIT
// A file of what happened to a field: for each tick everything that moves its blades, and a hash of the blades afterwards. On the CPU the
// same ticks give the same blades. Parts follow each other, each with its size and checksum, so a file that was cut off is good up to that
// place.
#pragma once

#include "core/blades/force.h"
#include "core/bodies/body_shape.h"
#include "core/field/field_params.h"
#include "core/map/map_file.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace grass {

inline constexpr uint32_t RECORD_VERSION = 1; // of the format
inline constexpr size_t RECORD_PART_MOST = size_t(64) << 20; // bytes of a part, unpacked; no larger one is written or read

// Everything that a tick reads.
struct TickRecord {
	uint32_t number = 0; // ticks of the game since the record began; in some of them the field rests
	double delta = 0.0; // seconds
	int slots = 0; // tiles that may be awake
	FieldParams params;
	std::vector<uint8_t> changes; // of the map since the tick before, as write_changes() writes them
	std::vector<ColliderShape> colliders;
	std::vector<Force> forces;
	uint64_t hash = 0; // of the blades after it; 0: unknown, since they are on a GPU
};

void write_tick(std::vector<uint8_t> &r_bytes, const TickRecord &p_tick);
// Reads the tick at r_at, and moves r_at behind it. Returns false if the bytes are no tick. Repairs numbers that no field can have.
[[nodiscard]] bool read_tick(std::span<const uint8_t> p_bytes, size_t &r_at, TickRecord &r_tick);

bool are_recorded_alike(const FieldParams &p_a, const FieldParams &p_b);

enum class RecordKind : uint32_t {
	FIELD = 1, // a field that was just made, all of it at rest
	TICKS = 2, // ticks of it, one after the other
	END = 3, // why the record ends, as the end of a sentence
};

struct RecordPart {
	RecordKind kind = RecordKind::END;
	std::vector<uint8_t> bytes;
};

std::vector<uint8_t> begin_record(); // the file's first bytes
std::vector<uint8_t> pack_part(RecordKind p_kind, std::span<const uint8_t> p_bytes, const MapCodec &p_codec);

// Reads a file part by part.
class RecordReader {
public:
	// Returns "", or why p_bytes are no record, as the end of a sentence that begins with the file's name.
	std::string open(std::vector<uint8_t> p_bytes);
	// Returns the next part, or nothing at the end. get_end() then says why there is no more.
	std::optional<RecordPart> read(const MapCodec &p_codec);
	const std::string &get_end() const { return _end; } // as the end of a sentence that begins with the file's name
	bool is_complete() const { return _is_complete; } // all that was recorded was read
	bool is_broken() const { return _is_broken; } // not complete, and not only cut off

private:
	std::optional<RecordPart> end(const std::string &p_reason, bool p_is_broken = false);

	std::vector<uint8_t> _bytes;
	size_t _at = 0;
	int _parts = 0; // so far
	std::string _end;
	bool _is_complete = false, _is_broken = false;
};

} // namespace grass

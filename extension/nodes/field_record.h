// SPDX-License-Identifier: MIT
// Writes what happens to a field into a file while a game runs, and plays such a file: docs/guide/recording.md. A record begins with a
// field whose blades all rest. Each time the field is made again, the record describes it again.
#pragma once

#include "core/field/field_record.h"
#include "nodes/field_parts.h"

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/variant/dictionary.hpp>

#include <optional>

namespace grass {

class FieldRecord {
public:
	explicit FieldRecord(FieldParts &p_parts) : _parts(p_parts) {}

	// Record and play, for scripts. The first two make the field again, so that all blades rest, and return an Error. A field of its own
	// plays: it becomes that of the record.
	int64_t record(const godot::String &p_path);
	int64_t play_record(const godot::String &p_path);
	void stop_record();
	godot::Dictionary get_record_state() const;

	bool is_recording() const { return _mode == Mode::RECORDING; }
	bool is_playing() const { return _mode == Mode::PLAYING; }

	// Record a tick. While the field records, they must be called before and after each tick that moves blades, and not between two ticks.
	void begin_tick(
			const FieldParams &p_params, std::span<const ColliderShape> p_colliders, std::span<const Force> p_forces, double p_delta);
	void end_tick();
	// Returns, while it plays, the next tick, which then must be played and compared. Returns nothing while the field is made, at the end,
	// and if a script freed the field: then the caller must return at once.
	std::optional<TickRecord> read_tick();
	void compare(const TickRecord &p_tick);

private:
	enum class Mode { OFF, RECORDING, PLAYING };
	static constexpr const char *NAMES[] = { "off", "recording", "playing" };
	static constexpr int64_t TICKS_A_PART = 60; // fewer: larger files; more: a crash loses more

	bool may_begin(const char *p_method) const;
	void begin(Mode p_mode, const godot::String &p_path);
	void describe();
	bool write(RecordKind p_kind, std::span<const uint8_t> p_bytes);
	void write_ticks();
	bool take_part();
	bool change_map(const TickRecord &p_tick);
	void end(const godot::String &p_message);
	void fail(const godot::String &p_reason);

	FieldParts &_parts;
	Mode _mode = Mode::OFF;
	godot::String _path, _message; // of the record that began last; why it ended
	int64_t _ticks = 0; // written or played
	bool _is_complete = false; // all of a record was played
	godot::Dictionary _described; // the field, as played
	std::optional<TickRecord> _tick; // that is being recorded
	int64_t _making = 0; // of the field that the ticks are of
	uint64_t _first_tick = 0; // the engine's number
	PaintMap _map; // as the record has it

	godot::Ref<godot::FileAccess> _file; // while it records
	int64_t _written = 0; // bytes
	std::vector<uint8_t> _waiting; // ticks that are not in the file yet

	RecordReader _reader; // while it plays
	RecordPart _part; // that is being played
	size_t _at = 0; // in it
	std::optional<FieldParams> _params; // of the tick before
	int64_t _compared = 0, _differs_at = -1; // ticks whose blades could be compared; the first of them with other blades
};

} // namespace grass

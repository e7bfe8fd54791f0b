// SPDX-License-Identifier: MIT
#include "nodes/field_record.h"

#include "core/map/map_changes.h"
#include "nodes/described_field.h"
#include "nodes/grass_field.h"
#include "resources/grass_map_file.h"
#include "resources/map_exchange.h"
#include "resources/size_limits.h"
#include "shared/convert.h"
#include "shared/script_call.h"
#include "shared/text.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include <string_view>
#include <utility>

using namespace godot;

namespace grass {

namespace {

std::span<const uint8_t> bytes_of(std::string_view p_text) {
	return { reinterpret_cast<const uint8_t *>(p_text.data()), p_text.size() };
}

constexpr size_t END_ROOM = 4096; // that other parts leave in a file

String limit_words() {
	return text_of(megabytes(get_record_limit()) + " (the project setting grass_field/limits/record_megabytes)");
}

} // namespace

bool FieldRecord::may_begin(const char *p_method) const {
	const bool is_possible = _parts.node().is_inside_tree() && !Engine::get_singleton()->is_editor_hint() && _parts.properties.simulated;
	ERR_FAIL_COND_V_MSG(!is_possible, false,
			_parts.host.message(
					vformat("%s() needs a field in the scene tree of a running game, with `simulated` on. Call it from _ready() or later.",
							p_method)));
	return true;
}

void FieldRecord::begin(Mode p_mode, const String &p_path) {
	_mode = p_mode;
	_path = p_path;
	_message = String();
	_is_complete = false;
	_ticks = 0;
	_described = Dictionary();
	_tick.reset();
	_params.reset();
	_making = _parts.life.get_makings();
	_first_tick = 0;
	_compared = 0;
	_differs_at = -1;
	_parts.standing.set_whole(true);
	_parts.host.stir();
}

int64_t FieldRecord::record(const String &p_path) {
	if (!may_begin("record")) {
		return ERR_UNCONFIGURED;
	}
	stop_record();
	const Ref<FileAccess> file = FileAccess::open(p_path, FileAccess::WRITE);
	ERR_FAIL_COND_V_MSG(file.is_null(), FileAccess::get_open_error(),
			_parts.host.message(vformat("cannot record into '%s'. Check that the folder exists and can be written to.", p_path)));
	_file = file;
	_waiting.clear();
	const std::vector<uint8_t> head = begin_record();
	_file->store_buffer(to_bytes(std::span(head)));
	_written = int64_t(head.size());
	begin(Mode::RECORDING, p_path);
	_parts.host.request_rebuild();
	return OK;
}

int64_t FieldRecord::play_record(const String &p_path) {
	if (!may_begin("play_record")) {
		return ERR_UNCONFIGURED;
	}
	ERR_FAIL_COND_V_MSG(_parts.sources.get_fill_rule().is_valid(), ERR_UNCONFIGURED,
			_parts.host.message("a record plays in a field of its own. Remove `fill_rule`, or call play_record() of a new field."));
	stop_record();
	const Ref<FileAccess> file = FileAccess::open(p_path, FileAccess::READ);
	ERR_FAIL_COND_V_MSG(file.is_null(), FileAccess::get_open_error(),
			_parts.host.message(vformat("cannot open the record '%s'. Check that the file exists and can be read.", p_path)));
	ERR_FAIL_COND_V_MSG(file->get_length() > get_record_limit(), ERR_FILE_CORRUPT,
			_parts.host.message(vformat("cannot play '%s': the file is larger than %s.", p_path, limit_words())));
	const PackedByteArray bytes = file->get_buffer(int64_t(file->get_length()));
	const String reason = text_of(_reader.open({ bytes.ptr(), bytes.ptr() + bytes.size() }));
	ERR_FAIL_COND_V_MSG(
			!reason.is_empty(), ERR_FILE_UNRECOGNIZED, _parts.host.message(vformat("cannot play '%s': the file %s.", p_path, reason)));
	_part = {};
	_at = 0;
	begin(Mode::PLAYING, p_path);
	return OK;
}

void FieldRecord::stop_record() {
	if (_mode != Mode::OFF) {
		end("was stopped");
	}
}

void FieldRecord::end(const String &p_message) {
	if (_mode == Mode::RECORDING) {
		_mode = Mode::OFF; // what cannot be written ends no record again
		write_ticks();
		const CharString text = p_message.utf8();
		write(RecordKind::END, bytes_of({ text.get_data(), size_t(text.length()) }));
		_file.unref();
	}
	_mode = Mode::OFF;
	_message = p_message;
	_reader = {};
	_part = {};
	_parts.standing.set_whole(false);
	_parts.host.stir();
}

// Ends with an error. p_reason: the end of a sentence that begins with the file.
void FieldRecord::fail(const String &p_reason) {
	ERR_PRINT(_parts.host.message(vformat("cannot play '%s' further: the file %s.", _path, p_reason)));
	end(p_reason);
}

Dictionary FieldRecord::get_record_state() const {
	Dictionary state;
	state["mode"] = NAMES[size_t(_mode)];
	state["path"] = _path;
	state["ticks"] = _ticks;
	state["compared"] = _compared;
	state["differs_at"] = _differs_at;
	state["message"] = _message;
	state["complete"] = _is_complete;
	state["version"] = _described.get("version", "");
	state["engine"] = _described.get("engine", "");
	state["backend"] = _described.get("backend", "");
	return state;
}

// Returns false if the record ends with this.
bool FieldRecord::write(RecordKind p_kind, std::span<const uint8_t> p_bytes) {
	const std::vector<uint8_t> part = pack_part(p_kind, p_bytes, engine_codec());
	const bool is_end = p_kind == RecordKind::END;
	if (_file.is_null()) {
		return false; // the part before was the last one that had room
	}
	if (!is_end && (p_bytes.size() > RECORD_PART_MOST || size_t(_written) + part.size() > get_record_limit() - END_ROOM)) {
		_waiting.clear();
		if (_mode == Mode::RECORDING) {
			end(vformat("reached its limit of %s", limit_words()));
		}
		return false;
	}
	const bool is_stored = _file->store_buffer(to_bytes(std::span(part))) && _file->get_error() == OK;
	_file->flush();
	_written += int64_t(part.size());
	if (!is_stored && _mode == Mode::RECORDING) {
		end("could not be written: check whether the disk is full");
	}
	return is_stored;
}

void FieldRecord::write_ticks() {
	if (!_waiting.empty()) {
		const std::vector<uint8_t> ticks = std::exchange(_waiting, {});
		write(RecordKind::TICKS, ticks);
	}
}

void FieldRecord::describe() {
	write_ticks();
	_making = _parts.life.get_makings();
	_described = describe_field(static_cast<const GrassField &>(_parts.node()));
	const ShownMap *map = _parts.standing.get_map();
	_map = map != nullptr ? map->get_map()->copy() : PaintMap();
	const PackedByteArray bytes = UtilityFunctions::var_to_bytes(_described);
	_described.erase("map");
	write(RecordKind::FIELD, { bytes.ptr(), size_t(bytes.size()) });
}

// Ticks of a field that is about to be made again are left out: none follow from them.
void FieldRecord::begin_tick(
		const FieldParams &p_params, std::span<const ColliderShape> p_colliders, std::span<const Force> p_forces, double p_delta) {
	if (_parts.life.is_waiting()) {
		return;
	}
	if (_making != _parts.life.get_makings()) {
		describe();
	}
	const uint64_t frame = Engine::get_singleton()->get_physics_frames();
	_first_tick = _first_tick == 0 ? frame : _first_tick;
	TickRecord &tick = _tick.emplace();
	tick.number = uint32_t(frame - _first_tick);
	tick.delta = p_delta;
	tick.slots = _parts.standing.get_field().get_tiles().get_limit();
	tick.params = p_params;
	if (const ShownMap *map = _parts.standing.get_map()) {
		PaintMap now = map->get_map()->copy();
		tick.changes = write_changes(_map, now, engine_codec());
		_map = std::move(now);
	}
	tick.colliders.assign(p_colliders.begin(), p_colliders.end());
	tick.forces.assign(p_forces.begin(), p_forces.end());
}

void FieldRecord::end_tick() {
	if (!_tick || _mode != Mode::RECORDING) {
		return;
	}
	_tick->hash = _parts.standing.hash_blades();
	write_tick(_waiting, *_tick);
	_tick.reset();
	if (++_ticks % TICKS_A_PART == 0) {
		write_ticks();
	}
}

// Returns false at the end of the record.
bool FieldRecord::take_part() {
	std::optional<RecordPart> part = _reader.read(engine_codec());
	if (!part) {
		_is_complete = _reader.is_complete();
		_reader.is_broken() ? fail(text_of(_reader.get_end())) : end(text_of(_reader.get_end()));
		return false;
	}
	_part = std::move(*part);
	_at = 0;
	if (_part.kind != RecordKind::FIELD) {
		return true;
	}
	const Variant described = UtilityFunctions::bytes_to_var(to_bytes(std::span<const uint8_t>(_part.bytes)));
	_part = {};
	_params.reset();
	_described = described.get_type() == Variant::DICTIONARY ? Dictionary(described) : Dictionary();
	const String reason =
			_described.is_empty() ? String("describes no field") : become_described(static_cast<GrassField &>(_parts.node()), _described);
	_described.erase("map");
	if (!reason.is_empty()) {
		fail(reason);
	}
	return reason.is_empty();
}

std::optional<TickRecord> FieldRecord::read_tick() {
	while (!_parts.life.is_waiting() && _at == _part.bytes.size()) {
		if (!take_part()) {
			return {};
		}
	}
	if (_parts.life.is_waiting()) {
		return {};
	}
	TickRecord tick;
	if (_described.is_empty() || !grass::read_tick(_part.bytes, _at, tick)) {
		fail("holds a tick that is none");
		return {};
	}
	const bool has_new_params = !_params || !are_recorded_alike(*_params, tick.params);
	_params = tick.params;
	_parts.standing.replay(tick.slots, has_new_params ? &tick.params : nullptr);
	return change_map(tick) ? std::optional(std::move(tick)) : std::nullopt;
}

// Returns false if the record ends with this, or a script freed the field.
bool FieldRecord::change_map(const TickRecord &p_tick) {
	if (p_tick.changes.empty()) {
		return true;
	}
	const ShownMap *shown = _parts.standing.get_map();
	const Ref<GrassMap> map = shown != nullptr ? shown->get_map() : Ref<GrassMap>();
	const PackedByteArray changes = to_bytes(std::span<const uint8_t>(p_tick.changes));
	bool is_changed = false;
	if (!outlives(_parts.node(), [&] { is_changed = map.is_valid() && apply_changes_to(*map.ptr(), changes); })) {
		return false;
	}
	if (!is_changed) {
		fail("holds a change that does not fit its map");
	}
	return is_changed;
}

void FieldRecord::compare(const TickRecord &p_tick) {
	const uint64_t hash = _parts.standing.hash_blades();
	_ticks++;
	if (hash != 0 && p_tick.hash != 0) {
		_compared++;
		_differs_at = hash != p_tick.hash && _differs_at < 0 ? int64_t(p_tick.number) : _differs_at;
	}
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "resources/grass_map.h"

#include "core/map/map_changes.h"
#include "core/map/map_merge.h"
#include "resources/grass_map_file.h"
#include "resources/size_limits.h"
#include "shared/bind_property.h"
#include "shared/convert.h"
#include "shared/main_thread.h"
#include "shared/params.h"
#include "shared/text.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <utility>

using namespace godot;

namespace grass {

namespace {

TypedArray<Vector2i> to_chunks(const std::vector<MapKey> &p_keys) {
	TypedArray<Vector2i> chunks;
	for (const MapKey &key : p_keys) {
		chunks.push_back(Vector2i(key.x, key.z));
	}
	return chunks;
}

} // namespace

String GrassMap::find_refusal() const {
	if (!may_change(*this)) {
		return thread_message(label(), "a change");
	}
	return _unread.is_empty() ? String()
							  : vformat("%s: its data could not be read, so it cannot be changed; the file on disk stays as it is. Call "
										"clear() to start again.",
										label());
}

PaintMap GrassMap::copy() const {
	std::lock_guard lock(_lock);
	return _map;
}

void GrassMap::tell(const std::vector<MapKey> &p_changed, bool p_has_base_changed) {
	if (p_has_base_changed) {
		constexpr real_t REACH = real_t(PaintMap::REACH * MAP_CHUNK_SIZE);
		const Ref<GrassMap> keep(this);
		emit_signal("chunks_changed", to_chunks(p_changed), Rect2(-REACH, -REACH, 2 * REACH, 2 * REACH));
		emit_changed();
		return;
	}
	Rect2 region;
	for (const MapKey &key : p_changed) {
		const Rect2 chunk(Vector2(key.x, key.z) * MAP_CHUNK_SIZE, Vector2(1, 1) * MAP_CHUNK_SIZE);
		region = key == p_changed.front() ? chunk : region.merge(chunk);
	}
	tell(p_changed, region);
}

void GrassMap::tell(const std::vector<MapKey> &p_changed, const Rect2 &p_region) {
	if (!p_changed.empty()) {
		const Ref<GrassMap> keep(this); // a listener may drop the last reference to it
		emit_signal("chunks_changed", to_chunks(p_changed), p_region);
		emit_changed();
	}
}

void GrassMap::tell(const BrushResult &p_result, bool p_has_new_grid) {
	if (p_result.out_of_room) {
		WARN_PRINT(vformat("%s: part of the painting is lost. A map reaches 16,384 m to each side and holds at most %d painted chunks.",
				label(), int64_t(PaintMap::MAX_CHUNKS)));
	}
	if (p_has_new_grid) {
		tell(copy().get_keys(), true);
		return;
	}
	const Eigen::Vector2d size = p_result.max - p_result.min;
	tell(p_result.changed, Rect2(to_godot(p_result.min), to_godot(size)));
}

void GrassMap::set_base_density(double p_density) {
	static constexpr Tunable BASE_DENSITY{ "base_density", "", 0.0, 1.0, 0.01, 0.0 };
	const double density = checked(BASE_DENSITY, p_density, label()), before = get_base_density();
	if (write([&] { _map.set_base_density(density); }) && get_base_density() != before) {
		tell(copy().get_keys(), true);
	}
}

String GrassMap::read(const PackedByteArray &p_bytes) {
	PaintMap now;
	const std::string reason = read_map(std::span(p_bytes.ptr(), size_t(p_bytes.size())), engine_codec(), now, get_read_limits());
	if (!reason.empty()) {
		return text_of(reason);
	}
	replace_by(std::move(now));
	return String();
}

// Replaces the map. Drops any data that could not be read before.
void GrassMap::replace_by(PaintMap &&p_now) {
	PaintMap before = std::move(p_now);
	{
		std::lock_guard lock(_lock);
		std::swap(_map, before);
		_unread.clear();
	}
	tell_of_replacing(before);
}

void GrassMap::set_data(const PackedByteArray &p_data) {
	GRASS_CHANGE_GUARD(label());
	const String reason = read(p_data);
	if (reason.is_empty()) {
		return;
	}
	{
		std::lock_guard lock(_lock);
		_unread = p_data;
	}
	if (get_path().is_empty()) { // a map that is being loaded gets its path later
		callable_mp(this, &GrassMap::_report_unread).call_deferred(reason);
	}
	ERR_FAIL_MSG(vformat("%s: `data` %s.", label(), reason));
}

void GrassMap::_report_unread(const String &p_reason) {
	ERR_FAIL_COND_MSG(!get_path().is_empty(),
			vformat("%s: `data` %s. The map counts as empty, and the data is saved as it is. Load a copy of the file, or call clear() to "
					"start again.",
					label(), p_reason));
}

PackedByteArray GrassMap::get_data() const {
	PaintMap map;
	{
		std::lock_guard lock(_lock);
		if (!_unread.is_empty()) {
			return _unread;
		}
		map = _map;
	}
	return to_bytes(std::span<const uint8_t>(write_map(map, engine_codec())));
}

bool GrassMap::is_empty() const {
	std::lock_guard lock(_lock);
	return _map.is_empty();
}

int64_t GrassMap::get_memory_usage() const {
	std::lock_guard lock(_lock);
	return int64_t(_map.get_memory_usage());
}

Ref<GrassMapSnapshot> GrassMap::take_snapshot() const {
	Ref<GrassMapSnapshot> snapshot;
	snapshot.instantiate();
	snapshot->map = copy();
	return snapshot;
}

void GrassMap::restore_snapshot(const Ref<GrassMapSnapshot> &p_snapshot, const Ref<GrassMapSnapshot> &p_from) {
	ERR_FAIL_COND_MSG(p_snapshot.is_null(), vformat("%s: restore_snapshot() needs a snapshot from take_snapshot().", label()));
	PaintMap before;
	std::string reason;
	const bool is_written = write([&] {
		before = _map;
		if (p_from.is_null()) {
			_map = p_snapshot->map;
		} else {
			reason = merge_maps(p_from->map, p_snapshot->map, _map).reason;
		}
	});
	ERR_FAIL_COND_MSG(!reason.empty(), vformat("%s: the restored map %s.", label(), text_of(reason)));
	if (is_written) {
		tell_of_replacing(before);
	}
}

PackedByteArray GrassMap::get_changes_since(const Ref<GrassMapSnapshot> &p_snapshot) const {
	ERR_FAIL_COND_V_MSG(
			p_snapshot.is_null(), PackedByteArray(), vformat("%s: get_changes_since() needs a snapshot from take_snapshot().", label()));
	return to_bytes(std::span<const uint8_t>(write_changes(p_snapshot->map, copy(), engine_codec())));
}

bool GrassMap::apply_changes(const PackedByteArray &p_changes) {
	if (p_changes.is_empty()) {
		return true; // nothing changed
	}
	AppliedChanges applied;
	const std::span bytes(p_changes.ptr(), size_t(p_changes.size()));
	ReadLimits limits = get_read_limits();
	for (const auto &[shown_by, region] : _shown) {
		limits.regions.push_back(region);
	}
	if (!write([&] { applied = grass::apply_changes(bytes, engine_codec(), _map, limits); })) {
		return false;
	}
	ERR_FAIL_COND_V_MSG(!applied.reason.empty(), false, vformat("%s: these changes %s.", label(), text_of(applied.reason)));
	tell(applied.changed, applied.has_base_changed);
	return true;
}

void GrassMap::tell_of_replacing(const PaintMap &p_before) {
	const std::vector<MapKey> changed = _map.compare(p_before);
	const bool has_base_changed =
			_map.get_base_density() != p_before.get_base_density() || !(_map.get_ground_grid() == p_before.get_ground_grid());
	if (!changed.empty() || has_base_changed) {
		_replacements++;
		tell(changed, has_base_changed);
	}
}

void GrassMap::clear() {
	GRASS_CHANGE_GUARD(label());
	const std::vector<MapKey> changed = copy().get_keys();
	{
		std::lock_guard lock(_lock);
		_unread.clear();
		_map.clear();
	}
	_replacements++;
	tell(changed, false);
}

TypedArray<Vector2i> GrassMap::get_chunks() const {
	return to_chunks(copy().get_keys());
}

void GrassMap::_bind_methods() {
	ClassDB::bind_method(D_METHOD("stroke", "brush", "from", "to"), &GrassMap::stroke);
	ClassDB::bind_method(D_METHOD("sample", "channel", "place", "component"), &GrassMap::sample, DEFVAL(0));
	ClassDB::bind_method(D_METHOD("set_ground", "heights", "region"), &GrassMap::set_ground);
	ClassDB::bind_method(
			D_METHOD("get_channel_image", "channel", "region", "use_floats"), &GrassMap::get_channel_image, DEFVAL(Rect2()), DEFVAL(false));
	ClassDB::bind_method(D_METHOD("set_channel_image", "channel", "image", "region"), &GrassMap::set_channel_image, DEFVAL(Rect2()));
	ClassDB::bind_method(D_METHOD("save_channel_image", "channel", "path", "region"), &GrassMap::save_channel_image, DEFVAL(Rect2()));
	ClassDB::bind_method(D_METHOD("load_channel_image", "channel", "path", "region"), &GrassMap::load_channel_image, DEFVAL(Rect2()));
	ClassDB::bind_method(D_METHOD("fill", "rule", "region"), &GrassMap::fill);
	ClassDB::bind_method(D_METHOD("take_snapshot"), &GrassMap::take_snapshot);
	ClassDB::bind_method(D_METHOD("restore_snapshot", "snapshot", "from"), &GrassMap::restore_snapshot, DEFVAL(Ref<GrassMapSnapshot>()));
	ClassDB::bind_method(D_METHOD("get_changes_since", "snapshot"), &GrassMap::get_changes_since);
	ClassDB::bind_method(D_METHOD("apply_changes", "changes"), &GrassMap::apply_changes);
	ClassDB::bind_method(D_METHOD("merge", "base", "theirs", "prefer_theirs"), &GrassMap::merge, DEFVAL(false));
	ClassDB::bind_static_method("GrassMap", D_METHOD("load_from_file", "path"), &load_map_file);
	ClassDB::bind_method(D_METHOD("save_to_file", "path"), &GrassMap::save_to_file);
	ClassDB::bind_method(D_METHOD("clear"), &GrassMap::clear);
	ClassDB::bind_method(D_METHOD("is_empty"), &GrassMap::is_empty);
	ClassDB::bind_method(D_METHOD("get_chunks"), &GrassMap::get_chunks);
	ClassDB::bind_method(D_METHOD("get_memory_usage"), &GrassMap::get_memory_usage);

	// `data` contains it as well
	GRASS_BIND_PROPERTY(GrassMap, PropertyInfo(Variant::FLOAT, "base_density", PROPERTY_HINT_RANGE, "0,1,0.01", PROPERTY_USAGE_EDITOR),
			set_base_density, get_base_density);
	GRASS_BIND_PROPERTY(
			GrassMap, PropertyInfo(Variant::PACKED_BYTE_ARRAY, "data", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_STORAGE), set_data, get_data);

	ADD_SIGNAL(MethodInfo("chunks_changed", PropertyInfo(Variant::ARRAY, "chunks", PROPERTY_HINT_ARRAY_TYPE, "Vector2i"),
			PropertyInfo(Variant::RECT2, "region", PROPERTY_HINT_NONE, "suffix:m")));

	BIND_ENUM_CONSTANT(CHANNEL_DENSITY);
	BIND_ENUM_CONSTANT(CHANNEL_HEIGHT);
	BIND_ENUM_CONSTANT(CHANNEL_SPECIES);
	BIND_ENUM_CONSTANT(CHANNEL_TINT);
	BIND_ENUM_CONSTANT(CHANNEL_LEAN);
	BIND_ENUM_CONSTANT(CHANNEL_GROUND);
	BIND_ENUM_CONSTANT(CHANNEL_NORMAL);
	BIND_ENUM_CONSTANT(CHANNEL_WEAR);
	BIND_ENUM_CONSTANT(CHANNEL_CUT);
	BIND_ENUM_CONSTANT(CHANNEL_PAINT);
	BIND_ENUM_CONSTANT(CHANNEL_WEAR_REST);
	BIND_ENUM_CONSTANT(CHANNEL_HOLE);
	BIND_ENUM_CONSTANT(CHANNEL_LEDGE);
}

} // namespace grass

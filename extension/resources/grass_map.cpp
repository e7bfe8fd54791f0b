// SPDX-License-Identifier: MIT
#include "resources/grass_map.h"

#include "core/map/map_merge.h"
#include "resources/channel_images.h"
#include "resources/grass_map_file.h"
#include "resources/map_exchange.h"
#include "resources/map_painting.h"
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
	const String refusal = write([&] { _map.set_base_density(density); });
	ERR_FAIL_COND_MSG(!refusal.is_empty(), refusal);
	if (get_base_density() != before) {
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

BrushResult GrassMap::apply(const MapShape &p_shape, const Brush &p_brush) {
	return change([&](PaintMap &r_map) { return apply_brush(r_map, p_shape, p_brush); });
}

double GrassMap::sample(Channel p_channel, const Vector2 &p_place, int64_t p_component) const {
	ERR_FAIL_INDEX_V_MSG(
			int64_t(p_channel), int(MAP_CHANNELS), 0.0, label() + String(": no such channel. Use one of the CHANNEL_* constants."));
	ERR_FAIL_INDEX_V_MSG(
			p_component, int64_t(info_of(MapChannel(p_channel)).components), 0.0, label() + String(": the channel has fewer components."));
	std::lock_guard lock(_lock);
	return _map.sample(MapChannel(p_channel), int(p_component), to_eigen(p_place));
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
	const String refusal = write([&] {
		before = _map;
		if (p_from.is_null()) {
			_map = p_snapshot->map;
		} else {
			reason = merge_maps(p_from->map, p_snapshot->map, _map).reason;
		}
	});
	ERR_FAIL_COND_MSG(!refusal.is_empty(), refusal);
	ERR_FAIL_COND_MSG(!reason.empty(), vformat("%s: the restored map %s.", label(), text_of(reason)));
	tell_of_replacing(before);
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

std::vector<MapRegion> GrassMap::find_shown() const {
	std::vector<MapRegion> regions;
	for (const auto &[shown_by, region] : _shown) {
		regions.push_back(region);
	}
	return regions;
}

TypedArray<Vector2i> GrassMap::get_chunks() const {
	return to_chunks(copy().get_keys());
}

void GrassMap::_bind_methods() {
	bind_free<&stroke>(D_METHOD("stroke", "brush", "from", "to"));
	ClassDB::bind_method(D_METHOD("sample", "channel", "place", "component"), &GrassMap::sample, DEFVAL(0));
	bind_free<&set_ground>(D_METHOD("set_ground", "heights", "region"));
	bind_free<&get_channel_image>(D_METHOD("get_channel_image", "channel", "region", "use_floats"), DEFVAL(Rect2()), DEFVAL(false));
	bind_free<&set_channel_image>(D_METHOD("set_channel_image", "channel", "image", "region"), DEFVAL(Rect2()));
	bind_free<&save_channel_image>(D_METHOD("save_channel_image", "channel", "path", "region"), DEFVAL(Rect2()));
	bind_free<&load_channel_image>(D_METHOD("load_channel_image", "channel", "path", "region"), DEFVAL(Rect2()));
	bind_free<&fill_map>(D_METHOD("fill", "rule", "region"));
	ClassDB::bind_method(D_METHOD("take_snapshot"), &GrassMap::take_snapshot);
	ClassDB::bind_method(D_METHOD("restore_snapshot", "snapshot", "from"), &GrassMap::restore_snapshot, DEFVAL(Ref<GrassMapSnapshot>()));
	bind_free<&find_changes>(D_METHOD("get_changes_since", "snapshot"));
	bind_free<&apply_changes_to>(D_METHOD("apply_changes", "changes"));
	bind_free<&merge_into>(D_METHOD("merge", "base", "theirs", "prefer_theirs"), DEFVAL(false));
	ClassDB::bind_static_method("GrassMap", D_METHOD("load_from_file", "path"), &load_map_file);
	bind_free<&save_map_file>(D_METHOD("save_to_file", "path"));
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

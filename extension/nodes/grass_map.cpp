// SPDX-License-Identifier: MIT
#include "nodes/grass_map.h"

#include "convert.h"
#include "core/map/map_changes.h"
#include "nodes/grass_map_file.h"
#include "nodes/main_thread.h"
#include "nodes/params.h"

#include <algorithm>

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

String GrassMap::label() const {
	return get_path().is_empty() ? String("GrassMap") : vformat("GrassMap '%s'", get_path());
}

bool GrassMap::is_usable() const {
	ERR_FAIL_COND_V_MSG(!may_change(*this), false, thread_message(label(), "a change"));
	ERR_FAIL_COND_V_MSG(!_unread.is_empty(), false,
			vformat("%s: its data could not be read, so it cannot be changed; what is on disk stays as it is. Use clear() to begin anew.",
					label()));
	return true;
}

void GrassMap::tell(const std::vector<MapKey> &p_changed) {
	Rect2 region;
	for (const MapKey &key : p_changed) {
		const Rect2 chunk(Vector2(key.x, key.z) * MAP_CHUNK_SIZE, Vector2(1, 1) * MAP_CHUNK_SIZE);
		region = key == p_changed.front() ? chunk : region.merge(chunk);
	}
	tell(p_changed, region);
}

void GrassMap::tell(const std::vector<MapKey> &p_changed, const Rect2 &p_region) {
	if (!p_changed.empty()) {
		const Ref<GrassMap> keep(this); // a listener may release it
		emit_signal("chunks_changed", to_chunks(p_changed), p_region);
		emit_changed();
	}
}

void GrassMap::tell(const BrushResult &p_result) {
	if (p_result.out_of_room) {
		WARN_PRINT(vformat("%s: some of what was painted is lost. A map reaches 16,384 m to each side and holds at most %d painted chunks.",
				label(), int64_t(PaintMap::MAX_CHUNKS)));
	}
	const Eigen::Vector2d size = p_result.max - p_result.min;
	tell(p_result.changed, Rect2(to_godot(p_result.min), to_godot(size)));
}

void GrassMap::tell_everywhere(const std::vector<MapKey> &p_changed) {
	constexpr real_t REACH = real_t(PaintMap::REACH * MAP_CHUNK_SIZE);
	const Ref<GrassMap> keep(this);
	emit_signal("chunks_changed", to_chunks(p_changed), Rect2(-REACH, -REACH, 2 * REACH, 2 * REACH));
	emit_changed();
}

void GrassMap::set_base_density(double p_density) {
	static constexpr Tunable BASE_DENSITY{ "base_density", "", 0.0, 1.0, 0.01, 0.0 };
	if (is_usable()) {
		_map.set_base_density(checked(BASE_DENSITY, p_density, label()));
		tell_everywhere(_map.get_keys());
	}
}

String GrassMap::read(const PackedByteArray &p_bytes) {
	const PaintMap before = _map;
	const std::string reason = read_map(std::span(p_bytes.ptr(), size_t(p_bytes.size())), engine_codec(), _map);
	if (!reason.empty()) {
		return String(reason.c_str());
	}
	_unread.clear();
	tell_of_replacing(before);
	return String();
}

void GrassMap::set_data(const PackedByteArray &p_data) {
	GRASS_CHANGE_GUARD(label());
	const String reason = read(p_data);
	if (!reason.is_empty()) {
		_unread = p_data;
		ERR_FAIL_MSG(vformat("%s: `data` %s.", label(), reason));
	}
}

PackedByteArray GrassMap::get_data() const {
	return _unread.is_empty() ? to_bytes(std::span<const uint8_t>(write_map(_map, engine_codec()))) : _unread;
}

BrushResult GrassMap::apply(const MapShape &p_shape, const Brush &p_brush) {
	return change([&](PaintMap &r_map) { return apply_brush(r_map, p_shape, p_brush); });
}

bool GrassMap::set_ground(const Ref<Image> &p_heights, const Rect2 &p_region) {
	ERR_FAIL_COND_V_MSG(p_heights.is_null() || p_heights->is_empty(), false,
			vformat("%s: set_ground() needs an image of heights in metres, in its red channel.", label()));
	ERR_FAIL_COND_V_MSG(p_heights->is_compressed(), false,
			vformat("%s: set_ground() cannot read a compressed image. Call decompress() on it, or use FORMAT_RF.", label()));
	ERR_FAIL_COND_V_MSG(!p_region.is_finite() || !p_region.has_area(), false,
			vformat("%s: set_ground() needs a region with a width and a depth, in metres.", label()));
	const int32_t width = p_heights->get_width(), depth = p_heights->get_height();
	const auto texel = [&](double p_i, double p_j) {
		return double(p_heights->get_pixel(int32_t(std::clamp(p_i, 0.0, width - 1.0)), int32_t(std::clamp(p_j, 0.0, depth - 1.0))).r);
	};
	const auto height = [&](const Eigen::Vector2d &p_place) {
		const Eigen::Array2d share = (p_place - to_eigen(p_region.position)).array() / to_eigen(p_region.size).array();
		const Eigen::Array2d at = share * Eigen::Array2d(width, depth) - 0.5, corner = at.floor(), t = at - corner;
		const double near_row = texel(corner.x(), corner.y()) * (1.0 - t.x()) + texel(corner.x() + 1.0, corner.y()) * t.x();
		const double far_row = texel(corner.x(), corner.y() + 1.0) * (1.0 - t.x()) + texel(corner.x() + 1.0, corner.y() + 1.0) * t.x();
		return near_row * (1.0 - t.y()) + far_row * t.y();
	};
	const MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	const bool is_finer =
			std::min(region.max.x() - region.min.x(), region.max.y() - region.min.y()) < GROUND_TEXEL * std::max(width, depth);
	const LedgeSearch search{ is_finer ? HeightAt(height) : nullptr };
	const LaidGround laid =
			change([&](PaintMap &r_map) { return lay_ground(r_map, region, height, MissingGround::STAYS, nullptr, search); });
	return laid.sampled > laid.missing;
}

double GrassMap::stroke(const Ref<GrassBrush> &p_brush, const Vector2 &p_from, const Vector2 &p_to) {
	ERR_FAIL_COND_V_MSG(p_brush.is_null(), 0.0, vformat("%s: a stroke needs a GrassBrush.", label()));
	ERR_FAIL_COND_V_MSG(
			!p_from.is_finite() || !p_to.is_finite(), 0.0, vformat("%s: the ends of a stroke must be finite numbers.", label()));
	const Eigen::Vector2d from = to_eigen(p_from), to = to_eigen(p_to);
	return apply(p_brush->get_stroke(from, to), p_brush->get_brush(from, to)).amount;
}

double GrassMap::sample(Channel p_channel, const Vector2 &p_place, int64_t p_component) const {
	ERR_FAIL_INDEX_V_MSG(int64_t(p_channel), int(MAP_CHANNELS), 0.0, "GrassMap: no such channel. Use one of the CHANNEL_* constants.");
	ERR_FAIL_INDEX_V_MSG(
			p_component, int64_t(info_of(MapChannel(p_channel)).components), 0.0, "GrassMap: the channel has fewer components.");
	return _map.sample(MapChannel(p_channel), int(p_component), to_eigen(p_place));
}

double GrassMap::fill(const Ref<GrassFillRule> &p_rule, const Rect2 &p_region) {
	ERR_FAIL_COND_V_MSG(!p_region.is_finite() || !p_region.has_area(), 0.0,
			vformat("%s: fill() needs a region with a width and a depth, in metres.", label()));
	const MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	const FillRule rule = p_rule.is_valid() ? p_rule->get_rule(region) : FillRule();
	const FillRule *asked = p_rule.is_valid() ? &rule : nullptr;
	return change([&](PaintMap &r_map) { return grass::fill(r_map, chunks_in(region), region, asked, {}); }).amount;
}

Ref<GrassMapSnapshot> GrassMap::take_snapshot() const {
	Ref<GrassMapSnapshot> snapshot;
	snapshot.instantiate();
	snapshot->map = _map;
	return snapshot;
}

void GrassMap::restore_snapshot(const Ref<GrassMapSnapshot> &p_snapshot) {
	ERR_FAIL_COND_MSG(p_snapshot.is_null(), vformat("%s: restore_snapshot() needs what take_snapshot() returned.", label()));
	if (is_usable()) {
		const PaintMap before = _map;
		_map = p_snapshot->map;
		tell_of_replacing(before);
	}
}

PackedByteArray GrassMap::get_changes_since(const Ref<GrassMapSnapshot> &p_snapshot) const {
	ERR_FAIL_COND_V_MSG(
			p_snapshot.is_null(), PackedByteArray(), vformat("%s: get_changes_since() needs what take_snapshot() returned.", label()));
	return to_bytes(std::span<const uint8_t>(write_changes(p_snapshot->map, _map, engine_codec())));
}

bool GrassMap::apply_changes(const PackedByteArray &p_changes) {
	if (p_changes.is_empty()) {
		return true; // nothing changed
	}
	if (!is_usable()) {
		return false;
	}
	const AppliedChanges applied = grass::apply_changes(std::span(p_changes.ptr(), size_t(p_changes.size())), engine_codec(), _map);
	ERR_FAIL_COND_V_MSG(!applied.reason.empty(), false, vformat("%s: these changes %s.", label(), String(applied.reason.c_str())));
	if (applied.has_base_changed) {
		tell_everywhere(applied.changed);
	} else {
		tell(applied.changed);
	}
	return true;
}

void GrassMap::tell_of_replacing(const PaintMap &p_before) {
	const std::vector<MapKey> changed = _map.compare(p_before);
	_replacements++;
	if (_map.get_base_density() != p_before.get_base_density()) {
		tell_everywhere(changed);
	} else {
		tell(changed);
	}
}

void GrassMap::clear() {
	GRASS_CHANGE_GUARD(label());
	const std::vector<MapKey> changed = _map.get_keys();
	_unread.clear();
	_map.clear();
	_replacements++;
	tell(changed);
}

TypedArray<Vector2i> GrassMap::get_chunks() const {
	return to_chunks(_map.get_keys());
}

void GrassMap::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_base_density", "value"), &GrassMap::set_base_density);
	ClassDB::bind_method(D_METHOD("get_base_density"), &GrassMap::get_base_density);
	ClassDB::bind_method(D_METHOD("set_data", "value"), &GrassMap::set_data);
	ClassDB::bind_method(D_METHOD("get_data"), &GrassMap::get_data);
	ClassDB::bind_method(D_METHOD("stroke", "brush", "from", "to"), &GrassMap::stroke);
	ClassDB::bind_method(D_METHOD("sample", "channel", "place", "component"), &GrassMap::sample, DEFVAL(0));
	ClassDB::bind_method(D_METHOD("set_ground", "heights", "region"), &GrassMap::set_ground);
	ClassDB::bind_method(D_METHOD("fill", "rule", "region"), &GrassMap::fill);
	ClassDB::bind_method(D_METHOD("take_snapshot"), &GrassMap::take_snapshot);
	ClassDB::bind_method(D_METHOD("restore_snapshot", "snapshot"), &GrassMap::restore_snapshot);
	ClassDB::bind_method(D_METHOD("get_changes_since", "snapshot"), &GrassMap::get_changes_since);
	ClassDB::bind_method(D_METHOD("apply_changes", "changes"), &GrassMap::apply_changes);
	ClassDB::bind_method(D_METHOD("clear"), &GrassMap::clear);
	ClassDB::bind_method(D_METHOD("is_empty"), &GrassMap::is_empty);
	ClassDB::bind_method(D_METHOD("get_chunks"), &GrassMap::get_chunks);
	ClassDB::bind_method(D_METHOD("get_memory_usage"), &GrassMap::get_memory_usage);

	// `data` holds it, too.
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "base_density", PROPERTY_HINT_RANGE, "0,1,0.01", PROPERTY_USAGE_EDITOR), "set_base_density",
			"get_base_density");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_BYTE_ARRAY, "data", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_STORAGE), "set_data", "get_data");
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

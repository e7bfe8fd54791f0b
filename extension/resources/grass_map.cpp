// SPDX-License-Identifier: MIT
#include "resources/grass_map.h"

#include "core/map/map_changes.h"
#include "resources/grass_map_file.h"
#include "resources/size_limits.h"
#include "shared/convert.h"
#include "shared/label.h"
#include "shared/main_thread.h"
#include "shared/params.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

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
	return label_of(*this);
}

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
	const double density = checked(BASE_DENSITY, p_density, label()), before = get_base_density();
	if (write([&] { _map.set_base_density(density); }) && get_base_density() != before) {
		tell_everywhere(copy().get_keys());
	}
}

String GrassMap::read(const PackedByteArray &p_bytes) {
	PaintMap now;
	const std::string reason = read_map(std::span(p_bytes.ptr(), size_t(p_bytes.size())), engine_codec(), now, get_read_limits());
	if (!reason.empty()) {
		return String(reason.c_str());
	}
	replace_by(std::move(now));
	return String();
}

// What could not be read before is given up.
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
	if (get_path().is_empty()) { // one that is being loaded gets it afterwards
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

// Whether p_region, for p_method, has a size, and lies where a map can hold it.
bool GrassMap::is_region(const char *p_method, const Rect2 &p_region) const {
	ERR_FAIL_COND_V_MSG(!p_region.is_finite() || !p_region.has_area(), false,
			vformat("%s: %s() needs a region with a width and a depth, in metres.", label(), p_method));
	constexpr double REACH = PaintMap::REACH * MAP_CHUNK_SIZE, LARGEST = double(PaintMap::MAX_CHUNKS) * MAP_CHUNK_SIZE * MAP_CHUNK_SIZE;
	const Vector2 end = p_region.get_end();
	ERR_FAIL_COND_V_MSG(p_region.position.x < -REACH || p_region.position.y < -REACH || end.x > REACH || end.y > REACH ||
					p_region.size.x * p_region.size.y > LARGEST,
			false,
			vformat("%s: the region of %s() must lie within 16,384 m to each side and have at most %d square kilometres, the area that a "
					"map can hold.",
					label(), p_method, int64_t(LARGEST * 1e-6)));
	return true;
}

BrushResult GrassMap::apply(const MapShape &p_shape, const Brush &p_brush) {
	return change([&](PaintMap &r_map) { return apply_brush(r_map, p_shape, p_brush); });
}

bool GrassMap::set_ground(const Ref<Image> &p_heights, const Rect2 &p_region) {
	ERR_FAIL_COND_V_MSG(p_heights.is_null() || p_heights->is_empty(), false,
			vformat("%s: set_ground() needs an image of heights in metres, in its red channel.", label()));
	ERR_FAIL_COND_V_MSG(p_heights->is_compressed(), false,
			vformat("%s: set_ground() cannot read a compressed image. Call decompress() on it, or use FORMAT_RF.", label()));
	if (!is_region("set_ground", p_region)) {
		return false;
	}
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

String GrassMap::problem_of_stroke(const Ref<GrassBrush> &p_brush, const Vector2 &p_from, const Vector2 &p_to) {
	if (p_brush.is_null()) {
		return "a stroke needs a GrassBrush.";
	}
	if (!p_from.is_finite() || !p_to.is_finite()) {
		return "the ends of a stroke must be finite numbers.";
	}
	const double length = (to_eigen(p_to) - to_eigen(p_from)).norm();
	return length <= MapShape::MAX_EXTENT ? String()
										  : vformat("the ends of a stroke are %d m apart; at most %d m can be painted at once. Paint it in "
													"pieces.",
													int64_t(std::min(length, 1e15)), int64_t(MapShape::MAX_EXTENT));
}

double GrassMap::stroke(const Ref<GrassBrush> &p_brush, const Vector2 &p_from, const Vector2 &p_to) {
	return stroke_within(p_brush, p_from, p_to, Brush().area);
}

double GrassMap::stroke_within(const Ref<GrassBrush> &p_brush, const Vector2 &p_from, const Vector2 &p_to, const MapRegion &p_area) {
	const String problem = problem_of_stroke(p_brush, p_from, p_to);
	ERR_FAIL_COND_V_MSG(!problem.is_empty(), 0.0, vformat("%s: %s", label(), problem));
	const Eigen::Vector2d from = to_eigen(p_from), to = to_eigen(p_to);
	Brush brush = p_brush->get_brush(from, to);
	brush.area = p_area;
	return apply(p_brush->get_stroke(from, to), brush).amount;
}

double GrassMap::sample(Channel p_channel, const Vector2 &p_place, int64_t p_component) const {
	ERR_FAIL_INDEX_V_MSG(
			int64_t(p_channel), int(MAP_CHANNELS), 0.0, label() + String(": no such channel. Use one of the CHANNEL_* constants."));
	ERR_FAIL_INDEX_V_MSG(
			p_component, int64_t(info_of(MapChannel(p_channel)).components), 0.0, label() + String(": the channel has fewer components."));
	std::lock_guard lock(_lock);
	return _map.sample(MapChannel(p_channel), int(p_component), to_eigen(p_place));
}

double GrassMap::fill(const Ref<GrassFillRule> &p_rule, const Rect2 &p_region) {
	if (!is_region("fill", p_region)) {
		return 0.0;
	}
	const MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	const FillRule rule = p_rule.is_valid() ? p_rule->get_rule(region) : FillRule();
	const FillRule *asked = p_rule.is_valid() ? &rule : nullptr;
	return change([&](PaintMap &r_map) { return grass::fill(r_map, chunks_in(region), region, asked, {}); }).amount;
}

Ref<GrassMapSnapshot> GrassMap::take_snapshot() const {
	Ref<GrassMapSnapshot> snapshot;
	snapshot.instantiate();
	snapshot->map = copy();
	return snapshot;
}

void GrassMap::restore_snapshot(const Ref<GrassMapSnapshot> &p_snapshot) {
	ERR_FAIL_COND_MSG(p_snapshot.is_null(), vformat("%s: restore_snapshot() needs a snapshot from take_snapshot().", label()));
	PaintMap before = p_snapshot->map;
	if (write([&] { std::swap(_map, before); })) {
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
	if (changed.empty() && _map.get_base_density() == p_before.get_base_density()) {
		return;
	}
	_replacements++;
	if (_map.get_base_density() != p_before.get_base_density()) {
		tell_everywhere(changed);
	} else {
		tell(changed);
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
	tell(changed);
}

TypedArray<Vector2i> GrassMap::get_chunks() const {
	return to_chunks(copy().get_keys());
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

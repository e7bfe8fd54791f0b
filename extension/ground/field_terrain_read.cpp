// SPDX-License-Identifier: MIT
// What a field reads of its terrain in a frame.
#include "core/fill/terrain_picture.h"
#include "field/field_view.h"
#include "ground/field_terrain.h"
#include "shared/convert.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/time.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Most places read in a frame (plus a row). More: a terrain of scripts takes the frame's whole share. Less: a field of 1 km^2, a million
// places, takes longer to read.
constexpr int64_t QUERIES_A_FRAME = 16384;
// Places read in a frame even without time left, so that reading always finishes: two rows, or as many as fit in LEAST_TIME (microseconds)
// if a terrain is slow, and always at least one.
constexpr int64_t PLACES_AT_LEAST = 132;
constexpr uint64_t LEAST_TIME = 500;

} // namespace

// Waits until everything is read, since a picture has mipmaps, which change as a whole.
void FieldTerrain::show_colors() {
	const bool is_read = _queue.get_waiting() == 0 && !_piece;
	if (!_colors || (_shown_colors.is_valid() && !is_read && !_has_old_colors) || !_colors->take_changed()) {
		return;
	}
	_has_old_colors = false;
	const std::vector<TerrainColor> texels = picture_of(*_colors);
	const PackedByteArray bytes = to_bytes(std::span(texels));
	const Ref<Image> image = Image::create_from_data(_colors->get_width(), _colors->get_depth(), false, Image::FORMAT_RGBA8, bytes);
	image->generate_mipmaps();
	FrameShare::count_bytes(bytes.size());
	if (_shown_colors.is_valid() && _shown_colors->get_width() == _colors->get_width() &&
			_shown_colors->get_height() == _colors->get_depth()) {
		_shown_colors->update(image);
	} else {
		_shown_colors = ImageTexture::create_from_image(image);
	}
}

// A terrain may report an area, and a change without an area in the same frame: then the areas count.
void FieldTerrain::take_changes() {
	const Transform3D to_field = _field.affine_inverse();
	for (const AABB &area : _areas) {
		const AABB here = moved(to_field, area);
		const MapRegion region{ { here.position.x, here.position.z }, { here.position.x + here.size.x, here.position.z + here.size.z } };
		_queue.add(region.grown(2.0 * info_of(MAP_GROUND).texel_size())); // slopes beside it change too
	}
	if (_is_all_changed && _areas.empty()) {
		_queue.add_all();
		_is_grid_due = true;
	}
	_areas.clear();
	_is_all_changed = false;
}

// Reads the next places of the piece's row: as many as the terrain is queried for at once, so that a slow terrain can be interrupted within
// a row. Returns false if a script freed the field.
bool FieldTerrain::read_places() {
	const std::shared_ptr<TerrainSource> source = _source;
	if (_row.empty()) {
		_row = _piece->get_row();
		_row_samples.clear();
	}
	const size_t begin = _row_samples.size(), count = std::min(source->get_places_at_once(), _row.size() - begin);
	std::vector<Vector3> places;
	for (size_t i = begin; i < begin + count; i++) {
		places.push_back(_field.xform(Vector3(real_t(_row[i].x()), 0, real_t(_row[i].y()))));
	}
	std::vector<TerrainSample> samples(count);
	if (!ask([&] { source->read(places, samples); })) {
		return false;
	}
	if (source != _source || !source->is_alive() || !_piece) { // a method of the terrain removed it, or changed the field
		return true;
	}
	const Eigen::Matrix3d to_field = to_eigen(_field.basis).transpose();
	for (TerrainSample &sample : samples) {
		sample.height -= double(_field.origin.y);
		sample.normal = to_field * sample.normal;
		_row_samples.push_back(sample);
	}
	_queries += int64_t(count);
	if (_row_samples.size() == _row.size()) {
		_piece->put_row(_row_samples);
		_row.clear();
	}
	return true;
}

bool FieldTerrain::lay(const Ref<GrassMap> &p_map, double p_ledge_slope, const std::function<void(const MapRegion &)> &p_touched) {
	const TerrainPiece piece = std::move(*_piece);
	_piece.reset(); // a listener of the map may change the terrain
	const bool has_new_textures = _ids && piece.put_textures(*_ids);
	if (_colors) {
		piece.put_colors(*_colors);
	}
	if (!outlives(_node, [&] { p_map.ptr()->change([&](PaintMap &r_map) { return piece.lay(r_map, p_ledge_slope); }); })) {
		return false;
	}
	if (has_new_textures) {
		p_touched(piece.get_region().grown(0.5 * info_of(MAP_GROUND).texel_size())); // so far the outermost texels reach
	}
	return true;
}

// Lets the map's heights lie where the terrain has its vertices, if all of its ground is this terrain's. Returns false if a script freed
// the field.
bool FieldTerrain::take_grid(const Ref<GrassMap> &p_map) {
	_is_grid_due = false;
	const std::shared_ptr<TerrainSource> source = _source;
	std::optional<GroundGrid> grid;
	if (!ask([&] { grid = source->find_grid(_field); })) {
		return false;
	}
	const PaintMap &map = p_map->get_map();
	if (source != _source || !grid || *grid == map.get_ground_grid() || !is_all_ground_in(map, _queue.get_area())) {
		return true;
	}
	_piece.reset(); // of the grid before
	_row.clear();
	_row_samples.clear();
	_queue.add_all();
	return outlives(_node, [&] {
		p_map.ptr()->change([&](PaintMap &r_map) {
			r_map.set_ground_grid(*grid);
			return BrushResult();
		});
	});
}

// Returns false if nothing waits to be read.
bool FieldTerrain::begin_piece(const GroundGrid &p_grid, std::vector<Eigen::Vector2d> &r_eyes) {
	if (_piece && !(_piece->get_grid() == p_grid)) { // the map was replaced or undone
		_queue.add(_piece->get_region());
		_piece.reset();
		_row.clear();
		_row_samples.clear();
	}
	if (_piece) {
		return true;
	}
	if (r_eyes.empty()) {
		r_eyes = find_eyes_on_ground(&_node, _node.get_layer_mask(), to_eigen(_field));
	}
	const std::optional<MapRegion> region = _queue.take(r_eyes);
	if (region) {
		_piece.emplace(*region, p_grid);
	}
	return region.has_value();
}

// Returns whether one more place may be read in this frame. p_is_first: this is the first field to read in this frame. p_begun, p_since:
// the number of queries and the time at which it began.
bool FieldTerrain::may_go_on(bool p_is_first, int64_t p_begun, uint64_t p_since, FrameShare::Turn &r_turn) const {
	if (_queries >= _last_query) {
		return false;
	}
	const int64_t read = _queries - p_begun;
	const bool is_short = Time::get_singleton()->get_ticks_usec() - p_since < LEAST_TIME;
	return (p_is_first && (read == 0 || (read < PLACES_AT_LEAST && is_short))) || r_turn.has_time();
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): a script that runs meanwhile may drop the field's own map
bool FieldTerrain::read(Ref<GrassMap> p_map, double p_ledge_slope, const std::function<void(const MapRegion &)> &p_touched) {
	take_changes();
	if (!p_map->is_readable()) {
		return true;
	}
	show_colors();
	if (!_piece && _queue.get_waiting() == 0) {
		return true;
	}
	if (_is_grid_due && !take_grid(p_map)) {
		return false;
	}
	if (!_source || !_source->is_alive() || !_node.is_inside_tree()) { // a script removed the terrain or the field
		return true;
	}
	std::vector<Eigen::Vector2d> eyes;
	if (const uint64_t frame = Engine::get_singleton()->get_process_frames(); _frame != frame) { // may run more than once a frame
		_frame = frame;
		_last_query = _queries + QUERIES_A_FRAME;
	}
	static uint64_t frame_of_first = UINT64_MAX; // only the first of all fields has a guaranteed number of places
	const bool is_first = std::exchange(frame_of_first, _frame) != _frame;
	const int64_t begun = _queries;
	FrameShare::Turn turn(this);
	const uint64_t since = Time::get_singleton()->get_ticks_usec();
	while (may_go_on(is_first, begun, since, turn)) {
		if (!begin_piece(p_map->get_map().get_ground_grid(), eyes)) {
			return true;
		}
		if (!_piece->is_complete() && !read_places()) {
			return false;
		}
		if (_piece && _piece->is_complete() && !lay(p_map, p_ledge_slope, p_touched)) {
			return false;
		}
		if (!_source || !_source->is_alive() || !_node.is_inside_tree()) { // a script removed the terrain or the field
			return true;
		}
	}
	return true;
}

} // namespace grass

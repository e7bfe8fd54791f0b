// SPDX-License-Identifier: MIT
#include "ground/field_terrain.h"

#include "shared/convert.h"
#include "core/fill/terrain_picture.h"
#include "draw/frame_share.h"
#include "field/field_view.h"
#include "shared/property_value.h"
#include "shared/script_call.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

// Places read in a frame, at most (a row more). More: a terrain of scripts takes the frame's whole share; less: a field of 1 km^2, a
// million places, takes longer to read.
constexpr int64_t QUERIES_A_FRAME = 16384;
// Rows read in a frame even if it has no time left: the ground comes in the end.
constexpr int ROWS_AT_LEAST = 2;
// The terrain may come, go or get other data without a signal, and move: looked at this often, frames.
constexpr int FRAMES_BETWEEN_QUERIES = 15;
// Heights are vertical: how far a field's up may be from that, sine.
constexpr double LARGEST_TILT = 1e-3;

// A shift of the origin moves both, and costs some last digits.
bool is_same_place(const Transform3D &p_a, const Transform3D &p_b) {
	const Eigen::Affine3d a = to_eigen(p_a), b = to_eigen(p_b);
	return (a.linear() - b.linear()).norm() < 1e-5 && (a.translation() - b.translation()).norm() < 1e-3;
}

bool is_upright(const Transform3D &p_field) {
	const Vector3 up = p_field.basis.get_column(1);
	return std::hypot(double(up.x), double(up.z)) < LARGEST_TILT && up.y > 0.0f;
}

} // namespace

void FieldTerrain::set_path(const NodePath &p_path) {
	(void)replace(_path, p_path);
	forget();
	_problem = String();
	_frames_to_look = 0;
}

void FieldTerrain::forget() {
	if (Object *emitter = _source ? _source->get_emitter() : nullptr) {
		for (const TerrainSource::Notice &notice : _notices) {
			emitter->disconnect(notice.signal, notice.handler);
		}
	}
	_notices.clear();
	_calls_before += _source ? _source->get_calls() : 0;
	_source.reset();
	_ids.reset();
	_colors.reset();
	_shown_colors.unref();
	_queue.clear();
	_piece.reset();
	_areas.clear();
	_is_all_changed = false;
	_beside.reset();
	_beside_when_read.reset();
}

void FieldTerrain::leave() {
	forget();
	_frames_to_look = 0;
}

void FieldTerrain::listen(const TerrainSource::Handlers &p_handlers) {
	Object *emitter = _source->get_emitter();
	for (const TerrainSource::Notice &notice : _source->get_notices(p_handlers)) {
		if (emitter->has_signal(notice.signal)) {
			emitter->connect(notice.signal, notice.handler);
			_notices.push_back(notice);
		}
	}
}

// Runs p_ask, which calls methods of the terrain. Until it returns, the field asks nothing more of it.
template <typename F> bool FieldTerrain::ask(F &&p_ask) {
	_is_asking = true;
	if (!outlives(_node, p_ask)) {
		return false;
	}
	_is_asking = false;
	return true;
}

bool FieldTerrain::find(const TerrainSource::Handlers &p_handlers) {
	_problem = String();
	const NodePath path = _path;
	Node *node = _node.get_node_or_null(path);
	if (node == nullptr || !node->is_inside_tree()) {
		_problem = vformat("`terrain` names no node of the scene: '%s'. Choose the terrain again, or empty it.", String(path));
		forget();
		return true;
	}
	std::shared_ptr<TerrainSource> found;
	String problem;
	if (!ask([&] { found = TerrainSource::find(node, problem); })) {
		return false;
	}
	if (path != _path || (found && _source && found->is_same(*_source))) {
		return true;
	}
	_problem = problem;
	forget();
	_source = found && found->is_alive() ? found : nullptr;
	if (_source) {
		_ids = _source->has_textures() ? std::make_shared<TerrainIds>() : nullptr;
		if (_source->has_colors()) {
			_colors.emplace();
			_colors->set_area(_region);
		}
		listen(p_handlers);
		_is_all_changed = true;
	}
	return true;
}

// A field or a terrain that moves is read again where it has come to rest. Both moved together (a shifted origin): nothing is.
bool FieldTerrain::watch_place(const Transform3D &p_transform, const MapRegion &p_region) {
	const std::shared_ptr<TerrainSource> source = _source;
	Transform3D terrain;
	if (!ask([&] { terrain = source->get_transform(); })) {
		return false;
	}
	if (source != _source) {
		return true;
	}
	const Transform3D beside = terrain.affine_inverse() * p_transform;
	const bool rests = _beside && is_same_place(*_beside, beside);
	if (!_beside_when_read || (rests && !is_same_place(*_beside_when_read, beside))) {
		_beside_when_read = beside;
		_is_all_changed = true;
	}
	_beside = beside;
	_field = p_transform;
	// What the last blades blend with, too.
	const MapRegion area = p_region.grown(info_of(MAP_GROUND).texel_size());
	if (!(_queue.get_area() == area)) {
		_queue.set_area(area);
		_is_all_changed = true;
		if (_colors) {
			_colors->set_area(p_region);
			_has_old_colors = true;
		}
	}
	return true;
}

void FieldTerrain::read_all(bool p_is_elsewhere) {
	_queue.add_all();
	if (_colors && p_is_elsewhere) {
		_colors->clear();
		_has_old_colors = true;
	}
}

// Once all is read: a picture has mipmaps, which change as a whole.
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

bool FieldTerrain::look(const Transform3D &p_transform, const MapRegion &p_region, const TerrainSource::Handlers &p_handlers) {
	_can_read = false;
	if (_path.is_empty() || _is_asking) {
		return true;
	}
	_region = p_region;
	if (--_frames_to_look <= 0 || (_source && !_source->is_alive())) {
		_frames_to_look = FRAMES_BETWEEN_QUERIES;
		if (!find(p_handlers) || (_source && !watch_place(p_transform, p_region))) {
			return false;
		}
	}
	if (_source && !is_upright(p_transform)) {
		_problem = "`terrain` tells vertical heights, but the field is tilted, so nothing of it is laid. Turn the field about its Y axis "
				   "only.";
		return true;
	}
	_can_read = true;
	return true;
}

void FieldTerrain::area_changed(const AABB &p_area) {
	if (p_area.size == Vector3()) {
		_is_all_changed = true;
	} else {
		_areas.push_back(p_area);
	}
}

bool FieldTerrain::cells_changed(const Vector2 &p_first, const Vector2 &p_count) {
	const std::shared_ptr<TerrainSource> source = _source;
	if (source && source->is_alive()) {
		AABB area;
		if (!ask([&] { area = source->to_area(p_first, p_count); })) {
			return false;
		}
		if (area.is_finite()) {
			_areas.push_back(area);
		}
	}
	return true;
}

// A terrain may say where, and in the same frame that something did: then the places count.
void FieldTerrain::take_changes() {
	const Transform3D to_field = _field.affine_inverse();
	for (const AABB &area : _areas) {
		const AABB here = moved(to_field, area);
		const MapRegion region{ { here.position.x, here.position.z }, { here.position.x + here.size.x, here.position.z + here.size.z } };
		_queue.add(region.grown(2.0 * info_of(MAP_GROUND).texel_size())); // slopes beside it change, too
	}
	if (_is_all_changed && _areas.empty()) {
		_queue.add_all();
	}
	_areas.clear();
	_is_all_changed = false;
}

// False, too, where the answers are of no use any more.
bool FieldTerrain::read_row() {
	const std::shared_ptr<TerrainSource> source = _source;
	const std::vector<Eigen::Vector2d> row = _piece->get_row();
	std::vector<Vector3> places;
	for (const Eigen::Vector2d &place : row) {
		places.push_back(_field.xform(Vector3(real_t(place.x()), 0, real_t(place.y()))));
	}
	std::vector<TerrainSample> samples(row.size());
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
	}
	_queries += int64_t(row.size());
	_piece->put_row(samples);
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
		p_touched(piece.get_region());
	}
	return true;
}

// False where nothing waits to be read.
bool FieldTerrain::begin_piece(std::vector<Eigen::Vector2d> &r_eyes) {
	if (_piece) {
		return true;
	}
	if (r_eyes.empty()) {
		r_eyes = find_eyes(&_node, _node.get_layer_mask(), to_eigen(_field));
	}
	const std::optional<MapRegion> region = _queue.take(r_eyes);
	if (region) {
		_piece.emplace(*region);
	}
	return region.has_value();
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
	std::vector<Eigen::Vector2d> eyes;
	if (const uint64_t frame = Engine::get_singleton()->get_process_frames(); _frame != frame) { // may come more than once a frame
		_frame = frame;
		_last_query = _queries + QUERIES_A_FRAME;
	}
	static uint64_t frame_of_rows = UINT64_MAX; // however many fields read: those rows are for one of them, the first
	const int at_least = std::exchange(frame_of_rows, _frame) == _frame ? 0 : ROWS_AT_LEAST;
	FrameShare::Turn turn(this);
	for (int rows = 0; _queries < _last_query && (rows < at_least || turn.has_time()); rows++) {
		if (!begin_piece(eyes)) {
			return true;
		}
		if (!_piece->is_complete() && !read_row()) {
			return false;
		}
		if (_piece && _piece->is_complete() && !lay(p_map, p_ledge_slope, p_touched)) {
			return false;
		}
		if (!_source || !_source->is_alive() || !_node.is_inside_tree()) { // a script removed one of the two
			return true;
		}
	}
	return true;
}

void FieldTerrain::warn(PackedStringArray &r_warnings) const {
	if (!_problem.is_empty()) {
		r_warnings.push_back(_problem);
	}
	if (_source && !_source->get_problem().is_empty()) {
		r_warnings.push_back("`terrain`: " + _source->get_problem());
	}
}

bool FieldTerrain::has_new_warning() {
	const String now = _problem + (_source ? "found " + _source->get_problem() : String()); // other warnings end when it is found
	return std::exchange(_warned, now) != now;
}

void FieldTerrain::add_to(FieldStatistics &r_statistics) const {
	r_statistics.terrain_queries = _queries;
	r_statistics.terrain_calls = _calls_before + (_source ? _source->get_calls() : 0);
	r_statistics.terrain_waiting = _queue.get_waiting() + (_piece ? 1 : 0);
}

int64_t FieldTerrain::get_memory_usage() const {
	const int64_t ids = _ids ? int64_t(_ids->get_memory_usage()) : 0;
	return ids + (_colors ? 2 * int64_t(_colors->get_memory_usage()) : 0); // colours: here, and as a texture
}

} // namespace grass

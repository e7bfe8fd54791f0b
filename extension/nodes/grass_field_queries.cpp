// SPDX-License-Identifier: MIT
// What scripts ask of GrassField: tiles, blades, the grass at a place. Each method checks its arguments and passes them on.
#include "nodes/grass_field.h"

#include "field/work_limits.h"
#include "ground/bare_answer.h"
#include "shared/main_thread.h"

#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

PackedInt64Array to_array(const std::vector<BladeNumber> &p_blades) {
	PackedInt64Array array;
	array.resize(int64_t(p_blades.size()));
	std::ranges::copy(p_blades, array.ptrw());
	return array;
}

std::span<const BladeNumber> span_of(const PackedInt64Array &p_blades) {
	return std::span(p_blades.ptr(), size_t(p_blades.size()));
}

} // namespace

// Whether grass stands, or will as soon as the field is made.
bool GrassField::has_blades() const {
	return _standing.stands() ||
			(is_inside_tree() && _life.is_waiting() && !(_properties.species.prepare_patches() && _properties.species.join()->is_empty()));
}

int64_t GrassField::get_blade_count() const {
	GRASS_MAIN_THREAD_ONLY_V(0);
	return has_blades() ? int64_t(_standing.get_grid().get_tile_count()) * GRASS_BLADES_PER_TILE : 0;
}

Vector2i GrassField::get_grid_size() const {
	GRASS_MAIN_THREAD_ONLY_V(Vector2i());
	const TileGrid grid = _standing.get_grid();
	return has_blades() ? Vector2i(grid.get_tiles_x(), grid.get_tiles_z()) : Vector2i();
}

double GrassField::get_tile_size() const {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	return _standing.get_grid().get_tile_size();
}

Vector2i GrassField::get_tile_at(const Vector3 &p_global_position) const {
	GRASS_MAIN_THREAD_ONLY_V(Vector2i(-1, -1));
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), Vector2i(-1, -1), message("add the node to the scene tree before asking for tiles."));
	return places().get_tile_at(p_global_position);
}

Vector3 GrassField::get_tile_center(const Vector2i &p_tile) const {
	GRASS_MAIN_THREAD_ONLY_V(Vector3());
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), Vector3(), message("add the node to the scene tree before asking for tiles."));
	return places().get_tile_centre(p_tile);
}

bool GrassField::is_tile_awake(const Vector2i &p_tile) const {
	GRASS_MAIN_THREAD_ONLY_V(false);
	const Field &field = _standing.get_field();
	return _standing.stands() && field.get_grid().has_tile(p_tile.x, p_tile.y) &&
			field.get_tiles().is_awake(field.get_grid().get_index(p_tile.x, p_tile.y));
}

int64_t GrassField::get_awake_tile_count() const {
	GRASS_MAIN_THREAD_ONLY_V(0);
	return _standing.stands() ? _standing.get_field().get_tiles().get_statistics().awake : 0;
}

// With an error where it is false.
bool GrassField::has_blades_of(const PackedInt64Array &p_blades) const {
	ERR_FAIL_COND_V_MSG(!_standing.stands(), false, message("there are no blades yet. Ask after the node's first frame in the tree."));
	ERR_FAIL_COND_V_MSG(p_blades.size() > BLADES_MAX, false,
			message(vformat("%d blades were asked for; one call returns %d at most (BLADES_MAX). Ask for them in parts.", p_blades.size(),
					BLADES_MAX)));
	for (const int64_t blade : p_blades) {
		ERR_FAIL_COND_V_MSG(!places().has_blade(blade), false,
				message(vformat("there is no blade %d. Get the numbers of blades from find_blades() or get_tile_blades().", blade)));
	}
	return true;
}

bool GrassField::has_tile(const Vector2i &p_tile) const {
	ERR_FAIL_COND_V_MSG(!_standing.stands(), false, message("there are no blades yet. Ask after the node's first frame in the tree."));
	ERR_FAIL_COND_V_MSG(!_standing.get_grid().has_tile(p_tile.x, p_tile.y), false,
			message("there is no such tile. get_grid_size() returns the number of tiles."));
	return true;
}

// Blades that are read are simulated, even if no camera needs them.
PackedVector3Array GrassField::find_knots(std::span<const BladeNumber> p_blades, FieldPlaces::Knots p_knots) {
	_standing.ask(p_blades);
	return places().find_knots(p_blades, p_knots);
}

PackedVector3Array GrassField::get_knots(const Vector2i &p_tile, int64_t p_blade) {
	GRASS_MAIN_THREAD_ONLY_V(PackedVector3Array());
	ERR_FAIL_INDEX_V_MSG(p_blade, int64_t(GRASS_BLADES_PER_TILE), PackedVector3Array(), message("a tile has 64 blades, 0 to 63."));
	if (!has_tile(p_tile)) {
		return PackedVector3Array();
	}
	const BladeNumber blade = number_of(_standing.get_grid().get_index(p_tile.x, p_tile.y), int(p_blade));
	return find_knots(std::span(&blade, 1), FieldPlaces::Knots::KNOWN);
}

PackedVector3Array GrassField::get_tile_knots(const Vector2i &p_tile) {
	GRASS_MAIN_THREAD_ONLY_V(PackedVector3Array());
	return has_tile(p_tile) ? find_knots(places().blades_of(p_tile), FieldPlaces::Knots::KNOWN) : PackedVector3Array();
}

PackedVector3Array GrassField::get_blade_knots(const PackedInt64Array &p_blades) {
	GRASS_MAIN_THREAD_ONLY_V(PackedVector3Array());
	return has_blades_of(p_blades) ? find_knots(span_of(p_blades), FieldPlaces::Knots::KNOWN) : PackedVector3Array();
}

PackedVector3Array GrassField::wait_for_knots(const PackedInt64Array &p_blades) {
	GRASS_MAIN_THREAD_ONLY_V(PackedVector3Array());
	return has_blades_of(p_blades) ? find_knots(span_of(p_blades), FieldPlaces::Knots::EXACT) : PackedVector3Array();
}

PackedInt64Array GrassField::get_tile_blades(const Vector2i &p_tile) const {
	GRASS_MAIN_THREAD_ONLY_V(PackedInt64Array());
	return has_tile(p_tile) ? to_array(places().blades_of(p_tile)) : PackedInt64Array();
}

PackedInt64Array GrassField::find_blades(const Vector3 &p_global_position, double p_radius) {
	GRASS_MAIN_THREAD_ONLY_V(PackedInt64Array());
	ERR_FAIL_COND_V_MSG(!p_global_position.is_finite() || !(p_radius >= 0.0), PackedInt64Array(),
			message("find_blades() needs a finite position, and a radius in metres of 0 or more."));
	if (!prepare_places()) {
		return PackedInt64Array();
	}
	const int64_t blades = places().count_blades(p_global_position, p_radius);
	ERR_FAIL_COND_V_MSG(blades > BLADES_MAX, PackedInt64Array(),
			message(vformat("find_blades() would look at %d blades; it looks at %d at most (BLADES_MAX). Use a smaller radius.", blades,
					BLADES_MAX)));
	return to_array(places().find_blades(p_global_position, p_radius));
}

int64_t GrassField::get_blade_species(const Vector2i &p_tile, int64_t p_blade) const {
	GRASS_MAIN_THREAD_ONLY_V(0);
	if (!has_tile(p_tile)) {
		return 0;
	}
	ERR_FAIL_INDEX_V_MSG(p_blade, int64_t(GRASS_BLADES_PER_TILE), 0, message("a tile has 64 blades, 0 to 63."));
	return _standing.get_field().get_blades().get_pose(p_tile.x, p_tile.y, int(p_blade)).species;
}

// Before a query: makes the field. False where none stands. What of its map waits to be shown can wait: see StandingField::layers_at().
bool GrassField::prepare_places() {
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), false, message("add the node to the scene tree before asking for its grass."));
	return stand() && _standing.stands();
}

bool GrassField::is_grass_at(const Vector3 &p_global_position) {
	GRASS_MAIN_THREAD_ONLY_V(false);
	return get_density_at(p_global_position) > 0.0;
}

double GrassField::get_density_at(const Vector3 &p_global_position) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	return prepare_places() ? places().density_at(p_global_position) : 0.0;
}

double GrassField::get_height_at(const Vector3 &p_global_position) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	return prepare_places() ? places().height_at(p_global_position) : 0.0;
}

double GrassField::get_cover(const Vector3 &p_from, const Vector3 &p_to) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	ERR_FAIL_COND_V_MSG(!p_from.is_finite() || !p_to.is_finite(), 0.0, message("get_cover() needs finite positions."));
	const double distance = double((p_to - p_from).length());
	ERR_FAIL_COND_V_MSG(distance > double(COVER_DISTANCE_MAX), 0.0,
			message(vformat("get_cover() was asked for %d m; it looks %d m far at most (COVER_DISTANCE_MAX). Nobody sees farther through "
							"grass.",
					int64_t(std::min(distance, 1e15)), COVER_DISTANCE_MAX)));
	return prepare_places() ? places().cover_between(p_from, p_to) : 0.0;
}

double GrassField::get_rustle(const Node3D *p_body) const {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	ERR_FAIL_NULL_V_MSG(p_body, 0.0, message("get_rustle() needs a body or a registered node."));
	const auto layers_at = [this](const Eigen::Vector2f &p_place) { return _standing.layers_at(p_place); };
	return _standing.stands() ? _bodies.find_rustle(_standing.get_field(), layers_at, p_body->get_instance_id()) : 0.0;
}

Vector3 GrassField::get_bend_at(const Vector3 &p_global_position) {
	GRASS_MAIN_THREAD_ONLY_V(Vector3());
	return prepare_places() ? places().bend_at(p_global_position) : Vector3();
}

bool GrassField::has_level_at(const Vector3 &p_global_position) const {
	const Vector3 place = field_transform().affine_inverse().xform(p_global_position);
	const Vector2 size = _properties.size;
	return std::abs(place.x) <= 0.5f * size.x && std::abs(place.z) <= 0.5f * size.y && _properties.ground_band().contains(place.y);
}

// Returns the nearest of the other fields with ground at a place, or null.
GrassField *GrassField::find_other(const Vector3 &p_global_position) const {
	GrassField *nearest = nullptr;
	real_t least = real_t(INFINITY);
	for (GrassField *field : FieldMonitors::get_fields()) {
		const real_t height = std::abs(field->field_transform().affine_inverse().xform(p_global_position).y);
		if (field != this && field->get_world_3d() == get_world_3d() && height < least && field->has_level_at(p_global_position)) {
			nearest = field;
			least = height;
		}
	}
	return nearest;
}

Dictionary GrassField::explain(const Vector3 &p_global_position, const Camera3D *p_camera) {
	GRASS_MAIN_THREAD_ONLY_V(Dictionary());
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), Dictionary(), message("add the node to the scene tree before asking for its grass."));
	const uint64_t given = p_camera != nullptr ? p_camera->get_instance_id() : 0; // a script may free it meanwhile
	if (!stand() || !is_inside_tree() || !_filler.read_meshes(fill_place()) || !is_inside_tree()) {
		return Dictionary();
	}
	const Camera3D *camera = given != 0 ? Object::cast_to<Camera3D>(ObjectDB::get_instance(given)) : get_viewport()->get_camera_3d();
	return to_dictionary(
			explain_place(*this, _standing, _filler, _properties, fill_place(), p_global_position, camera, find_other(p_global_position)));
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "field/field_queries.h"

#include "field/work_limits.h"

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

// Returns whether there are blades, or will be as soon as the field is made.
bool FieldQueries::has_blades() const {
	return _standing.stands() ||
			(_host.node().is_inside_tree() && _life.is_waiting() &&
					!(_properties.species.prepare_patches() && _properties.species.join()->is_empty()));
}

// Returns whether the node is in the tree, and reports an error if not. p_what: what a script asks for.
bool FieldQueries::is_inside(const char *p_what) const {
	ERR_FAIL_COND_V_MSG(
			!_host.node().is_inside_tree(), false, _host.message(vformat("add the node to the scene tree before asking for %s.", p_what)));
	return true;
}

// Makes the field, if there is none yet. Returns whether there is one. What its map has yet to show can wait: StandingField::layers_at().
bool FieldQueries::prepare() {
	return is_inside("its grass") && _host.stand() && _standing.stands();
}

int64_t FieldQueries::get_blade_count() const {
	return has_blades() ? int64_t(_standing.get_grid().get_tile_count()) * GRASS_BLADES_PER_TILE : 0;
}

Vector2i FieldQueries::get_grid_size() const {
	const TileGrid grid = _standing.get_grid();
	return has_blades() ? Vector2i(grid.get_tiles_x(), grid.get_tiles_z()) : Vector2i();
}

std::optional<TilePlace> FieldQueries::get_tile_at(const Vector3 &p_global) const {
	return is_inside("tiles") ? places().find_tile(p_global) : std::nullopt;
}

Vector3 FieldQueries::get_tile_center(const Vector2i &p_tile) const {
	return is_inside("tiles") ? places().get_tile_centre(p_tile) : Vector3();
}

bool FieldQueries::is_tile_awake(const Vector2i &p_tile) const {
	const Field &field = _standing.get_field();
	return _standing.stands() && field.get_grid().has_tile(p_tile.x, p_tile.y) &&
			field.get_tiles().is_awake(field.get_grid().get_index(p_tile.x, p_tile.y));
}

int64_t FieldQueries::get_awake_tile_count() const {
	return _standing.stands() ? _standing.get_field().get_tiles().get_statistics().awake : 0;
}

// Returns whether all these blades exist, and reports an error if not.
bool FieldQueries::has_all(const PackedInt64Array &p_blades) const {
	ERR_FAIL_COND_V_MSG(
			!_standing.stands(), false, _host.message("there are no blades yet. Ask after the node's first frame in the tree."));
	ERR_FAIL_COND_V_MSG(p_blades.size() > BLADES_MAX, false,
			_host.message(vformat("%d blades were asked for; one call returns %d at most (BLADES_MAX). Ask for them in parts.",
					p_blades.size(), BLADES_MAX)));
	for (const int64_t blade : p_blades) {
		ERR_FAIL_COND_V_MSG(!places().has_blade(blade), false,
				_host.message(vformat("there is no blade %d. Get the numbers of blades from find_blades() or get_tile_blades().", blade)));
	}
	return true;
}

// Returns whether the tile exists, and reports an error if not.
bool FieldQueries::has_tile(const Vector2i &p_tile) const {
	ERR_FAIL_COND_V_MSG(
			!_standing.stands(), false, _host.message("there are no blades yet. Ask after the node's first frame in the tree."));
	ERR_FAIL_COND_V_MSG(!_standing.get_grid().has_tile(p_tile.x, p_tile.y), false,
			_host.message("there is no such tile. get_grid_size() returns the number of tiles."));
	return true;
}

// Blades that are read are simulated, even if no camera needs them.
PackedVector3Array FieldQueries::find_knots(std::span<const BladeNumber> p_blades, FieldPlaces::Knots p_knots) {
	_standing.ask(p_blades);
	return places().find_knots(p_blades, p_knots);
}

PackedVector3Array FieldQueries::get_knots(const Vector2i &p_tile, int64_t p_blade) {
	ERR_FAIL_INDEX_V_MSG(p_blade, int64_t(GRASS_BLADES_PER_TILE), PackedVector3Array(), _host.message("a tile has 64 blades, 0 to 63."));
	if (!has_tile(p_tile)) {
		return PackedVector3Array();
	}
	const BladeNumber blade = number_of(_standing.get_grid().get_index(p_tile.x, p_tile.y), int(p_blade));
	return find_knots(std::span(&blade, 1), FieldPlaces::Knots::KNOWN);
}

PackedVector3Array FieldQueries::get_tile_knots(const Vector2i &p_tile) {
	return has_tile(p_tile) ? find_knots(places().blades_of(p_tile), FieldPlaces::Knots::KNOWN) : PackedVector3Array();
}

PackedVector3Array FieldQueries::get_blade_knots(const PackedInt64Array &p_blades) {
	return has_all(p_blades) ? find_knots(span_of(p_blades), FieldPlaces::Knots::KNOWN) : PackedVector3Array();
}

PackedVector3Array FieldQueries::wait_for_knots(const PackedInt64Array &p_blades) {
	return has_all(p_blades) ? find_knots(span_of(p_blades), FieldPlaces::Knots::EXACT) : PackedVector3Array();
}

PackedInt64Array FieldQueries::get_tile_blades(const Vector2i &p_tile) const {
	return has_tile(p_tile) ? to_array(places().blades_of(p_tile)) : PackedInt64Array();
}

PackedInt64Array FieldQueries::find_blades(const Vector3 &p_global, double p_radius) {
	ERR_FAIL_COND_V_MSG(!p_global.is_finite() || !(p_radius >= 0.0), PackedInt64Array(),
			_host.message("find_blades() needs a finite position, and a radius in metres of 0 or more."));
	if (!prepare()) {
		return PackedInt64Array();
	}
	const int64_t blades = places().count_blades(p_global, p_radius);
	ERR_FAIL_COND_V_MSG(blades > BLADES_MAX, PackedInt64Array(),
			_host.message(vformat("find_blades() would look at %d blades; it looks at %d at most (BLADES_MAX). Use a smaller radius.",
					blades, BLADES_MAX)));
	return to_array(places().find_blades(p_global, p_radius));
}

int64_t FieldQueries::get_blade_species(const Vector2i &p_tile, int64_t p_blade) const {
	if (!has_tile(p_tile)) {
		return 0;
	}
	ERR_FAIL_INDEX_V_MSG(p_blade, int64_t(GRASS_BLADES_PER_TILE), 0, _host.message("a tile has 64 blades, 0 to 63."));
	return _standing.get_field().get_blades().get_pose(p_tile.x, p_tile.y, int(p_blade)).species;
}

double FieldQueries::get_density_at(const Vector3 &p_global) {
	return prepare() ? places().density_at(p_global) : 0.0;
}

double FieldQueries::get_height_at(const Vector3 &p_global) {
	return prepare() ? places().height_at(p_global) : 0.0;
}

double FieldQueries::get_cover(const Vector3 &p_from, const Vector3 &p_to) {
	ERR_FAIL_COND_V_MSG(!p_from.is_finite() || !p_to.is_finite(), 0.0, _host.message("get_cover() needs finite positions."));
	const double distance = double((p_to - p_from).length());
	ERR_FAIL_COND_V_MSG(distance > double(COVER_DISTANCE_MAX), 0.0,
			_host.message(vformat("get_cover() was asked for %d m; it looks %d m far at most (COVER_DISTANCE_MAX). Nobody sees farther "
								  "through grass.",
					int64_t(std::min(distance, 1e15)), COVER_DISTANCE_MAX)));
	return prepare() ? places().cover_between(p_from, p_to) : 0.0;
}

double FieldQueries::get_rustle(const Node3D *p_body) const {
	ERR_FAIL_NULL_V_MSG(p_body, 0.0, _host.message("get_rustle() needs a body or a registered node."));
	const auto layers_at = [this](const Eigen::Vector2f &p_place) { return _standing.layers_at(p_place); };
	return _standing.stands() ? _bodies.find_rustle(_standing.get_field(), layers_at, p_body->get_instance_id()) : 0.0;
}

Vector3 FieldQueries::get_bend_at(const Vector3 &p_global) {
	return prepare() ? places().bend_at(p_global) : Vector3();
}

bool FieldQueries::has_level_at(const Vector3 &p_global) const {
	const Vector3 place = _host.field_transform().affine_inverse().xform(p_global);
	const Vector2 size = _properties.size;
	return std::abs(place.x) <= 0.5f * size.x && std::abs(place.z) <= 0.5f * size.y && _properties.ground_band().contains(place.y);
}

} // namespace grass

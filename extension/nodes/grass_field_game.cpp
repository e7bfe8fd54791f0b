// SPDX-License-Identifier: MIT
// What a game asks of the grass and does to it. Places are global; what is done is kept in the field's map.
#include "nodes/grass_field.h"

#include "convert.h"
#include "core/field/grass_at.h"
#include "nodes/ground_sheet.h"
#include "nodes/main_thread.h"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

// The map keeps wear every 0.5 m: a smaller disc can lie between all of them. Metres.
constexpr double SMALLEST_TRAMPLE = 0.36;
// Around a field that is baked as a whole: what its last blades blend with. Metres.
constexpr double BORDER = info_of(MAP_GROUND).texel_size();

} // namespace

// The place in field space. False outside of the field, and where there is none yet.
bool GrassField::find_place(const Vector3 &p_global, Eigen::Vector3d &r_place) {
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), false, message("add the node to the scene tree before asking for its grass."));
	build();
	if (!_backend || !p_global.is_finite()) {
		return false;
	}
	update_map();
	r_place = to_eigen(field_transform()).inverse(Eigen::Isometry) * to_eigen(p_global);
	const TilePlace tile = _field.get_grid().get_place(r_place);
	return r_place.allFinite() && _field.get_grid().has_tile(tile.x, tile.z);
}

// What the map says about a place, as it is now: what the field shows of it, or r_own, where that waits to change. Null without a map.
const MapLayers *GrassField::layers_at(const Eigen::Vector2f &p_place, MapLayers &r_own) const {
	if (_properties.map.is_null()) {
		return nullptr;
	}
	if (_map && _map->get_map() == _properties.map && !_map->get_field().is_waiting_at(p_place)) {
		return _field.get_layers();
	}
	r_own.reset(_field.get_setup().grid, _field.get_setup().blade_length());
	r_own = r_own.read(_properties.map->get_map(), p_place);
	return &r_own;
}

bool GrassField::is_grass_at(const Vector3 &p_global_position) {
	GRASS_MAIN_THREAD_ONLY_V(false);
	return density_at(p_global_position) > 0.0;
}

double GrassField::density_at(const Vector3 &p_global_position) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	Eigen::Vector3d place;
	if (!find_place(p_global_position, place)) {
		return 0.0;
	}
	MapLayers own;
	const Eigen::Vector2f ground(float(place.x()), float(place.z()));
	return grass::density_at(_field, ground, layers_at(ground, own));
}

double GrassField::height_at(const Vector3 &p_global_position) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	Eigen::Vector3d place;
	if (!find_place(p_global_position, place)) {
		return 0.0;
	}
	MapLayers own;
	const Eigen::Vector2f ground(float(place.x()), float(place.z()));
	return grass::height_at(_field, ground, layers_at(ground, own));
}

Vector3 GrassField::bend_at(const Vector3 &p_global_position) {
	GRASS_MAIN_THREAD_ONLY_V(Vector3());
	Eigen::Vector3d place;
	if (density_at(p_global_position) <= 0.0 || !find_place(p_global_position, place)) {
		return Vector3();
	}
	const TilePlace tile = _field.get_grid().get_place(place);
	const Eigen::Vector3d bend = _field.get_tiles().get_bend(_field.get_grid().get_index(tile.x, tile.z)).cast<double>();
	return field_transform().basis.xform(to_godot(bend));
}

// The map that a game changes: a field that has none gets one on which grass stands everywhere, as it did.
GrassMap *GrassField::find_map(const char *p_method) {
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), nullptr, message("add the node to the scene tree first.") + String(" (") + p_method + ")");
	if (_properties.map.is_null()) {
		make_map();
	}
	build();
	return _properties.map.ptr();
}

void GrassField::make_map() {
	Ref<GrassMap> map;
	map.instantiate();
	map->set_base_density(1.0);
	set_map(map);
}

// p_shape null: no footprint, which stands for the whole field. False, with a message, for what is no region.
bool GrassField::find_region(
		const char *p_method, const Ref<Shape3D> &p_shape, const Transform3D &p_transform, std::optional<Footprint> &r_footprint) const {
	if (p_shape.is_null()) {
		return true;
	}
	ColliderShape shape;
	ERR_FAIL_COND_V_MSG(!p_transform.is_finite(), false, message(vformat("%s() needs a transform of finite numbers.", p_method)));
	ERR_FAIL_COND_V_MSG(!pose_shape(p_shape, to_eigen(field_transform()).inverse(Eigen::Isometry) * to_eigen(p_transform), shape), false,
			message(vformat("%s() needs a solid shape: a sphere, box, capsule, cylinder or convex polygon, not a %s.", p_method,
					p_shape->get_class())));
	r_footprint.emplace(shape);
	return true;
}

MowRegion GrassField::mow_region(const std::optional<Footprint> &p_footprint) const {
	return { p_footprint ? &*p_footprint : nullptr, MapRegion::of_grid(_field.get_grid()) };
}

Dictionary GrassField::cut(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	Dictionary result;
	result["area"] = 0.0;
	result["volume"] = 0.0;
	result["blades"] = 0;
	GRASS_MAIN_THREAD_ONLY_V(result);
	std::optional<Footprint> footprint;
	ERR_FAIL_COND_V_MSG(p_shape.is_null(), result, message("cut() needs a shape."));
	GrassMap *map = find_map("cut");
	if (map == nullptr || !_backend || !find_region("cut", p_shape, p_transform, footprint)) {
		return result;
	}
	const CutResult cut = map->change([&](PaintMap &r_map) { return cut_grass(r_map, mow_region(footprint), kind_of(_field)); });
	result["area"] = cut.area;
	result["volume"] = cut.volume;
	result["blades"] = int64_t(std::llround(cut.blades));
	return result;
}

double GrassField::get_mown_share(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	std::optional<Footprint> footprint;
	build();
	if (_properties.map.is_null() || !_backend || !find_region("get_mown_share", p_shape, p_transform, footprint)) {
		return 0.0;
	}
	return mown_share(_properties.map->get_map(), mow_region(footprint), kind_of(_field));
}

void GrassField::regrow(double p_height, double p_wear, const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_COND_MSG(!(p_height >= 0.0) || !(p_wear >= 0.0),
			message("regrow() takes metres that grass grows by and wear that goes, 0 or more each."));
	std::optional<Footprint> footprint;
	build();
	if (_properties.map.is_valid() && _backend && find_region("regrow", p_shape, p_transform, footprint)) {
		_properties.map->change(
				[&](PaintMap &r_map) { return regrow_grass(r_map, mow_region(footprint), kind_of(_field), p_height, p_wear); });
	}
}

double GrassField::paint(const Ref<GrassBrush> &p_brush, const Vector3 &p_from, const Vector3 &p_to) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	GrassMap *map = find_map("paint");
	if (map == nullptr) {
		return 0.0;
	}
	const Transform3D to_field = field_transform().affine_inverse();
	const Vector3 from = to_field.xform(p_from), to = to_field.xform(p_to);
	return map->stroke(p_brush, Vector2(from.x, from.z), Vector2(to.x, to.z));
}

double GrassField::trample(const Vector3 &p_global_position, double p_radius, double p_amount) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	ERR_FAIL_COND_V_MSG(!p_global_position.is_finite() || !(p_radius > 0.0), 0.0,
			message("trample() needs a position, a radius in metres above 0, and how much of the way to bare ground it goes, 0 to 1."));
	GrassMap *map = find_map("trample");
	if (map == nullptr) {
		return 0.0;
	}
	const Eigen::Vector3d place = to_eigen(field_transform()).inverse(Eigen::Isometry) * to_eigen(p_global_position);
	const Eigen::Vector2d centre(place.x(), place.z());
	if (!MapRegion::of_grid(_field.get_grid()).grown(p_radius).contains(centre)) {
		return 0.0;
	}
	Brush brush;
	brush.tool = MapTool::FLATTEN;
	brush.strength = p_amount;
	return map->apply(MapShape::stroke(centre, centre, std::max(p_radius, SMALLEST_TRAMPLE), 0.5, Falloff::SMOOTH), brush).amount;
}

void GrassField::register_collider(Node3D *p_node, const Ref<Shape3D> &p_shape) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_COND_MSG(p_node == nullptr || p_shape.is_null(), message("register_collider() needs a node and its shape."));
	if (_node_colliders.add(p_node, p_shape)) {
		return;
	}
	const String what = vformat("the %s registered for '%s'", p_shape->get_class(), p_node->get_name());
	const bool is_polygon = p_shape->is_class("ConvexPolygonShape3D") || p_shape->is_class("ConcavePolygonShape3D");
	ERR_FAIL_COND_MSG(is_polygon,
			message(vformat(
					"%s encloses no volume. Give it points that do, before it is registered: four at least, not all in a plane.", what)));
	ERR_FAIL_MSG(message(vformat("%s bends no grass. Use a sphere, box, capsule, cylinder or convex polygon.", what)));
}

void GrassField::unregister_collider(Node3D *p_node) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_NULL_MSG(p_node, message("unregister_collider() needs the node."));
	_node_colliders.remove(p_node);
}

MapRegion GrassField::bake_region(const Rect2 &p_region) const {
	if (!p_region.has_area()) {
		const Eigen::Vector2d half = 0.5 * to_eigen(_properties.size);
		return MapRegion{ -half, half }.grown(BORDER);
	}
	return { to_eigen(p_region.position), to_eigen(p_region.get_end()) };
}

int64_t GrassField::lay_ground_by(const MapRegion &p_region, const HeightAt &p_height) {
	GrassMap *map = find_map("bake_ground");
	if (map == nullptr) {
		return 0;
	}
	int64_t found = 0;
	map->change([&](PaintMap &r_map) {
		return lay_ground(r_map, p_region, [&](const Eigen::Vector2d &p_place) {
			const double height = p_height(p_place);
			found += std::isfinite(height) ? 1 : 0;
			return height;
		});
	});
	return found;
}

int64_t GrassField::bake_ground(const Rect2 &p_region, int64_t p_mask) {
	GRASS_MAIN_THREAD_ONLY_V(0);
	ERR_FAIL_COND_V_MSG(!p_region.is_finite(), 0, message("bake_ground() needs a region of finite numbers, or an empty one."));
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), 0, message("add the node to the scene tree before baking its ground."));
	GroundRays rays(get_world_3d(), field_transform(), p_mask);
	ERR_FAIL_COND_V_MSG(!rays.is_usable(), 0,
			message("the physics cannot be asked now. Where it runs on a thread of its own, call bake_ground() in _physics_process()."));
	return lay_ground_by(bake_region(p_region),
			[&](const Eigen::Vector2d &p_place) { return rays.height_at(p_place, -GroundRays::SEARCH_HEIGHT, GroundRays::SEARCH_HEIGHT); });
}

int64_t GrassField::bake_ground_from(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	GRASS_MAIN_THREAD_ONLY_V(0);
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), 0, message("add the node to the scene tree before baking its ground."));
	ERR_FAIL_COND_V_MSG(!p_transform.is_finite(), 0, message("bake_ground_from() needs a transform of finite numbers."));
	ERR_FAIL_COND_V_MSG(!is_ground_shape(p_shape), 0,
			message("bake_ground_from() reads a HeightMapShape3D or a ConcavePolygonShape3D. For other ground, use bake_ground()."));
	const MapRegion region = bake_region(Rect2());
	HeightSheet sheet(region);
	add_ground_shape(sheet, p_shape, to_eigen(field_transform()).inverse(Eigen::Isometry) * to_eigen(p_transform));
	return lay_ground_by(region, [&](const Eigen::Vector2d &p_place) { return sheet.at(p_place); });
}

double GrassField::fill(const Ref<GrassFillRule> &p_rule) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	ERR_FAIL_COND_V_MSG(p_rule.is_null(), 0.0, message("fill() needs a GrassFillRule."));
	if (find_map("fill") == nullptr) {
		return 0.0;
	}
	if (_filler.is_set()) {
		WARN_PRINT(message("fill() while `fill_rule` is live: that rule fills over it as soon as it changes. Turn `fill_live` off."));
	}
	return _filler.fill(_properties.map, p_rule, { this, field_transform(), MapRegion::of_grid(_field.get_grid()) });
}

} // namespace grass

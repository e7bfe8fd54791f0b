// SPDX-License-Identifier: MIT
// What a game asks of the grass and does to it. Places are global; what is done is kept in the field's map.
#include "nodes/grass_field.h"

#include "convert.h"
#include "core/wear/mow.h"
#include "nodes/main_thread.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// The map keeps wear every 0.5 m: a smaller disc can lie between all of them. Metres.
constexpr double SMALLEST_TRAMPLE = 0.36;

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
	const TilePlace tile = _standing.setup.grid.get_place(r_place);
	return r_place.allFinite() && _standing.setup.grid.has_tile(tile.x, tile.z);
}

Growth GrassField::growth_at(const Eigen::Vector2f &p_place, const MapLayers *p_layers) const {
	return p_layers != nullptr ? p_layers->sample(p_place, _standing.setup.follow_slope) : glsl::grass_unpainted(1.0f);
}

GrassKind GrassField::grass_kind() const {
	const double tile = _standing.setup.grid.get_tile_size();
	GrassKind kind{ _standing.setup.patch->mean_height, _standing.setup.blade_length(), GRASS_BLADES_PER_TILE / (tile * tile), {} };
	if (_standing.setup.species) {
		kind.height_at = [this](const Eigen::Vector2d &p_place) { return mean_height_at(p_place.cast<float>(), shown_layers()); };
	}
	return kind;
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
	return growth_at(ground, layers_at(ground, own)).density;
}

double GrassField::height_at(const Vector3 &p_global_position) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	Eigen::Vector3d place;
	if (!find_place(p_global_position, place)) {
		return 0.0;
	}
	MapLayers own;
	const Eigen::Vector2f ground(float(place.x()), float(place.z()));
	const MapLayers *layers = layers_at(ground, own);
	const Growth here = growth_at(ground, layers);
	const double clump = clump_at(ground, _standing.setup.clump).height;
	return here.density > 0.0f ? std::min(mean_height_at(ground, layers) * clump * here.height, double(here.cut)) : 0.0;
}

Vector3 GrassField::bend_at(const Vector3 &p_global_position) {
	GRASS_MAIN_THREAD_ONLY_V(Vector3());
	Eigen::Vector3d place;
	if (density_at(p_global_position) <= 0.0 || !find_place(p_global_position, place)) {
		return Vector3();
	}
	const TilePlace tile = _standing.setup.grid.get_place(place);
	const Eigen::Vector3d bend = _tiles.get_bend(_standing.setup.grid.get_index(tile.x, tile.z)).cast<double>();
	return field_transform().basis.xform(to_godot(bend));
}

// The map that a game changes: a field that has none gets one on which grass stands everywhere, as it did.
GrassMap *GrassField::find_map(const char *p_method) {
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), nullptr, message("add the node to the scene tree first.") + String(" (") + p_method + ")");
	if (_map.is_null()) {
		make_map();
	}
	build();
	return _map.ptr();
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
	return { p_footprint ? &*p_footprint : nullptr, MapRegion::of_grid(_standing.setup.grid) };
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
	const CutResult cut = map->change([&](PaintMap &r_map) { return cut_grass(r_map, mow_region(footprint), grass_kind()); });
	result["area"] = cut.area;
	result["volume"] = cut.volume;
	result["blades"] = int64_t(std::llround(cut.blades));
	return result;
}

double GrassField::get_mown_share(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	std::optional<Footprint> footprint;
	build();
	if (_map.is_null() || !_backend || !find_region("get_mown_share", p_shape, p_transform, footprint)) {
		return 0.0;
	}
	return mown_share(_map->get_map(), mow_region(footprint), grass_kind());
}

void GrassField::regrow(double p_height, double p_wear, const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_COND_MSG(!(p_height >= 0.0) || !(p_wear >= 0.0),
			message("regrow() takes metres that grass grows by and wear that goes, 0 or more each."));
	std::optional<Footprint> footprint;
	build();
	if (_map.is_valid() && _backend && find_region("regrow", p_shape, p_transform, footprint)) {
		_map->change([&](PaintMap &r_map) { return regrow_grass(r_map, mow_region(footprint), grass_kind(), p_height, p_wear); });
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
	if (!MapRegion::of_grid(_standing.setup.grid).grown(p_radius).contains(centre)) {
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

// What time heals in a tick.
void GrassField::recover(double p_delta) {
	const RecoveryRates rates = recovery_rates();
	if (_map.is_valid() && _map->is_readable() && !rates.is_none()) {
		const SharesAt shares = [this](const Eigen::Vector2d &p_place) {
			return _standing.setup.species->get_shares_at(p_place.cast<float>(), shown_layers());
		};
		_map->change([&](PaintMap &r_map) {
			return _recovery.step(r_map, MapRegion::of_grid(_standing.setup.grid), grass_kind(), rates, p_delta,
					_standing.setup.species ? shares : nullptr);
		});
	}
}

// Tells of bodies that met grass in this tick and did not in the one before, and the other way round. Last in a tick: who
// listens may change the field.
void GrassField::tell_of_bodies() {
	std::vector<uint64_t> in_grass;
	for (size_t i = 0; i < _colliders.size(); i++) {
		if (_colliders[i].owner != 0 && _tiles.has_met_grass(i)) {
			in_grass.push_back(_colliders[i].owner);
		}
	}
	std::sort(in_grass.begin(), in_grass.end());
	in_grass.erase(std::unique(in_grass.begin(), in_grass.end()), in_grass.end());
	in_grass.swap(_in_grass); // now those of the tick before
	const std::vector<uint64_t> now = _in_grass;
	const auto tell = [this](const char *p_signal, const std::vector<uint64_t> &p_ids, const std::vector<uint64_t> &p_others) {
		for (const uint64_t id : p_ids) {
			Node3D *body = Object::cast_to<Node3D>(ObjectDB::get_instance(id));
			if (body != nullptr && !std::binary_search(p_others.begin(), p_others.end(), id)) {
				emit_signal(p_signal, body);
			}
		}
	};
	tell("body_exited_grass", in_grass, now);
	tell("body_entered_grass", now, in_grass);
}

// Where the grass goes, nobody is in it any more.
void GrassField::tell_of_leaving() {
	std::vector<uint64_t> bodies;
	bodies.swap(_in_grass);
	for (const uint64_t id : bodies) {
		if (Node3D *body = Object::cast_to<Node3D>(ObjectDB::get_instance(id))) {
			emit_signal("body_exited_grass", body);
		}
	}
}

} // namespace grass

// SPDX-License-Identifier: MIT
#include "field/field_work.h"

#include "core/field/grass_at.h"
#include "field/work_limits.h"
#include "physics/grid_search.h"
#include "physics/ground_rays.h"
#include "physics/ground_sheet.h"
#include "physics/node_colliders.h"
#include "resources/map_painting.h"
#include "shared/convert.h"
#include "shared/params.h"
#include "shared/script_call.h"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

// The map keeps wear every 0.5 m: a smaller disc can lie between all of them. Metres.
constexpr double SMALLEST_TRAMPLE = 0.36;
// A boot treads with 0.2 m, a giant's with some metres. Metres.
constexpr Tunable TRAMPLE_RADIUS{ "radius", "m", 0.0, 64.0, 0.01, 0.2 };
// The share of the way to trampled bare. The map keeps wear in 255 steps: below a half of one nothing changes.
constexpr Tunable TRAMPLE_AMOUNT{ "amount", "", 0.0, 1.0, 0.001, 0.03 };
// Around a field that is baked as a whole: what its last blades blend with. Metres.
constexpr double GROUND_BORDER = info_of(MAP_GROUND).texel_size();

// Returns the area of the rectangle around a region, m^2.
double area_of(const MowRegion &p_region) {
	const MapRegion box = p_region.footprint == nullptr
			? p_region.rectangle
			: p_region.rectangle.shared({ p_region.footprint->get_min(), p_region.footprint->get_max() });
	return box.has_area() ? (box.max - box.min).prod() : 0.0;
}

} // namespace

Eigen::Affine3d FieldWork::to_field() const {
	return to_eigen(_host.field_transform()).inverse(Eigen::Isometry);
}

// Finds the footprint of a shape; a null shape has none, which means the whole field. Returns false and reports an error if the shape
// or its transform cannot be used. Returns false without an error if the shape is outside the band of the field's ground.
bool FieldWork::find_region(
		const char *p_method, const Ref<Shape3D> &p_shape, const Transform3D &p_transform, std::optional<Footprint> &r_footprint) const {
	if (p_shape.is_null()) {
		return true;
	}
	ColliderShape shape;
	ERR_FAIL_COND_V_MSG(!p_transform.is_finite(), false, _host.message(vformat("%s() needs a finite transform.", p_method)));
	ERR_FAIL_COND_V_MSG(!pose_shape(p_shape, to_field() * to_eigen(p_transform), shape), false,
			_host.message(vformat("%s() needs a solid shape: a sphere, box, capsule, cylinder or convex polygon, not a %s.", p_method,
					p_shape->get_class())));
	r_footprint.emplace(shape);
	const Bounds bounds = shape.get_swept_bounds();
	return _properties.ground_band().meets(bounds.min.y(), bounds.max.y());
}

// Reports an error if it is. A call that is refused does nothing at all.
bool FieldWork::is_too_large(const char *p_method, double p_area, int64_t p_most, const char *p_remedy) const {
	const char *limit = p_most == AREA_MAX ? "AREA_MAX" : "RAYS_AREA_MAX";
	ERR_FAIL_COND_V_MSG(p_area > double(p_most), true,
			_host.message(vformat(
					"%s() would act on %.0f square metres, and acts on %d at most (%s). %s", p_method, p_area, p_most, limit, p_remedy)));
	return false;
}

bool FieldWork::is_too_large(const char *p_method, const std::optional<Footprint> &p_footprint) const {
	return is_too_large(p_method, area_of(mow_region(p_footprint)), AREA_MAX, "Call it with several smaller shapes, in as many frames.");
}

double FieldWork::find_area(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) const {
	ColliderShape shape;
	if (!_standing.stands() || p_shape.is_null() || !p_transform.is_finite() ||
			!pose_shape(p_shape, to_field() * to_eigen(p_transform), shape)) {
		return 0.0;
	}
	const std::optional<Footprint> footprint(shape);
	return area_of(mow_region(footprint));
}

MowRegion FieldWork::mow_region(const std::optional<Footprint> &p_footprint) const {
	return { p_footprint ? &*p_footprint : nullptr, field_region() };
}

CutResult FieldWork::cut(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	std::optional<Footprint> footprint;
	ERR_FAIL_COND_V_MSG(p_shape.is_null(), {}, _host.message("cut() needs a shape."));
	if (!_host.stand()) {
		return {};
	}
	if (_standing.stands() && (!find_region("cut", p_shape, p_transform, footprint) || is_too_large("cut", footprint))) {
		return {};
	}
	GrassMap *map = _host.need_map("cut");
	if (map == nullptr || !_standing.stands()) {
		return {};
	}
	return map->change([&](PaintMap &r_map) { return cut_grass(r_map, mow_region(footprint), kind_of(_standing.get_field())); });
}

double FieldWork::get_mown_share(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	std::optional<Footprint> footprint;
	if (!_host.stand() || _properties.map.is_null() || !_standing.stands() ||
			!find_region("get_mown_share", p_shape, p_transform, footprint) || is_too_large("get_mown_share", footprint)) {
		return 0.0;
	}
	return mown_share(_properties.map->get_map(), mow_region(footprint), kind_of(_standing.get_field()));
}

void FieldWork::regrow(double p_height, double p_wear, const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	ERR_FAIL_COND_MSG(!(p_height >= 0.0) || !(p_wear >= 0.0),
			_host.message("regrow() needs a growth in metres and a reduction of wear, each 0 or more."));
	std::optional<Footprint> footprint;
	if (_host.stand() && _properties.map.is_valid() && _standing.stands() && find_region("regrow", p_shape, p_transform, footprint) &&
			!is_too_large("regrow", footprint)) {
		_properties.map.ptr()->change([&](PaintMap &r_map) {
			return regrow_grass(r_map, mow_region(footprint), kind_of(_standing.get_field()), p_height, p_wear);
		});
	}
}

double FieldWork::paint(const Ref<GrassBrush> &p_brush, const Vector3 &p_from, const Vector3 &p_to) {
	GrassMap *map = _host.need_map("paint");
	if (map == nullptr) {
		return 0.0;
	}
	const Transform3D to_field = _host.field_transform().affine_inverse();
	const Vector3 from = to_field.xform(p_from), to = to_field.xform(p_to);
	const Vector2 start(from.x, from.z), end(to.x, to.z);
	const String problem = problem_of_stroke(p_brush, start, end);
	ERR_FAIL_COND_V_MSG(!problem.is_empty(), 0.0, _host.message("paint(): " + problem));
	const GroundBand band = _properties.ground_band();
	if (!band.meets(std::min(from.y, to.y), std::max(from.y, to.y))) {
		return 0.0;
	}
	return stroke_within(*map, p_brush, start, end, ground().grown(p_brush->get_reach() + MAP_CHUNK_SIZE));
}

double FieldWork::trample(const Vector3 &p_global, double p_radius, double p_amount) {
	ERR_FAIL_COND_V_MSG(!p_global.is_finite() || !(p_radius > 0.0) || !(p_amount >= 0.0), 0.0,
			_host.message("trample() needs a finite position, a radius in metres above 0, and an amount from 0 to 1."));
	GrassMap *map = _host.need_map("trample");
	if (map == nullptr) {
		return 0.0;
	}
	const Eigen::Vector3d place = to_field() * to_eigen(p_global);
	if (!_properties.ground_band().contains(place.y())) {
		return 0.0;
	}
	const Eigen::Vector2d centre(place.x(), place.z());
	const double radius = checked(TRAMPLE_RADIUS, p_radius, _host.label());
	Brush brush;
	brush.area = ground().grown(info_of(MAP_WEAR).texel_size());
	if (!brush.area.grown(radius).contains(centre)) {
		return 0.0;
	}
	brush.tool = MapTool::FLATTEN;
	brush.strength = checked(TRAMPLE_AMOUNT, p_amount, _host.label());
	return map->apply(MapShape::stroke(centre, centre, std::max(radius, SMALLEST_TRAMPLE), 0.5, Falloff::SMOOTH), brush).amount;
}

bool FieldWork::wear_tracks(const VehicleWheels &p_wheels, double p_delta) {
	const double wear = _properties.param(PARAM_WHEEL_WEAR) * p_delta;
	const std::vector<VehicleWheels::Slip> slips = wear > 0.0 ? p_wheels.find_slips() : std::vector<VehicleWheels::Slip>();
	for (const VehicleWheels::Slip &slip : slips) {
		if (!outlives(_host.node(), [&] { trample(slip.place, slip.radius, std::min(wear * slip.share, 1.0)); })) {
			return false;
		}
		if (!_host.node().is_inside_tree()) {
			break;
		}
	}
	return true;
}

void FieldWork::recover(double p_delta) {
	const RecoveryRates rates = _properties.recovery_rates(_standing.get_species());
	const Ref<GrassMap> &map = _properties.map;
	if (map.is_null() || !map->is_readable() || rates.is_none()) {
		return;
	}
	const Field &field = _standing.get_field();
	const SharesAt shares = [&field](const Eigen::Vector2d &p_place) {
		return field.get_setup().species->get_shares_at(p_place.cast<float>(), field.get_layers());
	};
	map.ptr()->change([&](PaintMap &r_map) {
		return _recovery.step(r_map, field_region(), kind_of(field), rates, p_delta, field.get_setup().species ? shares : nullptr);
	});
}

// Returns the ground of the field, made or not.
MapRegion FieldWork::ground() const {
	const Eigen::Vector2d half = 0.5 * to_eigen(_properties.size);
	return { -half, half };
}

// Returns the part of p_region that is at the field; nothing, with an error, if no part is.
std::optional<MapRegion> FieldWork::bake_region(const Rect2 &p_region) const {
	const MapRegion whole = ground().grown(GROUND_BORDER);
	if (!p_region.has_area()) {
		return whole;
	}
	const MapRegion shared = whole.shared({ to_eigen(p_region.position), to_eigen(p_region.get_end()) });
	ERR_FAIL_COND_V_MSG((shared.min.array() >= shared.max.array()).any(), {},
			_host.message("the region of bake_ground() is outside of the field. Give it in metres from the field's centre."));
	return shared;
}

// Returns the grid by which ground is laid in p_region: the found one, unless the map keeps other ground.
GroundGrid FieldWork::grid_for(const MapRegion &p_region, const GroundGrid &p_found) const {
	const bool is_free = _properties.map.is_null() || is_all_ground_in(_properties.map->get_map(), p_region);
	return is_free ? p_found : _properties.map->get_map().get_ground_grid();
}

int64_t FieldWork::lay_ground_by(const MapRegion &p_region, const GroundGrid &p_grid, const HeightAt &p_height, const HeightAt &p_between) {
	GrassMap *map = _host.need_map("bake_ground");
	if (map == nullptr) {
		return 0;
	}
	int64_t found = 0;
	const MapRegion told = p_region.grown(GROUND_BORDER); // texels farther away are read for ledges alone, and do not count
	map->change([&](PaintMap &r_map) {
		const auto height = [&](const Eigen::Vector2d &p_place) {
			const double here = p_height(p_place);
			found += told.contains(p_place) && std::isfinite(here) ? 1 : 0;
			return continued_ground(here, p_height, ground(), p_place);
		};
		const auto between = [&](const Eigen::Vector2d &p_place) {
			return continued_ground(p_between(p_place), p_between, ground(), p_place);
		};
		r_map.set_ground_grid(p_grid);
		return lay_ground(r_map, p_region, height, MissingGround::STAYS, nullptr, { between, _properties.param(PARAM_LEDGE_SLOPE) });
	});
	return found;
}

// Reads the ground. p_is_bounded: at most RAYS_AREA_MAX, as for scripts.
int64_t FieldWork::bake(const Rect2 &p_region, int64_t p_mask, bool p_is_bounded) {
	ERR_FAIL_COND_V_MSG(!p_region.is_finite(), 0, _host.message("bake_ground() needs a finite region, or an empty one."));
	ERR_FAIL_COND_V_MSG(!_host.node().is_inside_tree(), 0, _host.message("add the node to the scene tree before baking its ground."));
	ERR_FAIL_COND_V_MSG(_properties.ground_band().is_empty(), 0,
			_host.message("bake_ground() finds nothing: `ground_low` is not below `ground_high`. Lower it, or raise `ground_high`."));
	GroundRays rays(_host.node().get_world_3d(), _host.field_transform(), p_mask);
	rays.stand(_host.node());
	rays.keep_within(_properties.ground_band());
	ERR_FAIL_COND_V_MSG(!rays.is_usable(), 0,
			_host.message("the physics space is locked now. If physics runs on a thread of its own, call bake_ground() in "
						  "_physics_process()."));
	const std::optional<MapRegion> region = bake_region(p_region);
	if (!region ||
			(p_is_bounded &&
					is_too_large("bake_ground", area_of({ nullptr, region->shared(ground()) }), RAYS_AREA_MAX,
							"Call it with several smaller regions, in as many frames."))) {
		return 0;
	}
	const GroundGrid grid = grid_for(*region, search_grid(rays, *region, _host.field_transform()));
	return lay_ground_by(
			*region, grid, [&](const Eigen::Vector2d &p_place) { return rays.height_at_corner(p_place); },
			[&](const Eigen::Vector2d &p_place) { return rays.height_at(p_place); });
}

int64_t FieldWork::bake_ground_from(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	ERR_FAIL_COND_V_MSG(!_host.node().is_inside_tree(), 0, _host.message("add the node to the scene tree before baking its ground."));
	ERR_FAIL_COND_V_MSG(!p_transform.is_finite(), 0, _host.message("bake_ground_from() needs a finite transform."));
	ERR_FAIL_COND_V_MSG(!is_ground_shape(p_shape), 0,
			_host.message("bake_ground_from() reads a HeightMapShape3D or a ConcavePolygonShape3D. For other ground, use bake_ground()."));
	const GroundTriangles triangles(p_shape);
	const Eigen::Affine3d shape_to_field = to_field() * to_eigen(p_transform);
	const MapRegion region = ground().grown(GROUND_BORDER).shared(ground_bounds(triangles, shape_to_field));
	if (!region.has_area() ||
			is_too_large("bake_ground_from", area_of({ nullptr, region.shared(ground()) }), AREA_MAX,
					"Give it the ground in several smaller shapes, in as many frames.")) {
		return 0;
	}
	const GroundGrid grid = grid_for(region, triangles.find_grid(shape_to_field).value_or(GroundGrid()));
	HeightSheet sheet(region.grown(GroundReading::REACH * info_of(MAP_GROUND).texel_size()), grid);
	add_ground(sheet, triangles, shape_to_field);
	return lay_ground_by(
			region, grid, [&](const Eigen::Vector2d &p_place) { return sheet.at(p_place); },
			[&](const Eigen::Vector2d &p_place) { return sheet.between(p_place); });
}

Dictionary to_script(const CutResult &p_cut) {
	Dictionary result;
	result["area"] = p_cut.area;
	result["volume"] = p_cut.volume;
	result["blades"] = int64_t(std::llround(p_cut.blades));
	return result;
}

} // namespace grass

// SPDX-License-Identifier: MIT
// Changes the grass: a game mows, tramples, paints and mends it and reads in the ground; wheels leave tracks, and time mends them. The
// field's map stores all of this. Places are global.
#pragma once

#include "core/paint/lay_ground.h"
#include "core/paint/mow.h"
#include "core/paint/recovery.h"
#include "field/field_host.h"
#include "field/standing_field.h"
#include "physics/vehicle_wheels.h"
#include "resources/grass_brush.h"

#include <godot_cpp/classes/shape3d.hpp>
#include <godot_cpp/variant/dictionary.hpp>

#include <optional>

namespace grass {

class FieldWork {
public:
	FieldWork(FieldHost &p_host, const StandingField &p_standing, const FieldProperties &p_properties) :
			_host(p_host), _standing(p_standing), _properties(p_properties) {}

	// Returns the square metres, seen from above, on which cut() and others act with this shape; 0 where they refuse it.
	double find_area(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform) const;
	CutResult cut(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);
	// Act on the whole field if there is no shape.
	double get_mown_share(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);
	void regrow(double p_height, double p_wear, const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);
	double trample(const godot::Vector3 &p_global, double p_radius, double p_amount);
	double paint(const godot::Ref<GrassBrush> &p_brush, const godot::Vector3 &p_from, const godot::Vector3 &p_to);
	// Leaves tracks of wheels that slip for p_delta seconds. Returns false if a listener of the map freed the field.
	[[nodiscard]] bool wear_tracks(const VehicleWheels &p_wheels, double p_delta);
	// Lets worn and cut grass recover for p_delta seconds.
	void recover(double p_delta);
	bool may_recover() const { return _properties.map.is_valid() && !_properties.recovery_rates(_standing.get_species()).is_none(); }
	// Call it when the field has another map.
	void forget_map() { _recovery.reset(); }

	// Read the shape of the ground into the map, over a rectangle (field space, x and z in metres) or, if that is empty, over the whole
	// field. Return the number of places with ground, one for each square metre.
	int64_t bake_ground(const godot::Rect2 &p_region, int64_t p_mask) { return bake(p_region, p_mask, true); }
	int64_t bake_whole_ground() { return bake(godot::Rect2(), FieldGround::ALL_LAYERS, false); } // for the editor: however large it is
	int64_t bake_ground_from(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);

private:
	Eigen::Affine3d to_field() const; // from the world
	bool find_region(const char *p_method, const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform,
			std::optional<Footprint> &r_footprint) const;
	bool is_too_large(const char *p_method, double p_area, int64_t p_most, const char *p_remedy) const;
	bool is_too_large(const char *p_method, const std::optional<Footprint> &p_footprint) const;
	MapRegion ground() const;
	MapRegion field_region() const { return MapRegion::of_grid(_standing.get_field().get_grid()); }
	MowRegion mow_region(const std::optional<Footprint> &p_footprint) const;
	std::optional<MapRegion> bake_region(const godot::Rect2 &p_region) const;
	int64_t bake(const godot::Rect2 &p_region, int64_t p_mask, bool p_is_bounded);
	GroundGrid grid_for(const MapRegion &p_region, const GroundGrid &p_found) const;
	int64_t lay_ground_by(const MapRegion &p_region, const GroundGrid &p_grid, const HeightAt &p_height, const HeightAt &p_between);

	FieldHost &_host;
	const StandingField &_standing;
	const FieldProperties &_properties;
	Recovery _recovery;
};

godot::Dictionary to_script(const CutResult &p_cut);

} // namespace grass

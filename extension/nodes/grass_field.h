// SPDX-License-Identifier: MIT
// GrassField: the node. Connects its parts (nodes/field_parts.h) with the engine: the tree, the cameras, the bodies near it, and the
// resources that its properties hold. No maths here.
#pragma once

#include "field/field_enums.h"
#include "field/field_host.h"
#include "nodes/field_frames.h"
#include "nodes/field_parts.h"
#include "nodes/field_report.h"
#include "nodes/field_ticks.h"
#include "shared/bind_part.h"
#include "shared/property_value.h"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include <memory>
#include <optional>

namespace grass {

class GrassField : public godot::GeometryInstance3D, public FieldEnums, public CalledByParts<GrassField>, private FieldHost {
	GDCLASS(GrassField, godot::GeometryInstance3D)
	friend struct FieldApi;

public:
	GrassField();

	FieldParts &get_parts() { return _parts; } // for worlds and the editor
	const FieldParts &get_parts() const { return _parts; }
	FieldReport &get_report() { return _report; }
	const FieldReport &get_report() const { return _report; }
	FieldTicks &get_ticks() { return _ticks; }
	const FieldTicks &get_ticks() const { return _ticks; }
	FieldFrames &get_frames() { return _frames; }
	const FieldFrames &get_frames() const { return _frames; }
	godot::Transform3D field_transform() const override; // global, without scale
	godot::String label() const override { return _report.label(); }
	void stir() override;
	void request_rebuild() override;

	// Set the properties whose changes the node listens to, and `simulated`.
	void set_map(const godot::Ref<GrassMap> &p_map); // null: grass grows everywhere
	godot::Ref<GrassMap> get_map() const { return value_of(_parts.properties.map); }
	void make_map() override;
	void set_species(const godot::TypedArray<GrassSpecies> &p_species); // none: one species with the defaults
	godot::TypedArray<GrassSpecies> get_species() const { return _parts.properties.species.get(); }
	void set_fill_rule(const godot::Ref<GrassFillRule> &p_rule); // null: removes what it filled
	godot::Ref<GrassFillRule> get_fill_rule() const { return _parts.sources.get_fill_rule(); }
	void set_surface_hook(const godot::Ref<godot::ShaderInclude> &p_include); // the user's include that the shaders call
	godot::Ref<godot::ShaderInclude> get_surface_hook() const { return _parts.settings.get_surface_hook(); }
	void set_simulated(bool p_simulated);
	bool is_simulated() const { return _parts.properties.simulated; }

	// Prepare a world's field before it enters the tree. p_other: a field of the same blades.
	void set_streamed() { _parts.properties.is_streamed = true; }
	void join(const GrassField &p_other) { _parts.standing.join(p_other._parts.standing); }
	// Sets the centre's place in the noise, metres. A field outside a world is at (0, 0).
	void set_noise_origin(const godot::Vector2i &p_place);
	// Does what set_map() does, for a map that another thread prepared as find_map_place() says.
	void show_map(const godot::Ref<GrassMap> &p_map, std::unique_ptr<ShownMap> p_prepared);
	// Returns where a map would be shown, or nothing until the patches are ready. May be called before the field is made or in the tree.
	std::optional<MapPlace> find_map_place() const { return grass::find_map_place(_parts.properties); }
	bool is_made() const { return _parts.life.get_stage() == FieldLife::Stage::SHOWN; } // as the properties have it
	int64_t get_pool_slots() const { return _parts.standing.get_field().get_tiles().get_room(); } // that exist now
	// Makes the field as its own frames do, whether it processes or not. Scripts run: afterwards it may be gone.
	void come() { (void)_frames.advance(); }

	// Draws the grass, for the editor, as a brush would leave it, without changing the map. Lasts until the map changes or the next
	// preview. The field must have a map.
	void preview(const MapShape &p_shape, const Brush &p_brush);
	void end_preview();
	bool is_preview() const { return _parts.standing.get_map() != nullptr && _parts.standing.get_map()->is_preview(); }

	godot::PackedStringArray _get_configuration_warnings() const override { return _report.find_warnings(); }
	godot::AABB _get_aabb() const override { return _parts.standing.get_bounds(); }

protected:
	static void _bind_methods();
	void _notification(int p_what);
	void _validate_property(godot::PropertyInfo &p_property) const;
	bool _set(const godot::StringName &p_name, const godot::Variant &p_value);
	bool _get(const godot::StringName &p_name, godot::Variant &r_value) const;
	void _get_property_list(godot::List<godot::PropertyInfo> *r_list) const;

private:
	// The host of its parts.
	godot::GeometryInstance3D &node() override { return *this; }
	godot::Transform3D drawn_transform() override;
	bool stand() override { return _parts.life.stand(); }
	bool read_scene() override;
	void warn(const godot::String &p_warning) const override { _report.warn(p_warning); }
	void report_warnings() override { _report.report_warnings(); }
	void show_warnings() override { update_configuration_warnings(); }
	GrassMap *need_map(const char *p_method) override;
	godot::String message(const godot::String &p_text) const override { return _report.message(p_text); }

	void enter();
	void turn();
	void leave();
	void listen();
	godot::Callable get_fill_button() const;

	// The engine calls these, from its message queue if a script may end the node: shared/script_call.h. Signals of a terrain and of
	// resources may arrive on any thread.
	void _before_draw() { _frames.before_draw(); }
	void _plants_left() { (void)_parts.plants.put_away(); } // nothing may follow this
	void _body_changed(int64_t p_status, const godot::RID &p_body, int64_t p_instance_id, int64_t p_body_shape, int64_t p_area_shape);
	void _area_changed(int64_t p_status, const godot::RID &p_area, int64_t p_instance_id, int64_t p_other_shape, int64_t p_own_shape);
	void _body_woke(int64_t p_body) { _ticks.body_woke(p_body); }
	void _species_changed();
	void _map_changed(const godot::TypedArray<godot::Vector2i> &p_chunks, const godot::Rect2 &p_region);
	void _fill_rule_changed();
	void _fill_pressed();
	void _hook_changed();
	void _compile_hook() { _parts.settings.compile_hook(); }
	void _terrain_edited(const godot::AABB &p_area);
	void _terrain_replaced();
	void _terrain_rectangle_changed(const godot::Rect2 &p_cells);
	void _terrain_cells_changed(double p_x, double p_y, double p_width, double p_height, int64_t p_channel);

	FieldParts _parts{ *this };
	FieldTicks _ticks{ _parts };
	FieldFrames _frames{ _parts, _ticks };
	FieldReport _report{ _parts, _ticks, _frames };
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassField::SolverMethod);
VARIANT_ENUM_CAST(grass::GrassField::SimulationDetail);
VARIANT_ENUM_CAST(grass::GrassField::SleepMode);
VARIANT_ENUM_CAST(grass::GrassField::BackendMode);
VARIANT_ENUM_CAST(grass::GrassField::DebugView);

// SPDX-License-Identifier: MIT
// The picture of the field that runs: its look, its ground, and the shaders' uniforms. It is made in parts, at once or spread over the
// frames of a hidden plot (docs/internals/life_of_a_field.md).
#pragma once

#include "core/field/field.h"
#include "core/field/field_statistics.h"
#include "draw/backend.h"
#include "draw/field_shaders.h"
#include "draw/ground.h"
#include "draw/patch_texture.h"
#include "field/field_properties.h"
#include "field/field_uniforms.h"
#include "field/project_pool.h"
#include "field/shown_map.h"

#include <memory>
#include <span>
#include <vector>

namespace grass {

// What a field that runs consists of.
struct StandingParts {
	explicit StandingParts(const FieldProperties &p_properties) : properties(p_properties), field(project_pool()) {}

	const FieldProperties &properties; // the node's. They may differ from this field until it is made again
	Field field;
	std::vector<GrownSpecies> species;
	std::vector<DrawnPlant> plants; // of the species
	std::unique_ptr<ShownMap> map; // null: none
	std::unique_ptr<Backend> backend; // null: there is no field
};

class FieldPicture {
public:
	explicit FieldPicture(StandingParts &p_parts) : _parts(p_parts) {}

	// Starts again: with the present backend, or with one that must be made first.
	void begin(bool p_has_backend);
	void free(); // there is no field any more
	bool needs_backend() const { return _part == Part::BACKEND; }
	// Returns true while the drawn field does not match the properties yet; call show() in each frame then.
	bool is_look_waiting() const { return _part != Part::NOTHING && (_part != Part::ALL || _look != find_look()); }
	bool is_shown() const { return _part == Part::ALL; } // all of it: a streamed field comes in parts while it is hidden
	// Draws the field with the properties' hook as soon as the shaders are ready. Returns false if they do not compile with it.
	bool show(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform, bool p_is_hidden);
	void follow(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform);

	void set_uniform(const godot::StringName &p_name, const godot::Variant &p_value); // of blades and ground
	const SetUniform &setter() const { return _set; } // set_uniform()
	// Makes the engine draw: an idle editor, and a game in low processor mode, draw only after something in the rendering server has
	// changed.
	void request_draw() { set_uniform("tile_size", _parts.field.get_grid().get_tile_size()); }
	void update_species(); // colours and frequencies
	void update_quality(); // what the shaders know of it
	void update_tint() { FieldUniforms::set_clump(_parts.field.get_setup().clump, _set); } // of the clumps
	void update_wind() { _uniforms.set_wind(_parts.properties, _set); }
	void show_new_textures(); // of the map
	void show_cover(const TileRange &p_tiles); // of the map, where it changed

	// Continues the gusts of another field.
	void join(const FieldPicture &p_other) { _uniforms.join_wind(p_other._uniforms); }
	// Advances the wind. Must be called in each frame before drawing begins.
	void blow(std::span<const Force> p_forces, double p_delta);
	void show_wind_clock(); // after frames in which no camera saw the field
	// Shows the ambient light. Must be called in each frame of a renderer that adds light in sRGB.
	void show_light(const godot::Vector4 &p_other) { _uniforms.set_light(p_other, _set); }
	void show_suns(const SunMap &p_suns) { _uniforms.set_suns(p_suns, _set); } // see find_sun_map(); in each frame
	// Makes motion vectors right. Must be called in each frame once its cameras are known. p_is_read: something reads motion vectors.
	void show_motion(bool p_is_read) { _parts.backend->show_motion(p_is_read, p_is_read && _uniforms.keep_wind_clock(_set_of_blades)); }

	int64_t get_cards_memory() const { return _uniforms.get_cards_memory(); } // bytes
	void add_to(FieldStatistics &r_statistics) const;

private:
	// The part of the field that is made next, in this order. NOTHING: there is no field. ALL: it is shown.
	enum class Part { NOTHING, BACKEND, LOOK, GROUND, PLANTS, UNIFORMS, SPECIES, MAP, COVER, ALL };

	bool has_ledges() const { return _parts.map != nullptr && !_parts.map->get_layers().get_ledge_layers().empty(); }
	Look find_look() const {
		return { shader_features(_parts.field.get_setup()) | (has_ledges() ? SHADER_LEDGES : 0), _parts.properties.hook.get_text() };
	}
	void show_parts(const Look &p_look, bool p_is_hidden);
	void show_part(const Look &p_look);
	void set_species_uniforms();
	void set_plants();
	void bind_map(bool p_all);

	StandingParts &_parts;
	Ground _ground;
	// Of blades and ground; of the blades alone, while there is a backend.
	const SetUniform _set{ [this](const godot::StringName &p_name, const godot::Variant &p_value) { set_uniform(p_name, p_value); } };
	const SetUniform _set_of_blades{ [this](const godot::StringName &p_name, const godot::Variant &p_value) {
		_parts.backend->set_uniform(p_name, p_value);
	} };
	FieldUniforms _uniforms;
	Part _part = Part::NOTHING;
	int _rows_shown = 0; // of the cover
	Look _look; // that it is shown with
	bool _is_carried = false; // its ground is shown, in the colour of the blades that are not drawn
	int64_t _wind_updates = 0; // frames that passed the wind's clock to the materials
};

} // namespace grass

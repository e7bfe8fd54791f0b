// SPDX-License-Identifier: MIT
// A terrain of another add-on, or of a game, whose methods are called by their names: docs/guide/terrain.md. Each kind of terrain has a
// class in terrain_sources.cpp or h_terrain_source.cpp. No code here depends on fields.
#pragma once

#include "core/fill/terrain_piece.h"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace grass {

// Returns the box around a box that was transformed.
godot::AABB moved(const godot::Transform3D &p_by, const godot::AABB &p_box);

class TerrainSource {
public:
	// Returns null if the node has no methods of a terrain, or its terrain has no data yet. r_problem then explains this in a sentence.
	static std::unique_ptr<TerrainSource> find(godot::Node *p_node, godot::String &r_problem);
	virtual ~TerrainSource() = default;
	TerrainSource(const TerrainSource &) = delete;
	TerrainSource &operator=(const TerrainSource &) = delete;

	// Returns whether the node and its data still exist.
	bool is_alive() const;
	// Returns whether p_other queries the same objects.
	bool is_same(const TerrainSource &p_other) const { return _node == p_other._node && _data == p_other._data; }
	virtual bool has_textures() const = 0;
	virtual bool has_colors() const = 0;
	// Reads the terrain at places (global; as many samples as places); heights and normals are global. Only while is_alive(). Methods of
	// the terrain may remove it, and then the samples are invalid.
	virtual void read(std::span<const godot::Vector3> p_places, std::span<TerrainSample> r_samples) = 0;
	// Returns how many places to pass to read() at once: few if each needs a separate call, so that a slow terrain can be interrupted.
	virtual size_t get_places_at_once() const { return 1; }
	// Returns the terrain's transform. Samples stay valid as long as the field does not move relative to it.
	virtual godot::Transform3D get_transform() const;

	// Returns where the terrain has its vertices in p_field (global, upright); nothing where that is not known or no grid of whole metres.
	virtual std::optional<GroundGrid> find_grid(const godot::Transform3D &p_field);

	// What to call when something changes, and the signal of get_emitter() that triggers it.
	struct Handlers {
		godot::Callable in_area; // global AABB
		godot::Callable anywhere;
		godot::Callable in_cells; // x, y, width, height, channel: see to_area()
		godot::Callable in_rectangle; // the same as a Rect2
	};
	struct Notice {
		const char *signal;
		godot::Callable handler;
	};
	virtual std::vector<Notice> get_notices(const Handlers &p_handlers) const = 0;
	virtual godot::Object *get_emitter() const { return get_data(); }
	virtual godot::AABB to_area(const godot::Vector2 &p_first_cell, const godot::Vector2 &p_cells) const;

	int64_t get_calls() const { return _calls; } // number of calls of the terrain's methods so far
	// Returns which method returned an invalid value: "get_height() of 'Hills' returned ...". Empty: none did.
	const godot::String &get_problem() const { return _problem; }

protected:
	static constexpr double NO_GROUND = std::numeric_limits<double>::quiet_NaN();
	// The places that one query combines where a query costs several calls. More: a slow terrain holds a frame for longer. Fewer: more
	// calls.
	static constexpr size_t PLACES_AT_ONCE = 16;

	TerrainSource(godot::Node *p_node, godot::Object *p_data);
	godot::Node *get_node() const;
	godot::Object *get_data() const; // the object to query: the node itself, or its data

	// p_data: from get_data(). Returns null if an earlier answer has freed it.
	template <typename... Arguments>
	godot::Variant ask(const godot::Object *p_data, const godot::StringName &p_method, const Arguments &...p_arguments) {
		godot::Object *data = get_data();
		if (data == nullptr || data != p_data) {
			return godot::Variant();
		}
		_calls++;
		const godot::Variant held(data); // the method may drop the last reference to its own object
		return data->call(p_method, p_arguments...);
	}
	// Calls a method of the node, if its data is another object.
	godot::Variant ask_node(const godot::StringName &p_method);
	// Returns NaN, and records a problem, if the value is not a number.
	double to_number(const godot::Variant &p_value, const char *p_method);
	// Returns no numbers, and records a problem, if the value is not an array of this size.
	godot::PackedFloat32Array to_numbers(const godot::Variant &p_value, const char *p_method, int64_t p_count);
	// Returns zero, and records a problem, if the value is not a vector.
	godot::Vector3 to_vector(const godot::Variant &p_value, const char *p_method);
	// Takes a number, or a vector of base, overlay and blend.
	TerrainTexel to_texture(const godot::Variant &p_value, const char *p_method);
	// Returns no colour, and records a problem, if the value is not a colour.
	TerrainColor to_color(const godot::Variant &p_value, const char *p_method);
	// Returns no colour for white: where no colour was painted, the colour maps of add-ons are white, which multiplies the textures and
	// says nothing about the ground.
	static TerrainColor unless_white(const TerrainColor &p_color) {
		return p_color == TerrainColor{ 255, 255, 255, 255 } ? TerrainColor() : p_color;
	}

	// Returns the grid of cells from p_cells.origin along its x and z.
	static std::optional<GroundGrid> grid_of(const godot::Transform3D &p_field, const godot::Transform3D &p_cells);

private:
	void complain(const godot::Variant &p_value, const char *p_method, const godot::String &p_wanted);

	uint64_t _node, _data; // instance ids
	int64_t _calls = 0;
	godot::String _problem;
};

} // namespace grass

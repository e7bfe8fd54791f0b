// SPDX-License-Identifier: MIT
// The ways to ask a terrain: by the plain interface, as Terrain3D; h_terrain_source.cpp has the third. The names are theirs;
// docs/guide/terrain.md lists them.
#include "ground/h_terrain_source.h"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <cmath>
#include <limits>

using namespace godot;

namespace grass {

namespace {

Eigen::Vector3d to_normal(const Vector3 &p_normal) {
	return { p_normal.x, p_normal.y, p_normal.z };
}

// A node with methods of its own. Only a height is needed.
class PlainTerrain : public TerrainSource {
public:
	static constexpr const char *HEIGHT = "get_height", *HEIGHTS = "get_heights", *NORMAL = "get_normal", *TEXTURE = "get_texture_id",
								*COLOR = "get_color", *HOLE = "is_hole", *CHANGED = "terrain_changed";

	explicit PlainTerrain(Node *p_node) :
			TerrainSource(p_node, p_node),
			_has_heights(p_node->has_method(HEIGHTS)),
			_has_normals(p_node->has_method(NORMAL)),
			_has_textures(p_node->has_method(TEXTURE)),
			_has_colors(p_node->has_method(COLOR)),
			_has_holes(p_node->has_method(HOLE)) {}

	bool has_textures() const override { return _has_textures; }
	bool has_colors() const override { return _has_colors; }

	void read(std::span<const Vector3> p_places, std::span<TerrainSample> r_samples) override {
		Object *node = get_data();
		read_heights(node, p_places, r_samples);
		for (size_t i = 0; i < p_places.size(); i++) {
			TerrainSample &sample = r_samples[i];
			if (_has_holes && std::isfinite(sample.height) && bool(ask(node, _hole, p_places[i]))) {
				sample.height = NO_GROUND;
			}
			if (!std::isfinite(sample.height)) {
				continue;
			}
			if (_has_normals) {
				sample.normal = to_normal(to_vector(ask(node, _normal, p_places[i]), NORMAL));
			}
			if (_has_textures) {
				sample.texture = to_texture(ask(node, _texture, p_places[i]), TEXTURE);
			}
			if (_has_colors) {
				sample.color = to_color(ask(node, _color, p_places[i]), COLOR);
			}
		}
	}

	// Heights need one call for all places, everything else one call for each place.
	size_t get_places_at_once() const override {
		const bool asks_each = _has_normals || _has_textures || _has_colors || _has_holes;
		return !_has_heights ? 1 : (asks_each ? PLACES_AT_ONCE : std::numeric_limits<size_t>::max());
	}

	Transform3D get_transform() const override {
		const Node3D *node = Object::cast_to<Node3D>(get_node());
		return node == nullptr ? Transform3D() : node->get_global_transform();
	}

	std::vector<Notice> get_notices(const Handlers &p_handlers) const override { return { { CHANGED, p_handlers.in_area } }; }

private:
	void read_heights(Object *p_node, std::span<const Vector3> p_places, std::span<TerrainSample> r_samples) {
		if (!_has_heights) {
			for (size_t i = 0; i < p_places.size(); i++) {
				r_samples[i].height = to_number(ask(p_node, _height, p_places[i]), HEIGHT);
			}
			return;
		}
		PackedVector3Array places;
		for (const Vector3 &place : p_places) {
			places.push_back(place);
		}
		const PackedFloat32Array heights = to_numbers(ask(p_node, _heights, places), HEIGHTS, places.size());
		for (size_t i = 0; i < size_t(heights.size()); i++) {
			r_samples[i].height = heights[int64_t(i)];
		}
	}

	const StringName _height = HEIGHT, _heights = HEIGHTS, _normal = NORMAL, _texture = TEXTURE, _color = COLOR, _hole = HOLE;
	bool _has_heights, _has_normals, _has_textures, _has_colors, _has_holes;
};

// Terrain3D: a node whose `data` answers queries at global places. In holes its get_height() is not a number; in versions where it is one,
// get_texture_id() is not.
class Terrain3DSource : public TerrainSource {
public:
	static constexpr const char *HEIGHT = "get_height", *TEXTURE = "get_texture_id", *COLOR = "get_color";

	Terrain3DSource(Node *p_node, Object *p_data) :
			TerrainSource(p_node, p_data), _has_textures(p_data->has_method(TEXTURE)), _has_colors(p_data->has_method(COLOR)) {}

	bool has_textures() const override { return _has_textures; }
	bool has_colors() const override { return _has_colors; }

	void read(std::span<const Vector3> p_places, std::span<TerrainSample> r_samples) override {
		Object *data = get_data();
		for (size_t i = 0; i < p_places.size(); i++) {
			TerrainSample &sample = r_samples[i];
			sample.height = to_number(ask(data, _height, p_places[i]), HEIGHT);
			if (_has_textures && std::isfinite(sample.height)) {
				const Vector3 shown = to_vector(ask(data, _texture, p_places[i]), TEXTURE);
				sample.texture = to_texture(shown, TEXTURE);
				sample.height = std::isfinite(shown.x) ? sample.height : NO_GROUND;
			}
			if (_has_colors && std::isfinite(sample.height)) {
				sample.color = unless_white(to_color(ask(data, _color, p_places[i]), COLOR));
			}
		}
	}

	std::vector<Notice> get_notices(const Handlers &p_handlers) const override {
		return { { "maps_edited", p_handlers.in_area }, { "maps_changed", p_handlers.anywhere } };
	}

private:
	const StringName _height = HEIGHT, _texture = TEXTURE, _color = COLOR;
	bool _has_textures, _has_colors;
};

} // namespace

std::unique_ptr<TerrainSource> TerrainSource::find(Node *p_node, String &r_problem) {
	if (p_node->has_method(PlainTerrain::HEIGHT) || p_node->has_method(PlainTerrain::HEIGHTS)) {
		return std::make_unique<PlainTerrain>(p_node);
	}
	const StringName name = p_node->get_name();
	const String type = p_node->get_class();
	if (!p_node->has_method("get_data")) {
		r_problem = vformat("`terrain` is '%s' (%s), which has neither a method get_height() nor the get_data() of Terrain3D and HTerrain. "
							"Choose another node, or add the method to it (docs/guide/terrain.md).",
				name, type);
		return nullptr;
	}
	const uint64_t id = p_node->get_instance_id();
	const Variant answer = p_node->call("get_data"); // holds what it returned
	Object *data = answer;
	if (ObjectDB::get_instance(id) == nullptr) {
		r_problem = vformat("get_data() of `terrain`, '%s', freed the terrain.", name);
		return nullptr;
	}
	if (data == nullptr) {
		r_problem = vformat("get_data() of `terrain`, '%s', returned nothing: the terrain has no data yet.", name);
		return nullptr;
	}
	if (std::unique_ptr<TerrainSource> terrain = make_h_terrain_source(p_node, data)) {
		return terrain;
	}
	if (data->has_method(Terrain3DSource::HEIGHT)) {
		return std::make_unique<Terrain3DSource>(p_node, data);
	}
	r_problem =
			vformat("get_data() of `terrain`, '%s', returned an object (%s) with neither get_height() nor get_interpolated_height_at(): "
					"a field cannot read this kind of terrain (docs/guide/terrain.md).",
					name, data->get_class());
	return nullptr;
}

} // namespace grass

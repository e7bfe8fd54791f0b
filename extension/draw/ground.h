// SPDX-License-Identifier: MIT
// The soil between the blades: one sheet over the field, so that the floor below does not shine through. On baked hills it follows the
// heights of the map, which its shader reads.
#pragma once

#include "core/base/tile_grid.h"
#include "draw/node_follower.h"

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/classes/shader_material.hpp>

#include <memory>

namespace grass {

class Ground {
public:
	Ground() = default;
	Ground(const Ground &) = delete;
	Ground &operator=(const Ground &) = delete;
	~Ground() { free(); }

	// Makes the shader that create() uses, if it does not exist. Returns whether it existed before.
	static bool prepare(int p_features);
	void create(const TileGrid &p_grid, int p_features); // with SHADER_MAP: soil only where the map has grass
	void follow(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform, bool p_shown);
	// The map's ground lies between these heights, metres above the field. Another mesh where it got hills, or lost them.
	void set_heights(float p_low, float p_high);
	// Sets a uniform of the ground shader, which shares names with the blade shader and ignores those that only blades have.
	void set_uniform(const godot::StringName &p_name, const godot::Variant &p_value);
	// SurfaceHook::text; "": none. False if the shader does not compile with it.
	bool set_hook(const godot::String &p_text);
	void free();
	int64_t get_updates() const { return _follower.get_updates(); } // changes of the node that went to the renderer

private:
	static godot::Ref<godot::ArrayMesh> make_sheet(double p_x, double p_z, bool p_is_flat); // metres
	void make_mesh();

	TileGrid _grid;
	float _low = 0.0f, _high = 0.0f;
	std::shared_ptr<godot::Ref<godot::ArrayMesh>> _mesh; // grounds of one size and shape share it
	godot::Ref<godot::ShaderMaterial> _material;
	godot::RID _instance;
	NodeFollower _follower;
	int _features = 0;
};

} // namespace grass

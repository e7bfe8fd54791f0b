// SPDX-License-Identifier: MIT
// The soil between the blades: one sheet over the field, so that the floor below is not visible. On baked hills it follows the heights of
// the map, which its shader reads.
#pragma once

#include "core/base/tile_grid.h"
#include "core/map/ground_grid.h"
#include "draw/node_follower.h"
#include "draw/shared_shader.h"

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

	static ShaderText text(const Look &p_look); // of its shader
	void create(const TileGrid &p_grid, const Look &p_look); // with SHADER_MAP: soil only where the map has grass
	void set_look(const Look &p_look);
	void follow(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform, bool p_shown);
	// Sets the range of the map's ground, metres above the field, whether it may have ledges, and where its heights lie. Replaces the mesh
	// when hills or ledges appear or go, or heights lie elsewhere.
	void set_heights(float p_low, float p_high, bool p_has_ledges, const GroundGrid &p_heights);
	// Sets a uniform of the ground shader, which shares names with the blade shader and ignores those that only blades have.
	void set_uniform(const godot::StringName &p_name, const godot::Variant &p_value);
	void free();
	int64_t get_updates() const { return _follower.get_updates(); } // changes of the node that were passed to the renderer

private:
	enum class Sheet {
		FLAT, // two triangles
		HILLS, // cells with shared corners
		LEDGES, // cells without shared corners, each on its own side
	};
	static godot::Ref<godot::ArrayMesh> make_sheet(double p_x, double p_z, Sheet p_sheet, const GroundGrid &p_heights); // metres
	Sheet find_sheet() const { return _has_ledges ? Sheet::LEDGES : (_low == 0.0f && _high == 0.0f ? Sheet::FLAT : Sheet::HILLS); }
	void make_mesh();

	TileGrid _grid;
	float _low = 0.0f, _high = 0.0f;
	bool _has_ledges = false;
	GroundGrid _heights;
	std::shared_ptr<godot::Ref<godot::ArrayMesh>> _mesh; // grounds of the same size and shape share it
	godot::Ref<godot::ShaderMaterial> _material;
	godot::RID _instance;
	NodeFollower _follower;
};

} // namespace grass

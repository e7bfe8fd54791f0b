// SPDX-License-Identifier: MIT
// The shadow map of the suns that shine on a field, as shaders/draw/light.gdshaderinc must know it.
#pragma once

#include <godot_cpp/classes/directional_light3d.hpp>
#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/vector3.hpp>
#include <godot_cpp/variant/vector4.hpp>

#include <vector>

namespace grass {

// Returns whether p_node's shadows are on the map of a sun.
bool casts_for(const godot::DirectionalLight3D *p_sun, const godot::VisualInstance3D *p_node);

// The shaders' uniforms.
struct SunMap {
	godot::Vector4 map; // sun_map
	std::vector<godot::Vector3> bare; // bare_suns

	bool operator==(const SunMap &) const = default;
};

// Returns the shadow map of the suns on p_node. If more suns have none of its shadows than shaders can know, it has none at all.
SunMap find_sun_map(const godot::GeometryInstance3D *p_node);

} // namespace grass

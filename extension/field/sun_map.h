// SPDX-License-Identifier: MIT
// The shadow map of the suns that shine on a field, as shaders/draw/light.gdshaderinc must know it.
#pragma once

#include <godot_cpp/classes/directional_light3d.hpp>
#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/vector4.hpp>

namespace grass {

// Returns whether p_node's shadows are on the map of a sun.
bool casts_for(const godot::DirectionalLight3D *p_sun, const godot::VisualInstance3D *p_node);

// Returns the shaders' uniform `sun_map`. Its z is 1 only if p_node's shadows are on the maps of all suns that shine on it, since a light's
// shader does not know which light it is.
godot::Vector4 find_sun_map(const godot::GeometryInstance3D *p_node);

} // namespace grass

// SPDX-License-Identifier: MIT
// What the shaders must know about a scene's light if the renderer adds light in sRGB (shaders/draw/renderers.gdshaderinc).
#pragma once

#include <godot_cpp/classes/environment.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/vector4.hpp>

#include <vector>

namespace grass {

class OtherLight {
public:
	// Returns the ambient light of p_node's world on level ground, in linear colours. Its w is 1 if all directional lights that shine there
	// cast shadows, else 0, since a light's shader does not know which light it is. Call it in every frame.
	godot::Vector4 find(godot::Node3D *p_node);

private:
	godot::Color _ambient(const godot::Ref<godot::Environment> &p_environment);
	godot::Color _of_sky(const godot::Ref<godot::Environment> &p_environment);

	std::vector<double> _seen; // what the sky's light depends on, as it was when last checked
	godot::Color _sky{ 0.0f, 0.0f, 0.0f };
	int _looks_left = 0; // checks left: the renderer takes some frames to light a changed sky
	int _frames = 1 << 20; // since the last check
};

} // namespace grass

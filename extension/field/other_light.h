// SPDX-License-Identifier: MIT
// What the shaders must know of a scene's light where the renderer adds light in sRGB (shaders/draw/renderers.gdshaderinc).
#pragma once

#include <godot_cpp/classes/environment.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/vector4.hpp>

#include <vector>

namespace grass {

class OtherLight {
public:
	// Call in every frame. The ambient light of p_node's world on level ground, in linear colours; in w 1 if all directional lights that
	// shine there cast shadows, else 0: lights do not know which of them they are.
	godot::Vector4 find(godot::Node3D *p_node);

private:
	godot::Color _ambient(const godot::Ref<godot::Environment> &p_environment);
	godot::Color _of_sky(const godot::Ref<godot::Environment> &p_environment);

	std::vector<double> _seen; // what the light of the sky depends on, as it was at the last look
	godot::Color _sky{ 0.0f, 0.0f, 0.0f };
	int _looks_left = 0; // the renderer takes frames to light a sky that changed
	int _frames = 1 << 20; // since the last look
};

} // namespace grass

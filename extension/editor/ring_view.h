// SPDX-License-Identifier: MIT
// The brush's ring in the 3D editor's views: an instance in the renderer and no node, so it never gets into a scene.
#pragma once

#include "editor/ground_picker.h"

#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/rid.hpp>

namespace grass {

class RingView {
public:
	RingView() = default;
	RingView(const RingView &) = delete;
	RingView &operator=(const RingView &) = delete;
	~RingView() { free(); }

	// Around p_centre, with a fainter ring where the full effect ends. Lies on the ground, as wide as seen by p_camera.
	void show(const GrassField *p_field, const godot::Camera3D *p_camera, const GroundPoint &p_centre, double p_radius, double p_hardness,
			const godot::Color &p_color);
	void hide();
	bool is_shown() const { return _shown; }
	void free();

private:
	void create();

	godot::RID _mesh, _instance;
	godot::Ref<godot::ShaderMaterial> _material;
	bool _shown = false;
};

} // namespace grass

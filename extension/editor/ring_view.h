// SPDX-License-Identifier: MIT
// The brush's ring in the editor's 3D views: an instance in the renderer instead of a node, so it never becomes part of a scene.
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

	struct Look {
		double radius, hardness; // metres; share of the radius, where a fainter ring marks the end of the full effect
		godot::Color color;
		double strength = 0.0; // of one touch, shown by a veil place by place; 0: none
		MapShape shape = {}; // of the touch
	};

	// Shows the ring around p_centre, on the ground, with a width for the view of p_camera.
	void show(const PaintedFields &p_painted, const godot::Camera3D *p_camera, const GroundPoint &p_centre, const Look &p_look);
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

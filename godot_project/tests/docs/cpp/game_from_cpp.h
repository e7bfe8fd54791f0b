// SPDX-License-Identifier: MIT
// What the C++ block of docs/guide/game.md assumes: a class of the reader's extension, in his own header.
#pragma once

#include <godot_cpp/classes/character_body3d.hpp>
#include <godot_cpp/classes/collision_shape3d.hpp>
#include <godot_cpp/classes/shape3d.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>

class Mower : public godot::CharacterBody3D {
	GDCLASS(Mower, godot::CharacterBody3D)

public:
	void _physics_process(double p_delta) override;

protected:
	static void _bind_methods() {}

private:
	void slow_down() {}

	godot::Node3D *field = nullptr;
	godot::CollisionShape3D *deck = nullptr;
	double hay = 0.0;
};

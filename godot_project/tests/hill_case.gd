# SPDX-License-Identifier: MIT
## A test on a hillside: ground of a HeightMapShape3D, and bodies that are let go on it.
extends "res://tests/field_case.gd"

const HILL := 33  # heights along a side, a metre apart


static func hill_height(x: float, z: float) -> float:
	return 0.4 * x + 0.8 * sin(0.35 * z + 0.2 * x)


## Ground of 32 m by 32 m that falls towards -x, in waves along z.
func add_hill(place := Vector3.ZERO) -> StaticBody3D:
	var shape := HeightMapShape3D.new()
	shape.map_width = HILL
	shape.map_depth = HILL
	var heights := PackedFloat32Array()
	for z in HILL:
		for x in HILL:
			heights.append(hill_height(x - 16.0, z - 16.0))
	shape.map_data = heights
	return add_body(StaticBody3D.new(), shape, place)


func shape_of(body: PhysicsBody3D) -> CollisionShape3D:
	return body.get_child(0)


## A ball, a box and a capsule, let go side by side above the hill.
func let_go() -> Array[RigidBody3D]:
	var box := BoxShape3D.new()
	box.size = Vector3(0.4, 0.3, 0.4)
	var capsule := CapsuleShape3D.new()
	capsule.radius = 0.2
	capsule.height = 0.8
	var smooth := PhysicsMaterial.new()
	smooth.friction = 0.05
	var bodies: Array[RigidBody3D] = []
	for shape: Shape3D in [ball(0.3), box, capsule]:
		var z := 3.0 * bodies.size() - 3.0
		var body := add_body(RigidBody3D.new(), shape, Vector3(5, hill_height(5, z) + 0.5, z)) as RigidBody3D
		body.rotation.x = PI / 2  # the capsule lies across the slope
		body.physics_material_override = smooth  # the box slides
		bodies.append(body)
	return bodies

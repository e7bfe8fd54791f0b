# SPDX-License-Identifier: MIT
## A drawn field among all that an engine may be built without. Started by tools/test/lacking.py.
extends Node3D

const TICKS := 20
const PLACE := Vector3(0.2, 0.0, 0.0)
const LEAST_BEND := 0.01  # metres; at rest it is 0


func _ready() -> void:
	var camera := Camera3D.new()
	camera.position = Vector3(0, 1, 2)
	camera.compositor = Compositor.new()
	camera.compositor.compositor_effects = [CompositorEffect.new()]
	add_child(camera)
	var soft := SoftBody3D.new()
	soft.mesh = BoxMesh.new()
	for body: Node3D in [soft, VehicleBody3D.new(), CSGBox3D.new()]:
		add_child(body)
		body.position = Vector3(1, 0.3, 0)
	var field := GrassField.new()
	field.size = Vector2(4, 4)
	field.density = 64.0
	add_child(field)
	var ball := AnimatableBody3D.new()
	ball.sync_to_physics = false
	var shape := CollisionShape3D.new()
	shape.shape = SphereShape3D.new()
	shape.shape.radius = 0.3
	ball.add_child(shape)
	ball.position.y = 0.1
	add_child(ball)
	while field.get_statistics().waiting or field.get_statistics().compiling > 0:
		await RenderingServer.frame_post_draw
	for i in TICKS:
		field.get_bend_at(PLACE)
		await get_tree().physics_frame
	if field.get_bend_at(PLACE).length() > LEAST_BEND:
		print("The ball bends the grass: %s" % field.get_bend_at(PLACE))
	get_tree().quit()

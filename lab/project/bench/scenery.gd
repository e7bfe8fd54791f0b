# SPDX-License-Identifier: MIT
## The things that benchmarks put around a field.
extends RefCounted

const Bodies := preload("res://demo/bodies.gd")


static func add_ground(p_to: Node3D) -> void:
	var ground := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = WorldBoundaryShape3D.new()
	ground.add_child(shape)
	p_to.add_child(ground)


## Adds the camera that draws, until another one is made current.
static func add_camera(p_to: Node3D) -> Camera3D:
	var camera := Camera3D.new()
	camera.far = 600.0
	p_to.add_child(camera)
	camera.current = true
	return camera


static func add_sun(p_to: Node3D, p_shadows: bool) -> DirectionalLight3D:
	var sun := DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-50.0, 40.0, 0.0)
	sun.shadow_enabled = p_shadows
	p_to.add_child(sun)
	return sun


## Waits until the field is drawn, and the driver has compiled the passes of the simulation: until then the grass does not bend, and the
## pass for tiles near something sharp does not run.
static func compiled(p_field: GrassField) -> void:
	var start := Time.get_ticks_msec()
	for i in 3:
		await p_field.get_tree().process_frame
	while (p_field.get_statistics().waiting or p_field.get_statistics().compiling > 0) and Time.get_ticks_msec() - start < 120000:
		await p_field.get_tree().process_frame
	if p_field.get_statistics().compiling > 0:
		push_error("A pass of the simulation has not been compiled in two minutes: the times that follow are not its own.")


## Returns the demo's bodies, thrown across p_side metres. The same seed gives the same throw.
static func throw(p_to: Node3D, p_count: int, p_side: float, p_seed: int) -> Array[RigidBody3D]:
	var source := Bodies.new(p_seed)
	var thrown: Array[RigidBody3D] = []
	for i in p_count:
		var body := source.make()
		source.throw(body, p_side)
		p_to.add_child(body)
		thrown.append(body)
	return thrown


## Adds a ball of 0.4 m that its benchmark moves.
static func add_ball(p_to: Node3D, p_place: Vector3) -> AnimatableBody3D:
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	var shape := CollisionShape3D.new()
	var ball := SphereShape3D.new()
	ball.radius = 0.4
	shape.shape = ball
	body.add_child(shape)
	body.position = p_place
	p_to.add_child(body)
	return body


## Balls in no order over p_side metres.
static func add_crowd(p_to: Node3D, p_count: int, p_side: float) -> Array[AnimatableBody3D]:
	var balls: Array[AnimatableBody3D] = []
	for i in p_count:
		var place := p_side * Vector3(fposmod(0.618 * i, 1.0) - 0.5, 0, fposmod(0.414 * i, 1.0) - 0.5)
		balls.append(add_ball(p_to, place + Vector3(0, 0.3, 0)))
	return balls


## Adds a flat box in the tips of the grass, p_side metres wide: every tile below it is awake and has one object.
static func add_lid(p_to: Node3D, p_side: float) -> AnimatableBody3D:
	var body := AnimatableBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	shape.shape.size = Vector3(p_side, 0.2, p_side)
	body.add_child(shape)
	body.position.y = 0.45
	p_to.add_child(body)
	return body

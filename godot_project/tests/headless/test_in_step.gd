# SPDX-License-Identifier: MIT
## Grass bends where a moving body is drawn, whatever moves it, not where the body was a tick before.
extends "res://tests/field_case.gd"

const TICKS_A_SECOND := 20
const SPEED := 6.0  # m/s
const STEP := SPEED / TICKS_A_SECOND  # metres a tick
const RADIUS := 0.3
const KINDS: Array[String] = ["frozen", "character", "moved", "animatable", "synced", "static", "child"]
const NEAR := 0.2  # of a tick's way


func after() -> void:
	Engine.physics_ticks_per_second = ProjectSettings.get_setting("physics/common/physics_ticks_per_second")


func make(kind: String) -> PhysicsBody3D:
	match kind:
		"rigid", "frozen":
			var body := RigidBody3D.new()
			body.gravity_scale = 0.0
			body.linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
			body.freeze = kind == "frozen"
			body.freeze_mode = RigidBody3D.FREEZE_MODE_KINEMATIC
			return body
		"character", "moved":
			var body := CharacterBody3D.new()
			body.motion_mode = CharacterBody3D.MOTION_MODE_FLOATING
			return body
		"static":
			return StaticBody3D.new()
	var body := AnimatableBody3D.new()
	body.sync_to_physics = kind == "synced"
	return body


## One tick of motion, before the field's own tick.
func push(body: PhysicsBody3D, kind: String) -> void:
	match kind:
		"rigid":
			body.linear_velocity.x = SPEED
		"character":
			body.velocity.x = SPEED
			body.move_and_slide()
		"child":
			(body.get_parent() as Node3D).position.x += STEP
		_:
			body.position.x += STEP


## Returns the frontmost knot that the body has pushed aside, along x: metres from the middle of the body that is drawn.
func front(field: GrassField, rest: Dictionary[Vector2i, PackedVector3Array], body: PhysicsBody3D) -> float:
	var most := -INF
	for tile: Vector2i in rest:
		var now := tile_knots(field, tile)
		for i in now.size():
			if now[i].distance_to(rest[tile][i]) > 0.02:
				most = maxf(most, rest[tile][i].x - body.global_position.x)
	return most


## Returns what front() is in the frame after each tick of motion, by the body's place in steps of a tick.
func fronts(kind: String) -> Dictionary[int, float]:
	Engine.physics_ticks_per_second = TICKS_A_SECOND
	var field := add_field({size = Vector2(8, 1), density = 1024.0})
	await ticks(1)
	var tiles: Array[Vector2i] = []
	for x in roundi(field.size.x / field.get_tile_size()):
		for z in roundi(field.size.y / field.get_tile_size()):
			tiles.append(Vector2i(x, z))
	var rest := knots_of(field, tiles)
	var parent := Node3D.new()
	add_child(parent)
	var body := make(kind)
	add_shape(body, ball(RADIUS))
	body.position = Vector3(-3, RADIUS, 0)
	parent.add_child(body)
	await ticks(3)
	var found: Dictionary[int, float] = {}
	for i in 12:
		push(body, kind)
		await get_tree().process_frame
		found[roundi(body.global_position.x / STEP)] = front(field, rest, body)
		await ticks(1)
	parent.free()
	field.free()
	return found


## Nothing moves a rigid body but the server, so that its node and its grass see the same place.
func test_grass_bends_where_the_body_is_drawn() -> void:
	var exact := await fronts("rigid")
	for kind in KINDS:
		var found := await fronts(kind)
		var most := 0.0
		var places := 0
		for place in found:
			if exact.has(place):
				places += 1
				most = maxf(most, absf(found[place] - exact[place]) / STEP)
		print("    %s: at most %.2f of a tick's way from a rigid body's" % [kind, most])
		assert_less(most, NEAR, kind)
		assert_greater(places, 10, kind)

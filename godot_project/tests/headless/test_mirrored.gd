# SPDX-License-Identifier: MIT
## Scaled and mirrored shapes press the grass where the physics server has them.
extends "res://tests/field_case.gd"

const PLACE := Vector3(0.13, 0.32, -0.07)  # of the body
const TURN := Vector3(0.15, 0.7, -0.1)
const SHAPE_SCALES: Array[Vector3] = [
	Vector3(-1, 1, 1),
	Vector3(1, -1, 1),
	Vector3(1, 1, -1),
	Vector3(-1, -1, -1),
	Vector3(-1.3, 0.8, 1.1),
	Vector3(-0.9, -1.2, -1.1),
	Vector3(-1, 1, -1),
	Vector3(1.4, 0.8, 1.1)
]
const BODY_SCALES: Array[Vector3] = [
	Vector3(-1, 1, 1),
	Vector3(1, -1, 1),
	Vector3(1, 1, -1),
	Vector3(-1, -1, -1),
	Vector3(-1.2, 1.2, 1.2),
	Vector3(-0.8, -0.8, -0.8),
	Vector3(-1, 1, -1),
	Vector3(1.3, 1.3, 1.3)
]
const DEEP := 0.01  # metres within a body: the physics server rounds corners off
const APART := 0.12  # metres: blades farther from the body stand as they grew


## Returns a wedge that is like no turned form of its mirrored one.
func wedge() -> ConvexPolygonShape3D:
	var shape := ConvexPolygonShape3D.new()
	shape.points = PackedVector3Array(
		[
			Vector3(-0.5, -0.22, -0.3),
			Vector3(0.6, -0.22, -0.3),
			Vector3(-0.5, -0.22, 0.35),
			Vector3(-0.5, 0.2, -0.3),
			Vector3(-0.3, 0.2, -0.3)
		]
	)
	return shape


## Returns whether a ball of `radius` at `place` meets anything.
func meets(place: Vector3, radius: float) -> bool:
	var query := PhysicsShapeQueryParameters3D.new()
	query.shape = ball(radius)
	query.transform.origin = place
	return not get_world_3d().direct_space_state.intersect_shape(query, 1).is_empty()


## Returns whether all places within DEEP of `place` lie in a body.
func is_inside(place: Vector3) -> bool:
	var query := PhysicsPointQueryParameters3D.new()
	for way: Vector3 in [Vector3.RIGHT, Vector3.LEFT, Vector3.UP, Vector3.DOWN, Vector3.BACK, Vector3.FORWARD]:
		query.position = place + DEEP * way
		if get_world_3d().direct_space_state.intersect_point(query, 1).is_empty():
			return false
	return true


## What the body does to the blades about it, whose roots it does not stand on: knots inside of it that were left there, knots that grew
## there, and how many blades moved of those that grew apart from it.
func measure(field: GrassField, still: GrassField) -> Dictionary:
	var found := {inside = 0, grew_inside = 0, apart = 0, moved_apart = 0}
	for tile in awake_tiles(field):
		var knots := tile_knots(field, tile)
		var rest := tile_knots(still, tile)
		for blade in BLADES:
			var now := blade_of(knots, blade)
			var grown_as := blade_of(rest, blade)
			if meets(grown_as[0], 0.03) or meets(grown_as[1], 0.03):
				continue
			var inside := 0
			var apart := true
			for knot in range(CLAMPED, KNOTS):
				inside += int(is_inside(grown_as[knot]))
				found.inside += int(is_inside(now[knot]))
				apart = apart and not meets(grown_as[knot], APART)
			found.grew_inside += inside
			found.apart += int(apart)
			found.moved_apart += int(apart and farthest(now, grown_as) > 0.01)
	return found


## Lets `body` down into the grass, does `change` to it there, and asks where the blades are then.
func press(body: PhysicsBody3D, of_shape: Vector3, of_body: Vector3, change := Callable()) -> void:
	var field := add_field({size = Vector2(3, 3)})
	var still := add_field({size = Vector2(3, 3), simulated = false})
	await grown(still)
	add_shape(body, wedge(), Transform3D(Basis.from_euler(TURN) * Basis.from_scale(of_shape), Vector3(0.03, 0.02, -0.04)))
	body.transform = Transform3D(Basis.from_euler(TURN) * Basis.from_scale(of_body), PLACE + Vector3(0, 0.8, 0))
	add_child(body)
	await ticks(3)
	for i in 16:
		body.position.y -= 0.05
		await ticks(1)
	if change:
		await ticks(20)
		change.call()
	await ticks(40)
	var found := measure(field, still)
	var label := "%s, shape %s, body %s" % [body.get_class(), of_shape, of_body]
	assert_greater(found.grew_inside, 40, label)
	assert_eq(found.inside, 0, "knots inside: " + label)
	if not change:
		assert_less(found.moved_apart, 0.02 * found.apart, "blades apart from it: " + label)
	body.free()
	field.free()
	still.free()
	await ticks(2)


func make(kind: int) -> PhysicsBody3D:
	match kind:
		0:
			var animated := AnimatableBody3D.new()
			animated.sync_to_physics = false
			return animated
		1:
			return StaticBody3D.new()
		2:
			return CharacterBody3D.new()
	var rigid := RigidBody3D.new()
	rigid.gravity_scale = 0.0
	rigid.axis_lock_angular_x = true
	rigid.axis_lock_angular_y = true
	rigid.axis_lock_angular_z = true
	return rigid


func test_shapes_of_all_kinds_of_bodies() -> void:
	for kind in 4:
		for i in 2:
			await press(make(kind), SHAPE_SCALES[2 * kind + i], Vector3.ONE)


func test_bodies_of_all_kinds() -> void:
	for kind in 4:
		for i in 2:
			await press(make(kind), Vector3.ONE, BODY_SCALES[(2 * kind + i + 3) % 8])


func test_a_body_that_is_mirrored_in_the_grass() -> void:
	for i in 2:
		var body := make(0)
		await press(body, Vector3.ONE, Vector3.ONE, func() -> void: body.scale = BODY_SCALES[i])
		body = make(2)
		await press(body, Vector3.ONE, BODY_SCALES[i + 2], func() -> void: body.get_child(0).scale = SHAPE_SCALES[i + 4])


## What is no body has its shape where the node has it.
func test_a_registered_shape() -> void:
	for scaled: Vector3 in [SHAPE_SCALES[0], SHAPE_SCALES[5]]:
		var field := add_field({size = Vector2(3, 3)})
		var still := add_field({size = Vector2(3, 3), simulated = false})
		await grown(still)
		var body := make(1)  # ground, which bends nothing: tells where the shape is
		add_shape(body, wedge(), Transform3D(Basis.from_euler(TURN) * Basis.from_scale(scaled), Vector3(0.03, 0.02, -0.04)))
		body.position = PLACE
		add_child(body)
		await ticks(3)
		assert_eq(field.get_awake_tile_count(), 0)
		field.register_collider(body.get_child(0), wedge())
		await ticks(60)
		var found := measure(field, still)
		assert_greater(found.grew_inside, 40)
		assert_eq(found.inside, 0, "knots inside: %s" % scaled)
		assert_less(found.moved_apart, 0.02 * found.apart, "%s" % scaled)
		body.free()
		field.free()
		still.free()

# SPDX-License-Identifier: MIT
## Far from the world's origin, on very large fields, and while the world is shifted about its origin, the simulation gives the same
## results.
extends "res://tests/field_case.gd"

const SAME := 1e-5  # of a blade's length
const FAR := Vector3(100_000, 0, -100_000)  # places here are multiples of 1/128 m in single precision
const START := Vector3(-1.25, 0.25, 0.25)
const STEP := 1.0 / 32.0  # metres a tick: exact everywhere


## Returns the farthest that a knot of one field lies from the same knot of the other, beside their fields, as a share of its
## blade's length; over all tiles awake in the first. INF if they do not have the same tiles awake, or none.
func difference(a: GrassField, b: GrassField) -> float:
	if awake_tiles(a) != awake_tiles(b) or awake_tiles(a).is_empty():
		return INF
	var most := 0.0
	for tile in awake_tiles(a):
		for blade in BLADES:
			var one := a.get_knots(tile, blade)
			var other := b.get_knots(tile, blade)
			var length := one[0].distance_to(one[1]) / CLAMP_SHARE
			for k in KNOTS:  # from the root, for the places themselves are coarse far away
				most = maxf(most, ((one[k] - one[0]) - (other[k] - other[0])).length() / length)
	return most


func rolling_ball(place: Vector3) -> RigidBody3D:
	var body := RigidBody3D.new()
	body.gravity_scale = 0.0
	body.linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	body.can_sleep = false
	body.linear_velocity = Vector3(60 * STEP, 0, 0)
	return add_body(body, ball(0.25), place)


func test_a_field_at_a_hundred_kilometres() -> void:
	var near := add_field()
	var far := add_field({position = FAR})
	var bodies: Array[PhysicsBody3D] = [add_held_body(ball(0.25), START), add_held_body(ball(0.25), FAR + START)]
	for i in 60:
		for body in bodies:
			body.position.x += STEP
		await ticks(1)
	assert_greater(near.get_awake_tile_count(), 4)
	assert_eq(awake_tiles(far), awake_tiles(near))
	# Knots are told in the world's coordinates, in steps of 8 mm out there: the bodies' records are what can be compared.
	var a := near.get_counters()
	var b := far.get_counters()
	for key: String in ["woken", "tile_steps", "colliders", "tiles_looked_at"]:
		assert_eq(b[key], a[key], key)
	for body in bodies:
		body.free()
	far.position = Vector3(0, 0, 8)  # brought back, all blades with it
	assert_less(difference(near, far), SAME)


func test_the_world_is_shifted_about_its_origin() -> void:
	for make: Callable in [func(place: Vector3) -> PhysicsBody3D: return add_held_body(ball(0.25), place), rolling_ball]:
		var still := add_field({size = Vector2(6, 4)})
		var moved := add_field({size = Vector2(6, 4), position = Vector3(0, 0, 8)})
		var first: PhysicsBody3D = make.call(START)
		var second: PhysicsBody3D = make.call(START + Vector3(0, 0, 8))
		for i in 60:
			if i in [20, 40]:
				var shift := Vector3(4096, 0, -2048) if i == 20 else Vector3(-4096, 0, 2048)
				moved.position += shift
				second.position += shift
			if first is AnimatableBody3D:
				first.position.x += STEP
				second.position.x += STEP
			await ticks(1)
			if i in [18, 22, 26, 38] and not first is RigidBody3D:
				assert_eq(awake_tiles(moved), awake_tiles(still), "%s, tick %d" % [first.get_class(), i])
		await ticks(2)
		assert_greater(still.get_awake_tile_count(), 4)
		assert_eq(moved.get_counters().evicted, 0)
		assert_less(difference(still, moved), SAME, first.get_class())
		for node: Node in [first, second, still, moved]:
			node.free()
		await ticks(2)


func test_ground_stays_ground_when_the_world_is_shifted() -> void:
	var field := add_field()
	var slab := box(Vector3(40, 1, 40))
	var floor_body := add_body(StaticBody3D.new(), slab, Vector3(0, -0.5, 0))
	await ticks(5)
	for i in 3:
		field.position += Vector3(3000, 0, 1000)
		floor_body.position += Vector3(3000, 0, 1000)
		await ticks(5)
		assert_eq(field.get_awake_tile_count(), 0, "shift %d" % i)


func test_a_field_that_leaves_its_bodies_behind() -> void:
	var field := add_field()
	add_held_body(ball(0.2), Vector3(0.25, 0.25, 0.25))
	await seen()
	assert_greater(field.get_awake_tile_count(), 0)
	field.position = Vector3(500, 0, 0)
	await ticks(12)
	assert_eq(field.get_body_count(), 0)
	assert_eq(field.get_counters().colliders, 0)
	assert_eq(field.get_counters().evicted, 0)


func test_four_by_four_kilometres() -> void:
	var field := add_field({size = Vector2(4000, 4000)})
	await ticks(2)
	assert_eq(field.get_blade_count(), 64_000_000 * 64)
	var place := Vector3(1999.0, 0.25, -1999.0)
	var tile := field.get_tile_at(place)
	assert_eq(tile, Vector2i(7998, 2))
	assert_less(field.get_memory_usage(), 64_000_000, "bytes: less than one a tile")
	assert_greater(await bend_with_ball(field, place), 0.05, "in the corner")
	assert_less(field.get_counters().tiles_looked_at, 2000, "tiles looked at, of 64 million")
	assert_less(field.get_awake_tile_count(), 60)


func test_a_static_body_comes_to_rest() -> void:
	var field := add_field()
	var body := add_body(StaticBody3D.new(), ball(0.2), Vector3(0.25, 0.25, 0.25))
	await seen()
	assert_eq(field.get_counters().colliders, 0, "ground")
	body.position.x += 0.02
	await seen()
	assert_eq(field.get_counters().colliders, 1, "it moved")
	await ticks(100)
	assert_eq(field.get_counters().colliders, 1)
	await ticks(40)
	assert_eq(field.get_counters().colliders, 0, "it has stood still for two seconds")
	body.position.x += 0.02
	await seen()
	assert_eq(field.get_counters().colliders, 1, "it moved again")


func test_a_figure_turned_round_mows_nothing() -> void:
	var long := box(Vector3(2.5, 0.3, 0.2))
	var awake: Array[int] = []
	for turn: float in [0.0, PI, 0.5]:
		var field := add_field()
		var body := add_held_body(long, Vector3(0.25, 0.25, 0.25))
		await seen()
		var before: int = field.get_counters().woken
		body.rotation.y += turn
		await ticks(4)
		awake.append(field.get_counters().woken - before)
		body.free()
		field.free()
		await ticks(2)
	assert_eq(awake[0], 0)
	assert_eq(awake[1], 0, "turned round in one tick: put there")
	assert_greater(awake[2], 0, "turned by half a radian: swept")

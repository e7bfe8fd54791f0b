# SPDX-License-Identifier: MIT
## The picture shows the effect of forces: simulated where tiles are awake, as wind elsewhere, without a jump between the two.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(192, 108)


func before() -> void:
	open_view(SIZE)
	add_light()
	look(Vector3(0, 2.2, 5.5), Vector3(0, 0.2, 0))


func add_meadow(properties := {}) -> GrassField:
	return add_seen_field({size = Vector2(8, 8), density = 64.0, seed = 4}.merged(properties, true))


func add_force(kind: GrassForce3D.Kind, properties := {}) -> GrassForce3D:
	var force := GrassForce3D.new()
	force.kind = kind
	force.turbulence = 0.0
	for property: String in properties:
		force.set(property, properties[property])
	viewport.add_child(force)
	return force


## Mean difference of two pictures, 0..1.
func apart(a: Image, b: Image) -> float:
	var sum := 0.0
	for y in SIZE.y:
		for x in SIZE.x:
			var one := a.get_pixel(x, y)
			var other := b.get_pixel(x, y)
			sum += absf(one.r - other.r) + absf(one.g - other.g) + absf(one.b - other.b)
	return sum / (3 * SIZE.x * SIZE.y)


func test_what_is_not_simulated_bends_as_well() -> void:
	var field := add_meadow({simulated = false})
	var still := await picture()
	assert_eq(apart(still, await picture()), 0.0, "nothing moves")
	var force := add_force(GrassForce3D.KIND_DOWNWASH, {speed = 15.0, radius = 3.5, position = Vector3(0, 2, 0)})
	await ticks(30)
	var blown := await picture()
	print("    downwash changes the picture by %s" % apart(still, blown))
	assert_greater(apart(still, blown), 0.002)
	assert_eq(field.get_awake_tile_count(), 0)
	force.free()
	assert_eq(apart(still, await picture()), 0.0, "and it is as it was")


func test_waking_does_not_show() -> void:
	var field := add_meadow()
	await compiled(field)
	var force := add_force(GrassForce3D.KIND_WIND, {speed = 2.7, radius = 30.0})
	await ticks(60)
	await drawn()
	assert_eq(field.get_awake_tile_count(), 0)
	var before := await next_picture()
	force.speed = 3.1  # at the centre
	await wait_until(func() -> bool: return field.get_awake_tile_count() > 50, "tiles wake", true)
	var woken := apart(before, await picture())
	force.speed = 3.5
	await ticks(30)
	var swayed := apart(before, await picture())
	force.speed = 9.0
	await ticks(120)
	var bent := apart(before, await picture())
	print("    3.1 m/s is %s from 2.7, 3.5 is %s, 9 is %s" % [woken, swayed, bent])
	assert_less(woken, 0.25 * bent)
	assert_less(woken, 1.5 * swayed)


func test_simulated_grass_and_grass_that_is_not_bend_alike() -> void:
	var field := add_meadow()
	await compiled(field)
	var still := await picture()
	add_force(GrassForce3D.KIND_WIND, {speed = 8.0, radius = 30.0})
	await ticks(240)
	var simulated := await picture()
	assert_greater(field.get_awake_tile_count(), 50)
	field.simulated = false
	await ticks(10)
	var as_wind := await picture()
	print(
		(
			"    8 m/s is %s from still, %s as wind, %s from each other"
			% [apart(still, simulated), apart(still, as_wind), apart(simulated, as_wind)]
		)
	)
	assert_near(apart(still, simulated), apart(still, as_wind), 0.5 * apart(still, as_wind))

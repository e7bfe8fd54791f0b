# SPDX-License-Identifier: MIT
## A field over its budget simulates fewer blades than it draws; the others follow them, and nobody sees the change. A budget that no
## machine keeps leads to the coarsest simulation on all of them.
extends "res://tests/view_case.gd"

const FIRST := 4  # blades of a far tile that are simulated
const TINY := 0.01  # milliseconds
const APART := 0.02  # of a blade's length: the liveliest simulated blade decides when the chains of a tile are halved
const FAR := Vector3(4, 4, 6)
const PROPERTIES := {size = Vector2(10, 6), pixels_min = 0.0, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 60.0}


func add_bodies() -> Array[AnimatableBody3D]:
	var bodies: Array[AnimatableBody3D] = []
	for i in 4:
		var body := add_held_body(ball(0.2), Vector3(-3.0, 0.15, i - 2.4))
		remove_child(body)
		viewport.add_child(body)
		bodies.append(body)
	return bodies


func roll(bodies: Array[AnimatableBody3D], count: int) -> void:
	for i in count:
		for body in bodies:
			body.position.x += 0.03
		await ticks(1)


## Ticks until the field's simulation is as coarse as it gets, or all drawn blades are simulated.
func settle(field: GrassField, coarseness: float) -> void:
	for i in 400:
		if is_equal_approx(field.get_statistics().simulation_coarseness, coarseness):
			return
		await ticks(1)
	fail("the coarseness is %f" % field.get_statistics().simulation_coarseness)


func blades_of(field: GrassField) -> PackedInt64Array:
	var blades := PackedInt64Array()
	for tile in awake_tiles(field):
		if field.get_tile_center(tile).distance_to(camera.position) > 5.5:
			blades.append_array(field.get_tile_blades(tile))
	return blades


func test_simulated_blades_move_as_without_a_budget_and_the_others_follow() -> void:
	look(FAR, Vector3.ZERO)
	var plain := add_seen_field(PROPERTIES)
	var limited := add_seen_field(PROPERTIES.merged({simulation_budget = TINY}))
	var still := add_seen_field(PROPERTIES.merged({simulated = false}))
	await fields_shown()
	var bodies := add_bodies()
	await compiled(limited)
	await roll(bodies, 8)
	await compiled(limited)
	await roll(bodies, 90)
	assert_greater(limited.get_statistics().simulation_coarseness, 3.0)
	assert_eq(plain.get_statistics().simulation_coarseness, 1.0)
	assert_eq(plain.get_counters().followed_blade_steps, 0)
	var before := limited.get_counters()
	await roll(bodies, 20)
	var after := limited.get_counters()
	var followed: int = after.followed_blade_steps - before.followed_blade_steps
	var tiles: int = after.tile_steps - before.tile_steps
	print("    %d blades a tile follow, %d are simulated" % [followed / tiles, (after.simulated_blades - before.simulated_blades) / tiles])
	assert_greater(followed, 10 * tiles)
	var blades := blades_of(plain)
	assert_eq(blades, blades_of(limited))
	assert_greater(blades.size(), 20 * BLADES)
	check_followers(blades, plain.wait_for_knots(blades), limited.wait_for_knots(blades), still.wait_for_knots(blades))


func check_followers(blades: PackedInt64Array, whole: PackedVector3Array, limited: PackedVector3Array, rest: PackedVector3Array) -> void:
	var same := 0
	var bent := 0
	var following := 0
	for tile in blades.size() / BLADES:
		var offsets := PackedVector3Array()
		var roots := PackedVector3Array()
		for i in BLADES:
			var blade := BLADES * tile + i
			var own := blade_of(limited, blade)
			var at_rest := blade_of(rest, blade)
			roots.append(at_rest[0])
			offsets.append((own[15] - at_rest[15]) * CLAMP_SHARE / at_rest[0].distance_to(at_rest[1]))
			if i < FIRST:
				same += int(farthest(own, blade_of(whole, blade)) < APART * length_of(whole, blade))
				continue
			var nearest := 0
			for other in FIRST:
				nearest = other if roots[i].distance_to(roots[other]) < roots[i].distance_to(roots[nearest]) else nearest
			if offsets[nearest].length() > 0.2:
				bent += 1
				following += int(offsets[i].normalized().dot(offsets[nearest].normalized()) > 0.7)
	var simulated := blades.size() / BLADES * FIRST
	print("    %d of %d simulated blades are the same, %d of %d followers follow" % [same, simulated, following, bent])
	assert_greater(same, 0.97 * simulated)
	assert_greater(bent, 100)
	assert_greater(following, 0.8 * bent)


## Most change from one picture to the next, and from the first to the last. The bodies tremble, since tiles in which nothing moves are
## not simulated.
func most_change(bodies: Array[AnimatableBody3D], count: int) -> Vector2:
	var most := 0.0
	var first: Image = null
	var before: Image = null
	for i in count:
		for body in bodies:
			body.position.y += 0.0002 if i % 2 == 0 else -0.0002
		await ticks(1)
		if i % 2 == 1:
			var now := await next_picture()
			most = maxf(most, difference(now, before).y) if before else 0.0
			first = first if first else now
			before = now
	return Vector2(most, difference(before, first).y)


func test_nobody_sees_the_budget_at_work() -> void:
	viewport.free()
	open_view(Vector2i(96, 54))
	add_light()
	look(Vector3(0.4, 1.7, 6.5), Vector3.ZERO)
	var field := add_seen_field(PROPERTIES)
	await fields_shown()
	var bodies := add_bodies()
	await compiled(field)
	await roll(bodies, 8)
	await compiled(field)
	await roll(bodies, 80)
	await ticks(20)
	var rested := (await most_change(bodies, 30)).x
	field.simulation_budget = TINY
	var changes := await most_change(bodies, 130)
	assert_greater(field.get_counters().followed_blade_steps, 1000)
	print("    most change without a budget %.5f, as it comes to work %.5f; all changes %.5f" % [rested, changes.x, changes.y])
	assert_less(changes.x, 1.15 * rested)
	field.simulation_budget = 0.0
	await settle(field, 1.0)

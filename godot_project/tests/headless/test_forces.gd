# SPDX-License-Identifier: MIT
## Forces: blasts, downwash, vortices and local winds bend the grass, wake the tiles that they move, and let the grass return to rest.
extends "res://tests/field_case.gd"

const KINDS: Array[GrassForce3D.Kind] = [
	GrassForce3D.KIND_BLAST, GrassForce3D.KIND_DOWNWASH, GrassForce3D.KIND_VORTEX, GrassForce3D.KIND_WIND
]


func add_force(kind: GrassForce3D.Kind, properties := {}) -> GrassForce3D:
	var force := GrassForce3D.new()
	force.kind = kind
	for property: String in properties:
		force.set(property, properties[property])
	add_child(force)
	return force


func add_meadow(properties := {}) -> GrassField:
	return add_field({size = Vector2(16, 16), density = 64.0}.merged(properties, true))


## Returns where the tips of the tile around `place` lean, shares of their blades.
func lean_at(field: GrassField, place: Vector3) -> Vector3:
	var knots := tile_knots(field, field.get_tile_at(place))
	var sum := Vector3.ZERO
	for blade in BLADES:
		var own := blade_of(knots, blade)
		sum += (own[KNOTS - 1] - own[0]) / length_of(knots, blade)
	return sum / BLADES


func test_a_blast_flattens_the_grass_and_it_rises_again() -> void:
	var field := add_meadow()
	await ticks(2)
	var places: Array[Vector3] = [Vector3(2, 0, 0), Vector3(-2, 0, 0), Vector3(0, 0, 2), Vector3(0, 0, -2)]
	var before := places.map(func(place: Vector3) -> Vector3: return lean_at(field, place))
	field.blast(Vector3(0, 0.3, 0), 40.0, 5.0, 0.6)
	await ticks(12)
	assert_eq(field.get_counters().forces, 1)
	assert_greater(field.get_awake_tile_count(), 20)
	assert_eq(field.get_counters().colliders, 0, "a force is no collider")
	for i in places.size():
		var lean := lean_at(field, places[i])
		var outwards := places[i].normalized()
		assert_greater(lean.dot(outwards) - before[i].dot(outwards), 0.4, "it leans away")
		assert_less(lean.y, before[i].y - 0.1, "and lies lower")
	await ticks_to_sleep(field)
	for i in places.size():
		assert_eq(lean_at(field, places[i]), before[i])
	assert_eq(field.get_counters().forces, 0)


func test_each_force_bends_as_it_blows() -> void:
	var field := add_meadow()
	await ticks(2)
	var place := Vector3(1.5, 0, 0)
	var rest := lean_at(field, place)
	var ways: Array[Vector3] = [Vector3.RIGHT, Vector3.RIGHT, Vector3.BACK, Vector3.FORWARD]
	for kind in KINDS:
		var force := add_force(kind, {speed = 15.0, radius = 4.0, turbulence = 0.0, duration = 9.0, position = Vector3(0, 0.2, 0)})
		if kind == GrassForce3D.KIND_BLAST:
			assert_false(force.is_blowing())
			force.fire()
		assert_true(force.is_blowing())
		await ticks(60)
		var lean := lean_at(field, place) - rest
		assert_greater(lean.dot(ways[kind]), 0.15, "kind %d: %s" % [kind, lean])
		assert_greater(lean.dot(ways[kind]), absf(lean.dot(ways[kind].cross(Vector3.UP))), "kind %d: %s" % [kind, lean])
		assert_true(all_finite(field, awake_tiles(field)))
		force.free()
		await ticks_to_sleep(field)


func test_only_tiles_that_a_force_moves_are_awake() -> void:
	var field := add_meadow()
	var force := add_force(GrassForce3D.KIND_WIND, {speed = 2.5, radius = 4.0, turbulence = 0.0})
	await ticks(30)
	assert_eq(field.get_awake_tile_count(), 0, "a breath wakes none")
	assert_eq(field.get_counters().forces, 1)
	force.speed = 12.0
	await ticks(60)
	var awake := awake_tiles(field)
	assert_greater(awake.size(), 12)
	for tile in awake:
		var centre := field.get_tile_center(tile)
		assert_less(maxf(absf(centre.x), absf(centre.z)), 4.0 + 2.0)
	force.position = Vector3(40, 0, 0)
	await ticks_to_sleep(field)
	assert_eq(field.get_counters().forces, 0, "it is too far away")


func test_blades_come_to_stand_still_in_a_steady_wind() -> void:
	var field := add_meadow()
	var force := add_force(GrassForce3D.KIND_WIND, {speed = 12.0, radius = 4.0, turbulence = 0.0})
	await wait_until(
		func() -> bool: return field.get_counters().still_tiles > 0 and field.get_counters().still_tiles == field.get_awake_tile_count(),
		"all awake tiles are still",
		true
	)
	force.speed = 14.0
	await ticks(3)
	assert_eq(field.get_counters().still_tiles, 0, "another wind moves them")


func test_a_push_blows_along_its_velocity() -> void:
	var field := add_meadow({position = Vector3(100, 5, -30), rotation = Vector3(0, 1.2, 0)})
	await ticks(2)
	var place := field.to_global(Vector3(1, 0, 1))
	var rest := lean_at(field, place)
	field.push(place, Vector3(0, 0, -20), 3.0, 1.0)
	await ticks(15)
	var lean := lean_at(field, place) - rest
	assert_greater(-lean.z, 0.3)
	assert_less(absf(lean.x), 0.3 * -lean.z)


func test_methods_move_alike() -> void:
	var leans: Array[Vector3] = []
	for method: GrassField.SolverMethod in [GrassField.METHOD_DIRECT, GrassField.METHOD_PBD]:
		var field := add_meadow({method = method})
		await ticks(2)
		var rest := lean_at(field, Vector3(0.5, 0, 0.5))
		var force := add_force(GrassForce3D.KIND_WIND, {speed = 8.0, radius = 6.0, turbulence = 0.0})
		await ticks(240)
		leans.append(lean_at(field, Vector3(0.5, 0, 0.5)) - rest)
		force.free()
		field.free()
	assert_greater(-leans[0].z, 0.1)
	assert_greater(-leans[1].z, 0.1)


func test_no_more_than_sixteen_count_the_strongest() -> void:
	var field := add_meadow()
	for i in 20:
		field.push(Vector3(i * 0.5 - 5, 0, 0), Vector3(4.0 + i, 0, 0), 1.0, 2.0)
	await ticks(2)
	assert_eq(field.get_counters().forces, 16)
	assert_eq(field.get_counters().forces_left_out, 4)
	await ticks(10)
	assert_less(field.get_bend_at(Vector3(-5, 0, 0)).length(), 0.01, "where the weakest would blow")
	assert_greater(field.get_bend_at(Vector3(4.5, 0, 0)).length(), 0.1, "where the strongest blows")


func test_forces_of_another_world_or_hidden_ones_do_not_blow() -> void:
	var field := add_meadow()
	var force := add_force(GrassForce3D.KIND_WIND, {speed = 20.0})
	force.visible = false
	await ticks(3)
	assert_eq(field.get_counters().forces, 0)
	force.visible = true
	await ticks(3)
	assert_eq(field.get_counters().forces, 1)
	force.enabled = false
	await ticks(3)
	assert_eq(field.get_counters().forces, 0)
	var other := SubViewport.new()
	other.own_world_3d = true
	add_child(other)
	force.reparent(other)
	force.enabled = true
	await ticks(3)
	assert_eq(field.get_counters().forces, 0)


func add_windy_area(properties := {}) -> Area3D:
	var area := Area3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	shape.shape.size = Vector3(6, 3, 6)
	area.add_child(shape)
	var source := Node3D.new()
	source.name = "Source"
	source.rotation.y = PI / 2  # its -z is -x
	area.add_child(source)
	area.wind_source_path = ^"Source"
	area.wind_attenuation_factor = 0.0
	for property: String in properties:
		area.set(property, properties[property])
	add_child(area)
	return area


func test_the_wind_of_an_area_blows() -> void:
	var field := add_meadow()
	await ticks(2)
	var rest := lean_at(field, Vector3(1, 0, 0))
	var area := add_windy_area({wind_force_magnitude = 12.0})
	await ticks(60)
	assert_eq(field.get_counters().forces, 1)
	var lean := lean_at(field, Vector3(1, 0, 0)) - rest
	assert_greater(-lean.x, 0.15, "along -z of its source: %s" % lean)
	area.wind_force_magnitude = 0.0
	await ticks_to_sleep(field)
	assert_eq(field.get_counters().forces, 0)
	area.wind_force_magnitude = 12.0
	await ticks(5)
	assert_eq(field.get_counters().forces, 1)
	area.free()
	await ticks_to_sleep(field)
	assert_eq(field.get_counters().forces, 0)


func test_an_area_without_a_source_does_not_blow() -> void:
	var field := add_meadow()
	add_windy_area({wind_force_magnitude = 12.0, wind_source_path = ^""})
	add_windy_area({wind_force_magnitude = 12.0, collision_layer = 2})
	await ticks(10)
	assert_eq(field.get_counters().forces, 0)


func test_no_body_enters_with_a_force() -> void:
	var field := add_meadow()
	var entered := []
	field.body_entered_grass.connect(entered.append)
	add_force(GrassForce3D.KIND_DOWNWASH)
	await ticks(5)
	assert_greater(field.get_awake_tile_count(), 0)
	assert_eq(entered, [])
	assert_eq(field.get_counters().colliders, 0)


func test_bad_input_is_refused_by_name() -> void:
	var field := add_meadow()
	expect_error("blast() needs a finite position")
	field.blast(Vector3(NAN, 0, 0))
	expect_error("push() needs a finite position and a finite velocity")
	field.push(Vector3.ZERO, Vector3(0, INF, 0))
	expect_error("`radius`")
	field.blast(Vector3.ZERO, 20.0, -3.0)
	expect_error("fire() is for `kind` Blast")
	add_force(GrassForce3D.KIND_WIND).fire()
	expect_error("before fire()")
	var loose := GrassForce3D.new()
	loose.fire()
	loose.free()
	await ticks(3)
	assert_true(all_finite(field, awake_tiles(field)))


func test_random_forces_leave_finite_blades_of_their_lengths() -> void:
	var field := add_meadow({size = Vector2(6, 6)})
	await ticks(2)
	var random := RandomNumberGenerator.new()
	random.seed = 7
	var tiles: Array[Vector2i] = [field.get_tile_at(Vector3.ZERO), field.get_tile_at(Vector3(1.6, 0, -1.1))]
	var rest := knots_of(field, tiles)
	for round in 12:
		var force := add_force(
			KINDS[random.randi() % KINDS.size()],
			{
				speed = random.randf_range(-100, 100),
				radius = random.randf_range(0.1, 20.0),
				turbulence = random.randf(),
				duration = random.randf_range(0.05, 1.0),
				position = Vector3(random.randf_range(-3, 3), random.randf_range(-1, 2), random.randf_range(-3, 3))
			}
		)
		if force.kind == GrassForce3D.KIND_BLAST:
			force.fire()
		await ticks(15)
		for tile in tiles:
			var knots := tile_knots(field, tile)
			for blade: int in [0, 31, 63]:
				assert_near(length_of(knots, blade), length_of(rest[tile], blade), 1e-3 * length_of(rest[tile], blade))
		if round % 3 == 2:
			for child in get_children():
				if child is GrassForce3D:
					child.free()
	for child in get_children():
		if child is GrassForce3D:
			child.free()
	await ticks_to_sleep(field)
	assert_eq(farthest_of(field, rest), 0.0, "they come back to rest")


func test_the_wind_of_an_area_fades_on_its_way() -> void:
	var field := add_meadow()
	var area := add_windy_area({wind_force_magnitude = 12.0, wind_attenuation_factor = 1.0})
	area.get_node(^"Source").position.x = 11.0
	await ticks(30)
	assert_eq(field.get_counters().forces, 1)
	assert_eq(field.get_awake_tile_count(), 0, "a twelfth of it is a breeze")

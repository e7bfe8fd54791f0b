# SPDX-License-Identifier: MIT
## The amount of work, by the counters: none where nothing changes, and no more on a large field than on a small one.
extends "res://tests/field_case.gd"

const SIZES: Array[float] = [70.5, 500.0]  # metres: 20 thousand and 1 million tiles


func test_the_same_work_on_any_field() -> void:
	var fields: Array[GrassField] = []
	for size_ in SIZES:
		fields.append(add_field({size = Vector2(size_, size_)}))
	await ticks(2)
	var bodies: Array[PhysicsBody3D] = []
	for i in 24:
		# On both fields at the same place within a tile.
		bodies.append(add_held_body(ball(0.1 + 0.01 * i), Vector3(0.25 + 1.5 * (i % 6) - 4.0, 0.2, 0.25 + 1.5 * floorf(i / 6.0) - 3.0)))
	for i in 20:
		for body in bodies:
			body.position.x += 0.02
		await ticks(1)
	var small := fields[0].get_counters()
	var large := fields[1].get_counters()
	assert_greater(fields[1].get_blade_count(), 50 * fields[0].get_blade_count() - 1)
	for key: String in ["body_reads", "shape_reads"]:
		assert_eq(large[key], small[key], key)
	for key: String in ["tiles_looked_at", "tile_steps", "colliders", "woken"]:  # the grids lie a little differently under the bodies
		assert_less(absf(large[key] - small[key]), 0.2 * small[key], key)
	assert_less(absf(fields[1].get_memory_usage() - fields[0].get_memory_usage()), 1e6, "bytes")


func test_nothing_near_looks_at_nothing() -> void:
	var field := add_field({size = Vector2(500, 500)})
	await ticks(60)
	var now := field.get_counters()
	for key: String in ["steps", "simulated_blades", "tiles_looked_at", "body_reads", "shape_reads", "woken"]:
		assert_eq(now[key], 0, key)


func test_many_changes_at_once_make_the_field_once() -> void:
	var field := add_field()
	await ticks(2)
	assert_eq(field.get_counters().makings, 1)
	field.seed = 3
	field.pool_tiles = 100
	field.clump_lean = 0.5
	field.size = Vector2(6, 6)
	await ticks(2)
	assert_eq(field.get_counters().makings, 2)
	field.seed = 3
	field.wind_speed = 4.0
	field.sleep_delay = 1.0
	await ticks(2)
	assert_eq(field.get_counters().builds, 1, "nothing that it is made of has changed")


## As any other change of what it is made of: its blades stand, and what touches them bends them again.
func test_another_method_makes_the_field_anew() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.3), Vector3(0.25, 0.25, 0.25))
	await ticks(10)
	var before := field.get_counters()
	assert_greater(before.steps, 0)
	body.free()
	field.method = GrassField.METHOD_PBD
	await ticks(2)
	var after := field.get_counters()
	assert_eq(after.makings, before.makings + 1)
	assert_eq(after.builds, before.builds, "what was made serves")
	assert_eq(field.get_awake_tile_count(), 0, "at rest")
	field.method = GrassField.METHOD_PBD
	await ticks(2)
	assert_eq(field.get_counters().makings, after.makings, "the same method again")
	add_held_body(ball(0.3), Vector3(0.25, 0.25, 0.25))
	await ticks(10)
	assert_greater(field.get_bend_at(Vector3(0.4, 0, 0.25)).length(), 0.1)


## Looks, and shares that leave each blade its species: a ball keeps the grass down that it lies on.
func test_what_changes_no_blade_stands_none_up() -> void:
	var only := GrassSpecies.new()
	var field := add_field({species = [only]})
	add_held_body(ball(0.3), Vector3(0.25, 0.25, 0.25))
	await ticks(300)
	var before := field.get_counters()
	var bent := tile_knots(field, field.get_tile_at(Vector3(0.25, 0, 0.25)))
	for i in 20:
		field.clump_tint = 0.04 * i
		field.pool_tiles = 1000 + 7 * i
		only.share = 0.02 * (i + 1)
		only.tip_color = Color(0.05 * i, 0.5, 0.1)
		await ticks(1)
	var after := field.get_counters()
	assert_eq(after.makings, before.makings)
	assert_eq(after.pool_tiles, 1133)
	assert_less(farthest(tile_knots(field, field.get_tile_at(Vector3(0.25, 0, 0.25))), bent), 0.01)
	field.pool_tiles = 0
	await ticks(1)
	assert_eq(field.get_awake_tile_count(), 0)
	field.pool_tiles = 500
	await ticks(10)
	assert_greater(field.get_bend_at(Vector3(0.4, 0, 0.25)).length(), 0.1)


func test_shares_of_two_species_count_by_what_they_change() -> void:
	var two: Array[GrassSpecies] = [GrassSpecies.new(), GrassSpecies.new()]
	two[1].share = 0.0
	var field := add_field({species = two})
	await ticks(2)
	assert_eq(field.get_counters().makings, 1)
	two[0].share = 0.25
	await grown(field)
	assert_eq(field.get_counters().makings, 1, "all of it, as before")
	two[1].share = 0.25
	await grown(field)
	assert_eq(field.get_counters().makings, 2)


func test_a_field_that_grows_keeps_its_pool() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), Vector3(0.25, 0.25, 0.25))
	for i in 20:
		field.size += Vector2(30, 30)
		if i % 5 == 4:
			field.density += 40.0
		await seen()
		assert_greater(field.get_awake_tile_count(), 0, "size %s" % field.size)
		assert_true(all_finite(field, awake_near(field, body.position)), "size %s" % field.size)
	assert_eq(field.get_counters().builds, 1)
	assert_greater(field.get_blade_count(), 100_000_000)
	# As if it had been made so.
	var fresh := add_field({size = field.size, density = field.density})
	body.free()
	await ticks(1000)
	assert_eq(field.get_awake_tile_count(), 0)
	for place: Vector3 in [Vector3(0.3, 0, 0.4), Vector3(200, 0, -100)]:
		assert_eq(field.get_tile_at(place), fresh.get_tile_at(place))
		assert_eq(tile_knots(field, field.get_tile_at(place)), tile_knots(fresh, fresh.get_tile_at(place)))
	assert_near(field.get_memory_usage(), fresh.get_memory_usage(), 4e6, "bytes: nothing piles up")


func awake_near(field: GrassField, place: Vector3) -> Array[Vector2i]:
	var middle := field.get_tile_at(place)
	var found: Array[Vector2i] = []
	for x in range(-3, 4):
		for z in range(-3, 4):
			if field.is_tile_awake(middle + Vector2i(x, z)):
				found.append(middle + Vector2i(x, z))
	return found


func test_memory_of_a_crowd_comes_back() -> void:
	var field := add_field({size = Vector2(30, 30), sleep_delay = 0.1, sleep_mode = GrassField.SLEEP_TIMER, settle_time = 0.1})
	await ticks(2)
	var alone := field.get_memory_usage()
	var bodies: Array[AnimatableBody3D] = []
	for i in 100:
		bodies.append(add_held_body(ball(0.4), Vector3(2.6 * (i % 10) - 12.0, 0.2, 2.6 * floorf(i / 10.0) - 12.0)))
	await ticks(10)
	assert_greater(field.get_awake_tile_count(), 800)
	var crowded := field.get_memory_usage()
	assert_greater(crowded - alone, 800 * 30_000, "bytes: blades have state")
	for i in range(1, 100):
		bodies[i].free()
	await ticks(30)
	assert_less(field.get_awake_tile_count(), 40)
	assert_near(field.get_memory_usage(), crowded, 5e5, "bytes: who comes back soon finds it as it was")
	await ticks(220)
	assert_less(field.get_memory_usage() - alone, 0.2 * (crowded - alone), "bytes left")
	assert_greater(field.get_bend_at(bodies[0].position).length(), 0.1, "under the last one grass is bent as before")
	var low := field.get_memory_usage()
	await ticks(400)
	assert_eq(field.get_memory_usage(), low, "no coming and going")
	for i in 60:  # the crowd again
		bodies.append(add_held_body(ball(0.4), Vector3(2.6 * (i % 10) - 12.0, 0.2, 2.6 * floorf(i / 10.0) - 6.0)))
	await ticks(10)
	assert_greater(field.get_awake_tile_count(), 400)
	assert_true(all_finite(field, awake_near(field, bodies[-1].position)))


func test_a_scene_file_is_small() -> void:
	var root := Node3D.new()
	var field := GrassField.new()
	field.size = Vector2(500, 500)  # 64 million blades
	root.add_child(field)
	field.owner = root
	var scene := PackedScene.new()
	assert_eq(scene.pack(root), OK)
	var path := OS.get_user_data_dir().path_join("test_scene.tscn")
	assert_eq(ResourceSaver.save(scene, path), OK)
	assert_less(FileAccess.get_file_as_bytes(path).size(), 10_000, "bytes")
	DirAccess.remove_absolute(path)
	root.free()

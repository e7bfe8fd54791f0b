# SPDX-License-Identifier: MIT
## What a level draws, and that the pool on the device changes its size under blades that are bent.
extends "res://tests/view_case.gd"

const PLACE := Vector3(0.3, 0.25, 0.2)


func before() -> void:
	super()
	add_light()
	look(Vector3(0, 1.5, 4), Vector3.ZERO)


func after() -> void:
	GrassQuality.reset_level()


func counts_of(field: GrassField) -> Dictionary:
	return field.get_statistics().merged(field.get_counters())


func test_two_fields_draw_less_together_and_as_much_again() -> void:
	var fields: Array[GrassField] = []
	for i in 2:
		fields.append(add_seen_field({size = Vector2(8, 20), position = Vector3(8 * i - 4, 0, -6)}))
		fields[i].cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON
	var pictures: Array[Image] = []
	var told: Array[Array] = []
	for level in [2, 0, 2]:
		GrassQuality.set_level(level)
		await drawn()
		told.append(fields.map(counts_of))
		pictures.append(await picture())
	assert_eq(difference(pictures[0], pictures[2]), Vector2.ZERO, "as designed again")
	assert_greater(difference(pictures[0], pictures[1]).y, 1e-4, "it shows")
	for i in 2:
		for what: String in ["drawn_blades", "drawn_triangles", "shadow_blades", "shadow_triangles"]:
			assert_greater(told[0][i][what], 0, what)
			var most := 1.0 if what == "shadow_triangles" else 0.9  # in so small a picture each tile has three at least
			assert_less(told[1][i][what], most * told[0][i][what], what)
			assert_eq(told[2][i][what], told[0][i][what], what)
		for what: String in ["makings", "builds", "map_bytes"]:
			assert_eq(told[2][i][what], told[0][i][what], what)
		assert_eq(told[1][i].pool_tiles, 1024)
		assert_eq(told[2][i].memory, told[0][i].memory)


## Two fields with the same blades and bodies, of which one has another pool at every moment: the same knots, and the same picture.
func test_blades_stay_bent_on_the_device() -> void:
	var map := full_map()
	var field := add_seen_field({pool_tiles = 400, map = map, species = [GrassSpecies.new(), GrassSpecies.new()] as Array[GrassSpecies]})
	await drawn()
	await compiled(field)
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	add_shape(body, ball(0.3))
	body.position = PLACE + Vector3(1.4, 0, 1.4)
	viewport.add_child(body)
	await ticks(4)
	body.position = PLACE
	await ticks(60)  # where it was first the grass sleeps: the tiles that are awake have other slots than the first
	var awake := awake_tiles(field)
	assert_greater(awake.size(), 3)
	assert_less(awake.size(), 100)
	field.process_mode = PROCESS_MODE_DISABLED  # as in a menu that pauses the game
	await ticks(1)
	var knots := knots_of(field, awake)
	var image := await picture()
	for level in [0, 3, 2]:
		GrassQuality.set_level(level)
		await picture()
		assert_eq(field.get_counters().pool_tiles, [100, 200, 400, 800][level])
		assert_eq(awake_tiles(field), awake)
		assert_eq(knots_of(field, awake), knots, "level %d" % level)
	assert_eq(difference(await picture(), image), Vector2.ZERO)
	field.process_mode = PROCESS_MODE_INHERIT
	await ticks(8)
	assert_eq(awake_tiles(field), awake)
	assert_true(all_finite(field, awake))
	assert_greater(field.get_bend_at(PLACE + Vector3(0.2, 0, 0)).length(), 0.1)
	body.free()


func test_plants_have_meshes_less_far() -> void:
	var fern := GrassSpecies.new()
	fern.plant_mesh = BoxMesh.new()
	fern.plant_distance = 8.0
	var field := add_seen_field({size = Vector2(12, 12), density = 16.0, species = [fern] as Array[GrassSpecies]})
	var plants: Array[int] = []
	for level in [2, 0, 2]:
		GrassQuality.set_level(level)
		await drawn()
		plants.append(field.get_counters().drawn_plants)
	assert_greater(plants[0], 0)
	assert_less(plants[1], 0.8 * plants[0])
	assert_eq(plants[2], plants[0])
	assert_eq(field.get_counters().makings, 1)

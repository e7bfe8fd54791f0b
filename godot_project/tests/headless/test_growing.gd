# SPDX-License-Identifier: MIT
## A field that changes at run time: what is kept, and what is drawn until the new blades are ready.
extends "res://tests/field_case.gd"

const TILE := Vector2i(3, 3)


func long_blades(length: float) -> GrassPatch:
	var patch := GrassPatch.new()
	patch.length_max = length
	return patch


func test_other_blades_come_when_they_are_there() -> void:
	var field := add_field()
	await ticks(2)
	var before := field.get_counters()
	var old := tile_knots(field, TILE)
	for i in 5:  # the last one counts
		field.species = kind({patch = long_blades(0.5 + 0.1 * i)})
		field.species[0].patch.length_min = 0.4
	assert_eq(tile_knots(field, TILE), old, "the old grass stands")
	assert_eq(field.get_counters().makings, before.makings, "nobody waits")
	await made(field, before.makings + 1)
	var fresh := add_field({species = field.species})
	await ticks(2)
	assert_eq(tile_knots(field, TILE), tile_knots(fresh, TILE))
	assert_ne(tile_knots(field, TILE), old)
	await frames(20)
	var after := field.get_counters()
	assert_eq(after.makings, before.makings + 1, "once for ten changes")
	assert_eq(after.builds, before.builds, "in the same buffers")


func test_what_changes_meanwhile_comes_with_it() -> void:
	var field := add_field()
	await ticks(2)
	var before := field.get_counters()
	field.species = kind({patch = long_blades(0.6)})
	field.size = Vector2(6, 6)
	await grown(field)
	assert_eq(field.get_counters().makings, before.makings + 1, "once")
	same_as_fresh(field)


## A field is made for whoever asks first; a change of one that stands comes in a frame, whoever asks meanwhile.
func test_a_query_makes_a_first_field_and_hastens_no_change() -> void:
	var field := add_field()
	assert_eq(field.get_counters().makings, 0)
	assert_true(field.is_grass_at(Vector3.ZERO))
	assert_eq(field.get_counters().makings, 1, "nobody waits for the first one")
	await frames(2)
	var before := field.get_grid_size()
	field.size = Vector2(8, 8)
	assert_true(field.is_grass_at(Vector3.ZERO))
	field.regrow(0.1, 0.0)
	assert_eq(field.get_grid_size(), before, "it stands as it was")
	await wait_until(func() -> bool: return not field.get_statistics().waiting, "the change is there")
	assert_greater(field.get_grid_size().x, before.x)
	assert_eq(field.get_counters().makings, 2)


func test_what_keeps_the_buffers() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), Vector3(0.25, 0.25, 0.25))
	await seen()
	assert_greater(field.get_awake_tile_count(), 0)
	var builds: int = field.get_counters().builds
	var flower := GrassSpecies.new()
	flower.patch = long_blades(0.7)
	for change: Dictionary in [
		{seed = 7},
		{clump_lean = 0.4},
		{clump_size = 2.0},
		{density = 300.0},
		{size = Vector2(9, 9)},
		{pool_tiles = 64},
		{pool_tiles = 5000},
		{map = full_map()},
		{species = [GrassSpecies.new(), flower]},
		{species = [flower]},
		{map = null},
		{species = []}
	]:
		var property: String = change.keys()[0]
		field.set(property, change[property])
		await grown(field)
		await seen()
		assert_eq(field.get_counters().builds, builds, property)
		assert_greater(field.get_awake_tile_count(), 0, property)
		assert_true(all_finite(field, awake_tiles(field)), property)
		same_as_fresh(field)
	body.free()


## Whether blades at rest stand as in a field that was made of the same properties.
func same_as_fresh(field: GrassField, tile := Vector2i(0, 0)) -> void:
	var properties := {simulated = false}
	for property: String in ["seed", "clump_lean", "clump_size", "density", "size", "species", "map"]:
		properties[property] = field.get(property)
	var fresh := add_field(properties)
	fresh.get_density_at(Vector3.ZERO)  # at once
	assert_eq(tile_knots(field, tile), tile_knots(fresh, tile))
	fresh.free()


## Hills of another height on each: what a field takes some frames to take over.
func hilly_map(height: float, side := 300.0) -> GrassMap:
	var map := full_map()
	var heights := Image.create_empty(64, 64, false, Image.FORMAT_RF)
	for x in 64:
		for z in 64:
			heights.set_pixel(x, z, Color(height + 0.2 * height * sin(0.2 * x) * cos(0.3 * z), 0, 0))
	assert_true(map.set_ground(heights, Rect2(-0.5 * side, -0.5 * side, side, side)))
	return map


func test_another_map_comes_when_it_is_laid_out() -> void:
	var field := add_field({map = hilly_map(1.0), size = Vector2(300, 300)})
	await ticks(2)
	var before := field.get_counters()
	var tile := field.get_grid_size() / 2
	var old := tile_knots(field, tile)
	var next := hilly_map(3.0)
	field.map = next
	next.stroke(brush(GrassBrush.TOOL_HEIGHT, 5.0, {target = 0.5}), Vector2(60, 0), Vector2(60, 0))
	for i in 2:
		await frames(1)
		assert_true(field.get_statistics().waiting, "it takes longer than that")
		assert_eq(tile_knots(field, tile), old, "the old map shows")
		assert_eq(field.get_density_at(Vector3(-100, 0, 100)), 1.0)
	next.stroke(brush(GrassBrush.TOOL_ERASE, 8.0), Vector2(-100, 100), Vector2(-100, 100))  # while it is being laid out
	next.stroke(brush(GrassBrush.TOOL_ERASE, 8.0), Vector2(100, 100), Vector2(100, 100))
	assert_eq(field.get_density_at(Vector3(-100, 0, 100)), 0.0, "what is asked of the map holds at once")
	assert_eq(field.get_density_at(Vector3(100, 0, 100)), 0.0)
	assert_eq(field.get_density_at(Vector3(100, 0, 80)), 1.0)
	assert_near(field.get_height_at(Vector3(60, 0, 0)) / field.get_height_at(Vector3(60, 0, 9)), 0.5, 0.25)
	await grown(field)
	var after := field.get_counters()
	assert_eq(after.makings, before.makings + 1)
	assert_eq(after.builds, before.builds)
	assert_greater(after.bare_tiles, 1000)
	assert_eq(field.get_density_at(Vector3(-100, 0, 100)), 0.0)
	for place: Vector2 in [Vector2(0, 0), Vector2(60, 0), Vector2(-100, 91), Vector2(108, 100), Vector2(-149, 149)]:
		same_as_fresh(field, field.get_tile_at(Vector3(place.x, 0, place.y)))


func test_a_large_change_of_a_map_comes_piece_by_piece() -> void:
	var map := hilly_map(1.0)
	var field := add_field({map = map, size = Vector2(300, 300)})
	await ticks(2)
	var makings: int = field.get_counters().makings
	var flat := map.take_snapshot()
	map.stroke(brush(GrassBrush.TOOL_ERASE, 3.0), Vector2.ZERO, Vector2.ZERO)
	await ticks(1)
	assert_eq(field.get_counters().map_waiting, 0, "a stroke is there at once")
	assert_greater(field.get_counters().bare_tiles, 50)
	var erased := map.take_snapshot()
	map.clear()
	assert_greater(field.get_counters().map_waiting, 20)
	assert_eq(field.get_density_at(Vector3(140, 0, 140)), 1.0)
	map.restore_snapshot(flat)
	map.restore_snapshot(erased)
	assert_eq(field.get_density_at(Vector3.ZERO), 0.0, "what is asked of the map holds at once")
	await grown(field)
	assert_eq(field.get_counters().makings, makings, "it was not made again")
	assert_greater(field.get_counters().bare_tiles, 50)
	for place: Vector2 in [Vector2(0, 0), Vector2(3, 1), Vector2(-100, 100), Vector2(149, -149)]:
		same_as_fresh(field, field.get_tile_at(Vector3(place.x, 0, place.y)))


func test_nobody_waits_for_the_blades_of_a_species() -> void:
	var one := GrassSpecies.new()
	var two := GrassSpecies.new()
	two.patch = long_blades(0.6)
	var field := add_field({species = [one, two]})
	await ticks(2)
	var before := field.get_counters()
	var old := tile_knots(field, TILE)
	for i in 5:
		two.patch.length_max = 0.7 + 0.1 * i
		one.share = 0.1 + 0.1 * i
	assert_eq(tile_knots(field, TILE), old)
	assert_true(field.get_statistics().waiting)
	await grown(field)
	assert_eq(field.get_counters().makings, before.makings + 1, "once for ten changes")
	assert_ne(tile_knots(field, TILE), old)
	same_as_fresh(field, TILE)


func test_freed_and_taken_out_meanwhile() -> void:
	for i in 12:
		var field := add_field()
		await ticks(2)
		var patch := long_blades(0.5 + 0.01 * i)
		field.species = kind({patch = patch})
		match i % 4:
			0:
				field.free()
			1:
				remove_child(field)
				await frames(2)
				add_child(field)
				await ticks(2)
				assert_greater(field.get_blade_count(), 0)
			2:
				field.species[0].patch = null
				await ticks(2)
				assert_greater(field.get_blade_count(), 0)
			3:
				patch.length_max = 0.9  # again
				field.queue_free()
		if i % 3 == 0:
			await frames(3)


func test_a_patch_that_becomes_empty() -> void:
	var field := add_field({species = kind({patch = long_blades(0.5)})})
	await ticks(2)
	assert_greater(field.get_blade_count(), 0)
	var makings: int = field.get_counters().makings
	expect_error("No grass grows")
	field.species[0].patch.length_min = 0.0
	field.species[0].patch.length_max = 0.0
	await made(field, makings + 1)
	assert_eq(field.get_blade_count(), 0)
	field.species[0].patch.length_max = 0.5
	await ticks(2)
	assert_greater(field.get_blade_count(), 0)

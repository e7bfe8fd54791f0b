# SPDX-License-Identifier: MIT
## A field that changes while it stands: what is kept, and what is drawn until new blades are there.
extends "res://tests/field_case.gd"

const TILE := Vector2i(3, 3)


func long_blades(length: float) -> GrassPatch:
	var patch := GrassPatch.new()
	patch.length_max = length
	return patch


func test_other_blades_come_when_they_are_there() -> void:
	var field := add_field()
	await ticks(2)
	var before := field.get_statistics()
	var old := tile_knots(field, TILE)
	for i in 5: # the last one counts
		field.patch = long_blades(0.5 + 0.1 * i)
		field.patch.length_min = 0.4
	assert_eq(tile_knots(field, TILE), old, "the old grass stands")
	assert_eq(field.get_statistics().makings, before.makings, "nobody waits")
	await made(field, before.makings + 1)
	var fresh := add_field({patch = field.patch})
	await ticks(2)
	assert_eq(tile_knots(field, TILE), tile_knots(fresh, TILE))
	assert_ne(tile_knots(field, TILE), old)
	await frames(20)
	var after := field.get_statistics()
	assert_eq(after.makings, before.makings + 1, "once for ten changes")
	assert_eq(after.builds, before.builds, "in the same buffers")


func test_no_other_change_waits() -> void:
	var field := add_field()
	await ticks(2)
	var before := field.get_statistics()
	field.patch = long_blades(0.6)
	field.size = Vector2(6, 6)
	await ticks(2)
	assert_eq(field.get_statistics().makings, before.makings + 1)
	var fresh := add_field({patch = field.patch, size = field.size})
	await ticks(2)
	assert_eq(tile_knots(field, TILE), tile_knots(fresh, TILE))
	await frames(20)
	assert_eq(field.get_statistics().makings, before.makings + 1, "it was all made by then")


func test_what_keeps_the_buffers() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), Vector3(0.25, 0.25, 0.25))
	await seen()
	assert_greater(field.get_awake_tile_count(), 0)
	var builds: int = field.get_statistics().builds
	for change: Dictionary in [{seed = 7}, {clump_lean = 0.4}, {clump_size = 2.0}, {density = 300.0}, {size = Vector2(9, 9)}]:
		var property: String = change.keys()[0]
		field.set(property, change[property])
		await seen()
		assert_eq(field.get_statistics().builds, builds, property)
		assert_greater(field.get_awake_tile_count(), 0, property)
		var fresh := add_field({seed = field.seed, clump_lean = field.clump_lean, clump_size = field.clump_size, density = field.density,
				size = field.size, simulated = false})
		await ticks(2)
		assert_eq(tile_knots(field, Vector2i(0, 0)), tile_knots(fresh, Vector2i(0, 0)), property)
		fresh.free()
	body.free()


func test_freed_and_taken_out_meanwhile() -> void:
	for i in 12:
		var field := add_field()
		await ticks(2)
		var patch := long_blades(0.5 + 0.01 * i)
		field.patch = patch
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
				field.patch = null
				await ticks(2)
				assert_greater(field.get_blade_count(), 0)
			3:
				patch.length_max = 0.9 # again
				field.queue_free()
		if i % 3 == 0:
			await frames(3)


func test_a_patch_that_becomes_empty() -> void:
	var field := add_field({patch = long_blades(0.5)})
	await ticks(2)
	assert_greater(field.get_blade_count(), 0)
	var makings: int = field.get_statistics().makings
	expect_error("No grass grows")
	field.patch.length_min = 0.0
	field.patch.length_max = 0.0
	await made(field, makings + 1)
	assert_eq(field.get_blade_count(), 0)
	field.patch.length_max = 0.5
	await ticks(2)
	assert_greater(field.get_blade_count(), 0)

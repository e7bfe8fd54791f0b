# SPDX-License-Identifier: MIT
## Slots for awake tiles: a field has as many as its tiles need, and all fields together as many as the project allows.
extends "res://tests/field_case.gd"

const SETTING := "grass_field/limits/pool_tiles"
const QUICK := {sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.2, settle_time = 0.1}
const TRIMMED := 60 * 4  # ticks after which slots that nobody needs are gone


func after() -> void:
	ProjectSettings.set_setting(SETTING, ProjectSettings.property_get_revert(SETTING))


func slots_of(field: GrassField) -> int:
	return field.get_counters().pool_slots


func awake_of(fields: Array[GrassField]) -> int:
	return fields.reduce(func(sum: int, field: GrassField) -> int: return sum + field.get_awake_tile_count(), 0)


## Balls on so many tiles of a field, which move a little in every tick.
func add_balls(field: GrassField, count: int) -> Array[AnimatableBody3D]:
	var balls: Array[AnimatableBody3D] = []
	for i in count:
		balls.append(add_held_body(ball(0.1), field.position + Vector3(-7.25 + 0.5 * (2 * i % 28), 0.1, -7.25 + 1.0 * (2 * i / 28))))
	return balls


func shake(balls: Array[AnimatableBody3D], count: int) -> void:
	for i in count:
		for body in balls:
			body.position.y = 0.1 + 0.02 * (i % 2)
		await ticks(1)


func test_the_limit_of_all_fields_is_a_project_setting() -> void:
	assert_eq(ProjectSettings.get_setting(SETTING), 4096)


func test_slots_come_with_tiles_that_wake_and_go_after_them() -> void:
	var field := add_field({size = Vector2(16, 16)}.merged(QUICK))
	await ticks(5)
	assert_eq(slots_of(field), 0, "at rest")
	assert_eq(field.get_counters().pool_bytes, 0)
	var at_rest := field.get_memory_usage()
	var body := add_held_body(ball(0.2), Vector3(0.25, 0.2, 0.25))
	await seen()
	assert_eq(slots_of(field), 16, "a ball")
	assert_greater(field.get_counters().pool_bytes, 0)
	var balls := add_balls(field, 100)
	await shake(balls, 5)
	assert_greater(field.get_awake_tile_count(), 99)
	assert_true(slots_of(field) in [128, 256, 512], "a crowd: %d" % slots_of(field))
	assert_less(slots_of(field), 2 * field.get_awake_tile_count())
	assert_eq(field.get_counters().evicted, 0)
	body.free()
	for other in balls:
		other.free()
	await ticks(60)
	assert_eq(field.get_awake_tile_count(), 0)
	assert_greater(slots_of(field), 0, "for a while")
	await ticks(TRIMMED)
	assert_eq(slots_of(field), 0)
	assert_less(field.get_memory_usage(), at_rest + 200000, "bytes: lists of bodies stay")


## Returns the knots of a tile in each tick in which a ball rolls over it.
func roll(field: GrassField) -> Array[PackedVector3Array]:
	var place := Vector3(5.25, 0.2, 5.25)
	var body := add_held_body(ball(0.2), place)
	var knots: Array[PackedVector3Array] = []
	for i in 30:
		body.position.x += 0.02
		await ticks(1)
		knots.append(tile_knots(field, field.get_tile_at(place)))
	body.free()
	return knots


func test_blades_bend_alike_whatever_slots_exist() -> void:
	var field := add_field({size = Vector2(16, 16)}.merged(QUICK))
	await ticks(5)
	var few := await roll(field)
	assert_less(slots_of(field), 64)
	assert_greater(farthest(few[0], few[-1]), 0.01, "they have moved")
	var crowd := add_balls(field, 60)
	await shake(crowd, 5)
	for body in crowd:
		body.free()
	await ticks(60)
	assert_eq(field.get_awake_tile_count(), 0)
	var many := await roll(field)
	assert_greater(slots_of(field), 64)
	assert_eq(many, few)


func test_all_fields_share_what_the_project_allows() -> void:
	ProjectSettings.set_setting(SETTING, 60)
	var fields: Array[GrassField] = []
	for i in 2:
		fields.append(add_field({size = Vector2(16, 16), position = Vector3(40 * i, 0, 0)}.merged(QUICK)))
	await ticks(2)
	var first := add_balls(fields[0], 50)
	await shake(first, 3)
	assert_eq(awake_of(fields), 60, "one field may have all of them")
	var second := add_balls(fields[1], 50)
	for i in 40:
		await shake(first + second, 1)
		assert_less(awake_of(fields), 61, "tick %d" % i)
	assert_near(fields[0].get_awake_tile_count(), 30, 3, "both want more than half")
	assert_near(fields[1].get_awake_tile_count(), 30, 3)
	var answer := fields[1].explain(fields[1].position + Vector3(7, 0, 7))
	assert_true(answer.still)
	assert_true(SETTING in answer.text, answer.text)
	for body in first:
		body.free()
	await shake(second, 60)
	assert_eq(fields[1].get_awake_tile_count(), 60, "the other one is at rest")


func test_a_level_of_quality_scales_what_fields_share() -> void:
	ProjectSettings.set_setting(SETTING, 40)
	var field := add_field({size = Vector2(16, 16)}.merged(QUICK))
	var balls := add_balls(field, 60)
	await shake(balls, 10)
	assert_eq(field.get_awake_tile_count(), 40)
	GrassQuality.set_level(GrassQuality.LEVEL_LOW)
	await shake(balls, 3)
	assert_eq(field.get_awake_tile_count(), 10)
	GrassQuality.reset_level()
	await shake(balls, 30)
	assert_eq(field.get_awake_tile_count(), 40)


func test_a_thousand_lawns_come_and_go() -> void:
	var left: Array[int] = []
	for round in 3:
		var before := OS.get_static_memory_usage()
		var lawns := Node3D.new()
		add_child(lawns)
		for i in 1000:
			var lawn := GrassField.new()
			lawn.size = Vector2(4, 4)
			lawn.position = Vector3(6 * (i % 40), 0, 6 * (i / 40))
			lawns.add_child(lawn)
		await ticks(5)
		var taken := 0
		for lawn: GrassField in lawns.get_children():
			taken += slots_of(lawn)
		assert_eq(taken, 0, "slots of lawns at rest")
		print("    a thousand lawns: %.1f MB" % ((OS.get_static_memory_usage() - before) * 1e-6))
		lawns.free()
		await ticks(5)
		left.append(OS.get_static_memory_usage())
	assert_less(left[2] - left[1], 500000, "bytes left by the last round: %s" % [left])

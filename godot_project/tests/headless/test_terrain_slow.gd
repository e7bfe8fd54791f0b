# SPDX-License-Identifier: MIT
## A terrain with slow methods, such as one that makes its ground at the first call: a frame waits for only a few calls.
extends "res://tests/field_case.gd"

const MOST := 2  # places a frame: one that is read in any case, and one that a field is owed


class Slow:
	extends Node3D

	var calls := {}  # of each frame

	func get_height(_at: Vector3) -> float:
		OS.delay_msec(20)
		var frame := Engine.get_process_frames()
		calls[frame] = calls.get(frame, 0) + 1
		return 0.5


func test_a_frame_waits_for_few_calls_and_the_ground_comes_all_the_same() -> void:
	var terrain := Slow.new()
	terrain.name = "Terrain"
	add_child(terrain)
	var field := add_field({size = Vector2(4, 4), map = full_map(), terrain = NodePath("../Terrain")})
	var is_read := func() -> bool: return field.get_counters().terrain_queries > 0 and field.get_counters().terrain_waiting == 0
	await wait_until(is_read, "the terrain is read")
	assert_eq(terrain.calls.values().reduce(func(sum: int, n: int) -> int: return sum + n), field.get_counters().terrain_queries)
	assert_less(terrain.calls.values().max(), MOST + 1, "calls in a frame")
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2.ZERO), 0.5, 1e-3)

# SPDX-License-Identifier: MIT
## Physics interpolation: its cost on both backends, and motion vectors between two ticks.
extends "res://tests/between_case.gd"

const MOTION_VECTORS := true  # see runner.gd
const Vectors := preload("res://tests/gpu/test_motion.gd").Vectors


func test_it_costs_memory_only_where_it_is_on() -> void:
	var field := await roll(false)
	await drawn()
	var off: int = field.get_statistics().memory
	var slots: int = field.get_counters().pool_slots
	assert_greater(slots, 0)
	get_tree().physics_interpolation = true
	await ticks(3)
	await drawn()
	var on: int = field.get_statistics().memory
	assert_true(on - off >= 2 * 8192 * slots, "two more textures: %d bytes" % (on - off))
	assert_true(on - off <= 2 * 8192 * slots + 131072 + 65536, "no more: %d bytes" % (on - off))
	field.physics_interpolation_mode = Node.PHYSICS_INTERPOLATION_MODE_OFF
	await ticks(3)
	await drawn()
	assert_true(absi(field.get_statistics().memory - off) <= 65536, "off for this node: %d bytes" % (field.get_statistics().memory - off))


## Both backends mix alike: the same ticks, the same share, the same picture but for the rounding of halves.
func test_backends_show_the_same() -> void:
	var field := await roll(true)
	var seen := await watch(3)
	move_body()
	await ticks(1)
	Engine.physics_ticks_per_second = 1
	await frames(3)
	assert_greater(seen.size(), 0)
	assert_greater(field.get_counters().mixes, 0)
	field.backend = GrassField.BACKEND_CPU
	await fields_shown()
	Engine.physics_ticks_per_second = TICKS_A_SECOND
	var before: int = field.get_counters().mixes
	body.position.x = -1.5
	await ticks(2)
	var counts := count_moving(await watch(7))
	print("    CPU: %d of %d frames within a tick show other blades" % [counts.x, counts.y])
	assert_greater(counts.x, 0.9 * counts.y)
	assert_greater(field.get_counters().mixes, before)


## In each frame between two ticks vectors are as long as the share that the frame moved on by.
func test_motion_vectors_follow_the_mix() -> void:
	var field := await roll(true)
	var vectors := Vectors.new()
	camera.compositor = Compositor.new()
	camera.compositor.compositor_effects = [vectors]
	await drawn()
	var seen := await watch(9, func() -> float: return mean_length(vectors.data))  # in pixels
	var speeds := []  # of frames within a tick: mean length a share
	for i in range(2, seen.size()):
		if seen[i][1] == seen[i - 1][1] and seen[i][1] == seen[i - 2][1] and seen[i][2] - seen[i - 1][2] > 0.005:
			speeds.append([seen[i][1], seen[i][0] / (seen[i][2] - seen[i - 1][2])])
	var pairs := 0
	var alike := 0
	for i in range(1, speeds.size()):
		if speeds[i][0] == speeds[i - 1][0] and speeds[i][1] > 0.0:
			pairs += 1
			alike += int(absf(speeds[i][1] / speeds[i - 1][1] - 1.0) < 0.35)
	print("    %d of %d pairs of frames within a tick move as their shares say; %d mixes" % [alike, pairs, field.get_counters().mixes])
	assert_greater(pairs, 5)
	assert_greater(alike, 0.8 * pairs)


## Of vectors in shares of a pixel.
func mean_length(data: PackedFloat32Array) -> float:
	var sum := 0.0
	for i in range(0, data.size(), 2):
		sum += Vector2(data[i], data[i + 1]).length()
	return 2.0 * sum / maxi(data.size(), 1)

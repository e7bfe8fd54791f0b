# SPDX-License-Identifier: MIT
## Tiles sleep once their blades are calm, without a visible change.
extends "res://tests/field_case.gd"

const TILE := Vector2i(4, 4)
const PLACE := Vector3(0.25, 0.25, 0.25)  # above its middle
const UNSEEN := 1e-3  # metres
const HAND_OVER := 10  # ticks: settling is shorter


func test_by_energy_unless_told() -> void:
	var field := add_field()
	assert_eq(field.sleep_mode, GrassField.SLEEP_ENERGY)
	field.sleep_mode = GrassField.SLEEP_TIMER
	assert_eq(field.sleep_mode, GrassField.SLEEP_TIMER)
	expect_error("`sleep_mode` must be SLEEP_TIMER or SLEEP_ENERGY")
	field.set("sleep_mode", 7)
	assert_eq(field.sleep_mode, GrassField.SLEEP_TIMER)


func test_nothing_moves_when_a_tile_goes_to_sleep() -> void:
	for method: GrassField.SolverMethod in [GrassField.METHOD_PBD, GrassField.METHOD_DIRECT]:
		var field := add_field({method = method})
		await ticks(2)
		var rest := tile_knots(field, TILE)
		var body := add_held_body(ball(0.2), PLACE)
		await ticks(30)
		assert_greater(farthest(tile_knots(field, TILE), rest), 0.05, "bent")
		body.free()
		var poses: Array[PackedVector3Array] = []
		var limit := 600
		while field.is_tile_awake(TILE) and limit > 0:
			poses.append(tile_knots(field, TILE))
			await ticks(1)
			limit -= 1
		poses.append(tile_knots(field, TILE))
		assert_false(field.is_tile_awake(TILE), "asleep")
		if not assert_greater(poses.size(), HAND_OVER + 30, "half a second of calm at least"):
			return
		var way := farthest(poses[-1 - HAND_OVER], rest)
		var step := 0.0
		for i in HAND_OVER:
			step = maxf(step, farthest(poses[-1 - i], poses[-2 - i]))
		print(
			(
				"    method %d: asleep after %d ticks; the last %d of them moved blades by %.3f mm, one by %.3f mm"
				% [method, poses.size(), HAND_OVER, 1e3 * way, 1e3 * step]
			)
		)
		assert_less(way, UNSEEN)
		assert_less(step, UNSEEN)
		field.free()


func test_awake_as_long_as_a_body_is_there() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), PLACE)
	await seen()
	var touched := field.get_awake_tile_count()
	await ticks(700)
	assert_eq(field.get_awake_tile_count(), touched, "its blades stay pressed")
	assert_eq(field.get_counters().woken, touched)
	body.free()
	assert_less(await ticks_to_sleep(field), 300)


## Both fields see the same body; tiles that it only comes near need not wait for a timer.
func test_simulates_less_than_the_timer() -> void:
	var fields: Array[GrassField] = [add_field({sleep_mode = GrassField.SLEEP_TIMER}), add_field({sleep_mode = GrassField.SLEEP_ENERGY})]
	var body := add_held_body(ball(0.2), Vector3(-3, 0.2, 0.2))
	for i in 120:
		body.position.x += 0.05
		await ticks(1)
	var steps: Array[int] = []
	for field in fields:
		await ticks_to_sleep(field)
		var now := field.get_counters()
		assert_eq(now.simulated_blades, now.tile_steps * BLADES)
		steps.append(now.tile_steps)
	print("    a ball through %d tiles: %d tile steps by timer, %d by energy" % [fields[0].get_counters().woken, steps[0], steps[1]])
	assert_eq(fields[0].get_counters().woken, fields[1].get_counters().woken)
	assert_less(steps[1], 0.9 * steps[0])


func test_a_finer_motion_stays_awake_longer() -> void:
	var counts: Array[int] = []
	for motion: float in [10.0, 1.0, 0.05]:
		var field := add_field({sleep_motion = motion})
		await ticks(2)
		await bend_with_ball(field)
		counts.append(await ticks_to_sleep(field))
		field.free()
	assert_less(counts[0], counts[1], "ticks %s" % [counts])
	assert_less(counts[1], counts[2], "ticks %s" % [counts])


## Blades so soft that they nod for a minute do not hold their slots for so long.
func test_what_never_calms_down_is_put_to_rest() -> void:
	var field := add_field({species = kind({natural_frequency = 0.3, damping_ratio = 0.0})})
	await ticks(2)
	await bend_with_ball(field)
	await ticks(590)
	assert_greater(field.get_awake_tile_count(), 0, "shortly before ten seconds")
	assert_near(await ticks_to_sleep(field), 60 * field.settle_time + 10, 10, "ticks from then on")

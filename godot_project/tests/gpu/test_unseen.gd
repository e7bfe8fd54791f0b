# SPDX-License-Identifier: MIT
## What no camera sees is not computed, and is right again when a camera sees it.
extends "res://tests/view_case.gd"

const AHEAD := Vector3(0.25, 0.2, -3.75)
const BEHIND := Vector3(0.25, 0.2, 30.25)
const EYE := Vector3(0.25, 1.5, 3)


func add_seen_body(place: Vector3) -> AnimatableBody3D:
	var body := add_held_body(ball(0.3), place)
	remove_child(body)
	viewport.add_child(body)
	return body


func look_ahead() -> void:
	look(EYE, AHEAD)


func look_back() -> void:
	look(EYE, BEHIND)


func test_a_field_out_of_view_does_nothing() -> void:
	var field := add_seen_field({wind_speed = 3.0})
	var body := add_seen_body(Vector3(0.25, 0.2, 0.25))
	await ticks(10)
	assert_greater(field.get_awake_tile_count(), 0)
	look(Vector3(0, 1, 12), Vector3(0, 1, 30))
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, 0)
	var before := field.get_counters()
	for i in 20:
		body.position.x += 0.05
		camera.position.z += 0.1
		await ticks(1)
	var after := field.get_counters()
	for key: String in [
		"steps",
		"simulated_blades",
		"uploaded_bytes",
		"culls",
		"body_reads",
		"shape_reads",
		"tiles_looked_at",
		"woken",
		"wind_updates",
		"tile_steps"
	]:
		assert_eq(after[key], before[key], key)
	assert_greater(after.unseen_ticks, before.unseen_ticks + 15)


## In view of a still camera, without wind and with nothing awake, nothing is done again in any frame.
func test_a_field_at_rest_in_view_of_a_still_camera_does_nothing() -> void:
	var field := add_seen_field({wind_speed = 0.0})
	look(Vector3(0, 1, 12), Vector3.ZERO)
	await ticks(10)
	await drawn()
	await drawn()
	var before := field.get_statistics().merged(field.get_counters())
	assert_greater(before.drawn_tiles, 0)
	assert_greater(before.culls, 0)
	for i in 20:
		await drawn()
	var after := field.get_counters()
	for key: String in [
		"culls", "steps", "uploaded_bytes", "wind_updates", "instance_updates", "tiles_looked_at", "body_reads", "knots_read"
	]:
		assert_eq(after[key], before[key], key)
	camera.position.z -= 0.5
	await drawn()
	assert_greater(field.get_counters().culls, before.culls, "another view")


func test_a_field_seen_again_is_as_if_it_had_been_seen() -> void:
	var field := add_seen_field({wind_speed = 3.0})
	var body := add_seen_body(Vector3(-1.25, 0.2, 0.25))
	await ticks(10)
	var left := field.get_tile_at(body.position)
	look(Vector3(0, 1, 12), Vector3(0, 1, 30))
	await ticks(200)
	assert_true(field.is_tile_awake(left), "nothing was done")
	body.position.x = 1.25
	await ticks(2)
	var before := field.get_counters()
	look(Vector3(0, 1, 12), Vector3.ZERO)
	await drawn()
	await ticks(5)
	var after := field.get_statistics().merged(field.get_counters())
	assert_false(field.is_tile_awake(left), "at rest by now")
	assert_eq(after.evicted, before.evicted)
	assert_true(field.is_tile_awake(field.get_tile_at(body.position)))
	assert_false(field.is_tile_awake(field.get_tile_at(Vector3(-0.3, 0, 0.25))), "its way was not swept")
	assert_greater(after.drawn_tiles, 0)
	assert_greater(after.wind_updates, before.wind_updates)
	assert_less(after.unseen_ticks - before.unseen_ticks, 3)


func test_a_hidden_field_does_nothing() -> void:
	var field := add_seen_field()
	add_seen_body(Vector3(0.25, 0.2, 0.25))
	await ticks(10)
	field.hide()
	await drawn()
	var before := field.get_counters()
	await ticks(10)
	assert_eq(field.get_counters().steps, before.steps)
	assert_eq(field.get_counters().body_reads, before.body_reads)
	field.show()
	await drawn()
	await ticks(5)
	assert_greater(field.get_counters().steps, before.steps)


func test_a_calm_tile_out_of_view_is_not_simulated_and_goes_on_when_seen() -> void:
	# By the timer: by energy still tiles are not simulated in view, either.
	# Whole: to read knots makes blades join that no camera needs, and those settle for a second.
	var whole := {size = Vector2(20, 80), sleep_mode = GrassField.SLEEP_TIMER, simulation_detail = GrassField.SIMULATION_WHOLE}
	var field := add_seen_field(whole)
	var bodies: Array[AnimatableBody3D] = [add_seen_body(AHEAD), add_seen_body(BEHIND)]
	look_back()
	await ticks(150)
	var usual := 0.0  # what blades under a body that lies still do while they are seen, metres in ten ticks
	for i in 5:
		var pressed := knots_of(field, [field.get_tile_at(BEHIND)])
		await ticks(10)
		usual = maxf(usual, farthest_of(field, pressed))
	look_ahead()
	await ticks(60)
	var behind := field.get_tile_at(BEHIND)
	var unseen := awake_tiles(field).filter(func(p_tile: Vector2i) -> bool: return p_tile.y > field.get_grid_size().y / 2)
	assert_true(behind in unseen)
	var seen := field.get_awake_tile_count() - unseen.size()
	assert_greater(seen, 0)
	var before := field.get_counters()
	var knots := knots_of(field, [behind])
	await ticks(40)
	var after := field.get_counters()
	var passed: int = after.steps - before.steps  # the one ahead is simulated in every tick
	assert_greater(passed, 20)
	assert_eq(after.tile_steps - before.tile_steps, passed * seen)
	assert_eq(farthest_of(field, knots), 0.0, "m: stands still")
	look_back()
	await ticks(10)
	assert_less(farthest_of(field, knots), usual + 1e-3, "m: seen again nothing jumps")
	await drawn()
	before = field.get_counters()
	await ticks(10)
	after = field.get_counters()
	assert_less(after.tile_steps - before.tile_steps, 10 * field.get_awake_tile_count(), "now it is the other one")
	bodies[1].position.x += 0.1
	await ticks(5)
	assert_greater(farthest_of(field, knots), 0.01, "m: moves")
	look_ahead()
	await drawn()
	bodies[1].position.x += 0.1
	knots = knots_of(field, [behind])
	await ticks(3)
	assert_greater(farthest_of(field, knots), 1e-3, "m: a body that moves is followed out of view, too")
	bodies[1].position.y = 20.0
	await ticks(200)
	assert_false(field.is_tile_awake(behind), "left alone it sleeps")


func test_no_wind_no_wind_code() -> void:
	var field := add_seen_field()
	await drawn()
	assert_eq(field.get_counters().wind_updates, 0)
	field.wind_speed = 2.0
	await drawn()
	var updates: int = field.get_counters().wind_updates
	assert_greater(updates, 0)
	field.wind_speed = 0.0
	await drawn()
	updates = field.get_counters().wind_updates
	await drawn()
	assert_eq(field.get_counters().wind_updates, updates)


func test_who_listens_is_told_though_nobody_sees() -> void:
	var field := add_seen_field()
	var body := add_seen_body(Vector3(0.25, 20.0, 0.25))
	look(Vector3(0, 1, 12), Vector3(0, 1, 30))
	await drawn()
	var told: Array[String] = []
	field.body_entered_grass.connect(func(p_body: Node3D) -> void: told.append("in " + p_body.get_class()))
	field.body_exited_grass.connect(func(p_body: Node3D) -> void: told.append("out " + p_body.get_class()))
	body.position.y = 0.2
	await ticks(10)
	body.position.y = 20.0
	await ticks(10)
	assert_eq(told, ["in AnimatableBody3D", "out AnimatableBody3D"] as Array[String])
	assert_eq(field.get_statistics().drawn_tiles, 0)


func test_who_listens_for_leaving_alone_is_told_though_nobody_sees() -> void:
	var field := add_seen_field()
	var body := add_seen_body(Vector3(0.25, 20.0, 0.25))
	look(Vector3(0, 1, 12), Vector3(0, 1, 30))
	await drawn()
	var left := []
	field.body_exited_grass.connect(left.append)
	body.position.y = 0.2
	await ticks(10)
	body.position.y = 20.0
	await ticks(10)
	assert_eq(left, [body])


func test_the_renderer_is_told_of_changes_only() -> void:
	var field := add_seen_field({wind_speed = 3.0})
	look(Vector3(0, 1, 4), Vector3.ZERO)
	await frames(5)
	var at_first: int = field.get_counters().instance_updates
	assert_greater(at_first, 0)
	for i in 20:  # frames are drawn, wind blows, the camera moves: the node stands
		camera.position.x += 0.05
		await frames(1)
	assert_eq(field.get_counters().instance_updates, at_first)
	# Picture, shadows, ground; here nothing casts shadows, so those are hidden all the time.
	var changes: Array[Callable] = [
		func() -> int:
			field.position.x += 0.5
			return 3,
		func() -> int:
			field.layers = 3
			return 3,
		func() -> int:
			field.visible = false
			return 2,
		func() -> int:
			field.visible = true
			return 2,
		func() -> int:
			field.transparency = 0.5
			return 3,
	]
	var expected := at_first
	for i in changes.size():
		expected += changes[i].call()
		await frames(3)
		assert_eq(field.get_counters().instance_updates, expected, "change %d" % i)
	field.transparency = 0.0
	field.position.x = 0.0
	await frames(3)
	assert_greater(share_of(await next_picture(), is_green), 0.05, "it is drawn")

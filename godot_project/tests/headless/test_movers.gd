# SPDX-License-Identifier: MIT
## Moving bodies leave no gap in the grass along their way, whatever moves them, at any speed and tick rate. Where a body is teleported, the
## grass in between is untouched.
extends "res://tests/field_case.gd"

const PLACES := 48  # along the way, 1 m apart
const HEIGHT := Vector3(0, 0.25, 0.25)
const MOVERS: Array[String] = ["rigid", "frozen", "slide", "character", "synced", "animatable", "static", "node"]
## Tick rate, speed in m/s.
const PACES: Array[Vector2] = [Vector2(10, 30), Vector2(10, 600), Vector2(60, 30), Vector2(60, 200), Vector2(60, 600), Vector2(240, 600)]
const JOLT_LIMIT := 500.0  # m/s: rigid bodies are no faster


func after() -> void:
	Engine.physics_ticks_per_second = ProjectSettings.get_setting("physics/common/physics_ticks_per_second")


func make(kind: String) -> Node3D:
	var body: PhysicsBody3D
	match kind:
		"node":
			return Node3D.new()
		"rigid", "frozen":
			body = RigidBody3D.new()
			body.gravity_scale = 0.0
			body.linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
			body.can_sleep = false
			body.freeze = kind == "frozen"
			body.freeze_mode = RigidBody3D.FREEZE_MODE_KINEMATIC
		"slide", "character":
			body = CharacterBody3D.new()
			body.motion_mode = CharacterBody3D.MOTION_MODE_FLOATING
		"synced", "animatable":
			body = AnimatableBody3D.new()
			body.sync_to_physics = kind == "synced"
		"static":
			body = StaticBody3D.new()
	add_shape(body, ball(0.3))
	return body


## Adds a mover of the kind in the tree at `place`, at rest.
func add_mover(kind: String, place: Vector3, field: GrassField) -> Node3D:
	var mover := make(kind)
	mover.position = place
	add_child(mover)
	if kind == "node":
		field.register_collider(mover, ball(0.3))
	return mover


## One tick of motion, and a teleport by `jump` before it: in one, for a synced body knows its new place only after the tick.
func push(mover: Node3D, kind: String, velocity: Vector3, jump := Vector3.ZERO) -> void:
	if kind == "rigid":
		mover.position += jump
		mover.linear_velocity = velocity
	elif kind == "slide":
		mover.position += jump
		mover.velocity = velocity
		mover.move_and_slide()
	else:
		mover.position += jump + velocity / Engine.physics_ticks_per_second
	await ticks(1)


## Returns the places along x, from `first` metres on, where grass has woken.
func woken(field: GrassField, first: float) -> int:
	var count := 0
	for i in PLACES:
		count += int(field.is_tile_awake(field.get_tile_at(Vector3(first + i, 0, HEIGHT.z))))
	return count


## Adds a field with one row of tiles to each side of the way, which stay awake.
func add_track() -> GrassField:
	return add_field({size = Vector2(PLACES + 2, 2), density = 64.0, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 60.0})


## Sends a mover through a field at `pace`, from `start` to beyond its end, and tells how many places woke.
func run_through(kind: String, pace: Vector2, start: float) -> int:
	Engine.physics_ticks_per_second = int(pace.x)
	var field := add_track()
	await ticks(1)
	var mover := add_mover(kind, HEIGHT + Vector3(start, 0, 0), field)
	await ticks(3)
	if kind == "rigid":
		pace.y = minf(pace.y, JOLT_LIMIT)
	var needed := ceili((0.5 * PLACES + 2.0 - start) / pace.y * pace.x) + 1
	for i in needed:
		await push(mover, kind, Vector3(pace.y, 0, 0))
	await push(mover, kind, Vector3.ZERO)
	await ticks(2)
	var count := woken(field, 0.5 - 0.5 * PLACES)
	mover.free()
	field.free()
	return count


func test_whoever_comes_from_outside_leaves_no_gap() -> void:
	for pace in PACES:
		for kind in MOVERS:
			# Never as far beyond the field's end as a whole number of ticks takes it.
			var start := -0.5 * PLACES - maxf(8.0, 2.3 * pace.y / pace.x)
			assert_eq(await run_through(kind, pace, start), PLACES, "%s, %s m/s, %s ticks/s" % [kind, pace.y, pace.x])


func test_whoever_starts_in_the_field_leaves_no_gap() -> void:
	for pace: Vector2 in [Vector2(60, 200), Vector2(60, 600)]:
		for kind in MOVERS:
			assert_eq(await run_through(kind, pace, 0.5 - 0.5 * PLACES), PLACES, "%s, %s m/s, %s ticks/s" % [kind, pace.y, pace.x])


## 60 m a tick, past 4 m of grass: nobody overlaps the grass itself at the end of any tick.
func test_nobody_flies_unseen_through_a_small_field() -> void:
	Engine.physics_ticks_per_second = 10
	for kind in MOVERS:
		for phase: float in [0.3, 0.7]:
			var field := add_field({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 60.0})
			var mover := add_mover(kind, HEIGHT + Vector3(-60.0 * (3.0 + phase), 0, 0), field)
			await ticks(3)
			for i in 8:
				await push(mover, kind, Vector3(600, 0, 0))
			for x: float in [-1.5, -0.5, 0.5, 1.5]:
				assert_true(field.is_tile_awake(field.get_tile_at(Vector3(x, 0, HEIGHT.z))), "%s, %s of a tick, at %s" % [kind, phase, x])
			mover.free()
			field.free()


func test_slow_bodies_leave_no_gap_either() -> void:
	for kind: String in ["slide", "static"]:
		assert_eq(await run_through(kind, Vector2(60, 5), -0.5 * PLACES - 2.0), PLACES, kind)


func test_teleports_leave_the_grass_between_alone() -> void:
	for kind in MOVERS:
		var field := add_track()
		var mover := add_mover(kind, HEIGHT + Vector3(-20, 0, 0), field)
		await ticks(3)
		var landings: Array[float] = []
		for jump: float in [0.0, 5.0, 20.0, -8.0, 13.0]:  # at 8 m/s, the last three in successive ticks
			await push(mover, kind, Vector3(8, 0, 0), Vector3(jump, 0, 0))
			landings.append(mover.position.x)
			for i in 5 if jump < 20.0 and jump >= 0.0 else 0:
				await push(mover, kind, Vector3(8, 0, 0))
		await push(mover, kind, Vector3.ZERO)
		await ticks(10)
		for x in landings:
			assert_true(field.is_tile_awake(field.get_tile_at(Vector3(x, 0, HEIGHT.z))), "%s at %s" % [kind, x])
		for x: float in [-17, -10, -9, -7, -5, 2, 3, 9]:
			assert_false(
				field.is_tile_awake(field.get_tile_at(Vector3(x, 0, HEIGHT.z))), "%s woke %s on its way to %s" % [kind, x, landings]
			)
		mover.free()
		field.free()


func test_a_dart_within_one_tick_is_a_teleport_unless_the_field_says_no() -> void:
	for kind: String in ["animatable", "static", "node"]:
		for limit: float in [120.0, 2000.0]:
			var field := add_track()
			field.teleport_speed = limit
			var mover := add_mover(kind, HEIGHT + Vector3(-10, 0, 0), field)
			await ticks(3)
			mover.position.x += 20.0
			await ticks(4)
			assert_eq(field.is_tile_awake(field.get_tile_at(Vector3(0, 0, HEIGHT.z))), limit > 1200.0, "%s, %s m/s" % [kind, limit])
			mover.free()
			field.free()


func test_fast_bodies_cost_no_more_calls_of_the_engine() -> void:
	var field := add_track()
	var mover := add_mover("animatable", HEIGHT + Vector3(-20, 0, 0), field)
	await ticks(3)
	var before := field.get_counters()
	for i in 10:
		await push(mover, "animatable", Vector3(200, 0, 0))
	var after_ := field.get_counters()
	assert_less(after_.engine_calls - before.engine_calls, 10 * 3 + 2 * 12 + 1, "three a tick, and two looks at its shapes at most")


func test_a_registered_node_that_turns_in_place_sweeps() -> void:
	var field := add_field()
	var rotor := add_mover("node", HEIGHT, field)
	var bar := box(Vector3(2.5, 0.3, 0.2))
	field.register_collider(rotor, bar)
	await ticks(4)
	var before: int = field.get_counters().woken
	rotor.rotation.y += 0.8
	await ticks(1)
	rotor.rotation.y -= 0.8
	await ticks(2)
	assert_greater(field.get_counters().woken, before)


## 60 m in a tick, aslant: the box around that way has more tiles than the pool.
func test_a_way_aslant_across_the_field() -> void:
	for kind: String in ["slide", "animatable", "static", "node"]:
		Engine.physics_ticks_per_second = 10
		var field := add_field({size = Vector2(50, 50), sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 60.0})
		await ticks(1)
		var aslant := Vector3(1, 0, 1).normalized()
		var mover := add_mover(kind, HEIGHT - 90.0 * aslant, field)
		await ticks(3)
		for i in 4:
			await push(mover, kind, 600.0 * aslant)
		await push(mover, kind, Vector3.ZERO)
		await ticks(2)
		var missed := 0
		for i in range(-30, 31):
			missed += int(not field.is_tile_awake(field.get_tile_at(HEIGHT + i * aslant)))
		assert_eq(missed, 0, kind)
		mover.free()
		field.free()

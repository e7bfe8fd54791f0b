# SPDX-License-Identifier: MIT
## Both methods on the GPU with random parameters, thrown bodies and odd time steps: the checks of tests/stress.
extends "res://tests/field_case.gd"

const STRETCH := 0.01  # of a segment
const AT_REST := 0.01  # of a blade's length
const TILES: Array[Vector2i] = [Vector2i(3, 3), Vector2i(4, 4), Vector2i(5, 4)]

var rng := RandomNumberGenerator.new()


func within(low: float, high: float) -> Vector3:
	return Vector3(rng.randf_range(low, high), rng.randf_range(low, high), rng.randf_range(low, high))


func randomise(field: GrassField) -> void:
	var species := field.species[0]
	species.natural_frequency = rng.randf_range(0.1, 10.0)
	species.damping_ratio = rng.randf_range(0.0, 3.0)
	species.root_stiffness = rng.randf_range(1.0, 4.0)
	species.bend_stiffness = rng.randf_range(0.0, 30.0)
	field.friction = rng.randf_range(0.0, 4.0)
	field.swing_speed_max = rng.randf_range(1.0, 100.0)
	field.iterations = rng.randi_range(1, 10)


func throw_bodies() -> Array[RigidBody3D]:
	var capsule := CapsuleShape3D.new()
	capsule.radius = 0.1
	capsule.height = 0.5
	var bodies: Array[RigidBody3D] = []
	for shape: Shape3D in [ball(0.2), box(Vector3(0.3, 0.2, 0.4)), capsule]:
		var body := RigidBody3D.new()
		body.gravity_scale = 0.0
		add_body(body, shape, Vector3(0, 0.3, 0) + within(-0.3, 0.3))
		body.linear_velocity = within(-20.0, 20.0)
		body.angular_velocity = within(-10.0, 10.0)
		bodies.append(body)
	return bodies


## Returns the worst segment of all blades of the tiles against `rest`; INF where a number is not finite.
func stretch(field: GrassField, rest: Dictionary[Vector2i, PackedVector3Array]) -> float:
	var worst := 0.0
	for tile in TILES:
		var knots := tile_knots(field, tile)
		for i in knots.size():
			if not knots[i].is_finite():
				return INF
			if i % KNOTS > 0:
				var length := rest[tile][i].distance_to(rest[tile][i - 1])
				worst = maxf(worst, absf(knots[i].distance_to(knots[i - 1]) / length - 1.0))
	return worst


func storm(method: GrassField.SolverMethod) -> void:
	rng.seed = 2026
	var field := add_field({method = method, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 60.0, species = kind({})})
	await ticks(3)
	if not assert_eq(field.get_statistics().backend, "GPU"):
		return
	await compiled(field)
	var rest := knots_of(field, TILES)
	var worst := 0.0
	var farthest_knot := 0.0
	for round in 5:
		randomise(field)
		var bodies := throw_bodies()
		Engine.physics_ticks_per_second = [60, 30, 144, 7, 240][round]
		for i in 6:
			await ticks(2)
			worst = maxf(worst, stretch(field, rest))
			farthest_knot = maxf(farthest_knot, farthest(tile_knots(field, TILES[1]), rest[TILES[1]]))
		for body in bodies:
			body.free()
	Engine.physics_ticks_per_second = 60
	assert_less(worst, STRETCH, "share of a segment")
	assert_greater(farthest_knot, 0.1, "metres: the bodies bent blades")
	field.species[0].natural_frequency = 1.2
	field.species[0].damping_ratio = 0.5
	field.iterations = 2
	await ticks(240)
	for tile in TILES:
		assert_true(field.is_tile_awake(tile), "simulated to the end")
		assert_less(farthest(tile_knots(field, tile), rest[tile]), AT_REST * 0.3, "metres from rest, seconds later")


func after() -> void:
	Engine.physics_ticks_per_second = 60


func test_direct() -> void:
	await storm(GrassField.METHOD_DIRECT)


func test_pbd() -> void:
	await storm(GrassField.METHOD_PBD)

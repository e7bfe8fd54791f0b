# SPDX-License-Identifier: MIT
## The picture of bodies in grass is the same whether all blades are simulated or those that the camera needs, while it comes nearer.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(192, 108)
const FROM := Vector3(0.4, 1.7, 12.0)
const TO := Vector3(0.4, 1.2, 3.0)
const PICTURES := 6
const TICKS := 10  # between two pictures
const FAR := 3  # pictures in which no drawn blade has joined the simulated ones yet
const SAME := 1e-4  # mean difference of these, of 1
const ALIKE := 0.02  # and of the others, in which some blades stand as their neighbours did


func before() -> void:
	open_view(SIZE)
	add_light()


func add_bodies() -> Array[AnimatableBody3D]:
	var bodies: Array[AnimatableBody3D] = []
	for i in 5:
		var body := add_held_body(ball(0.25), Vector3(-3.5 + 0.3 * i, 0.2, 1.2 * i - 2.4))
		remove_child(body)
		viewport.add_child(body)
		bodies.append(body)
	return bodies


## Returns pictures while bodies roll and the camera comes nearer.
func approach(detail: GrassField.SimulationDetail) -> Array[Image]:
	var field := add_seen_field(
		{size = Vector2(16, 16), simulation_detail = detail, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}
	)
	look(FROM, Vector3.ZERO)
	await drawn()
	await compiled(field)
	var bodies := add_bodies()
	var pictures: Array[Image] = []
	for i in PICTURES:
		for tick in TICKS:
			for body in bodies:
				body.position.x += 0.1
			await ticks(1)
		look(FROM.lerp(TO, (i + 1.0) / PICTURES), Vector3.ZERO)
		pictures.append(await picture())
	var counters := field.get_counters()
	var of_steps: int = counters.tile_steps * BLADES
	print("    %d of %d blade-steps, %d tiles widened" % [counters.simulated_blades, of_steps, counters.widened_tiles])
	if detail == GrassField.SIMULATION_SEEN:
		assert_less(counters.simulated_blades, 0.7 * of_steps)
		assert_greater(counters.widened_tiles, 50)
	else:
		assert_eq(counters.simulated_blades, of_steps)
	for node: Node in bodies + [field] as Array[Node]:
		node.free()
	return pictures


func test_a_camera_that_comes_nearer_sees_whole_grass() -> void:
	var whole := await approach(GrassField.SIMULATION_WHOLE)
	var seen_only := await approach(GrassField.SIMULATION_SEEN)
	var bare := 0.0
	for i in PICTURES:
		var off := difference(whole[i], seen_only[i]).y
		bare = maxf(bare, difference(whole[i], whole[0]).y) if i > 0 else 0.0
		print("    picture %d differs by %.5f" % [i, off])
		assert_less(off, SAME if i < FAR else ALIKE, "picture %d" % i)
	assert_greater(bare, 2 * ALIKE, "the pictures show something")

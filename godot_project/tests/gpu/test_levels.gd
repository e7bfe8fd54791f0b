# SPDX-License-Identifier: MIT
## Grass on walls and ceilings: both backends hang and press the same blades.
extends "res://tests/parity_case.gd"


func test_walls_and_ceilings_are_the_same_on_both_backends() -> void:
	for turn: Vector3 in [Vector3(90, 0, 0), Vector3(180, 20, 0)]:
		if not await add_pair({size = Vector2(2, 2), rotation_degrees = turn}):
			return
		var out := gpu.global_basis.y
		var body := add_held_body(ball(0.2), 0.25 * out + 0.1 * gpu.global_basis.x)
		await ticks(20)
		var awake := awake_tiles(cpu)
		assert_true(not awake.is_empty(), "the ball presses it, turned by %s" % turn)
		assert_less(share_apart(awake, 0.02), 0.02, "turned by %s" % turn)
		for node: Node in [body, gpu, cpu]:
			node.free()

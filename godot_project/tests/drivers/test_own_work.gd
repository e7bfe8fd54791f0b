# SPDX-License-Identifier: MIT
## The device reports NVIDIA as its vendor, so simulate keeps joints in arrays of its threads, not in a buffer
## (extension/gpu/obstacles.cpp). On other devices test_parity.gd runs with the buffer.
extends "res://tests/parity_case.gd"

const AFTER_CONTACT := 1e-3  # of a blade's length
const ROOM := 107520  # bytes that a tile has in that buffer


func before() -> void:
	assert_eq(RenderingServer.get_rendering_device().get_device_vendor_name(), "NVIDIA")


func test_bodies_bend_blades_as_on_the_cpu() -> void:
	var plate := box(Vector3(0.6, 0.02, 0.6))  # what it touches is for the pass with edges
	for method: GrassField.SolverMethod in [GrassField.METHOD_DIRECT, GrassField.METHOD_PBD]:
		if not await add_pair({method = method, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
			return
		var memory: int = gpu.get_memory_usage() - gpu.get_counters().pool_bytes
		var tiles: Array[Vector2i] = [gpu.get_tile_at(PLACE)]
		var rest := tile_knots(gpu, tiles[0])
		for shape: Shape3D in [ball(0.3), plate]:
			var body := add_held_body(shape, PLACE + Vector3(0.35, 0.15, 0.0))
			await seen()
			assert_greater(farthest(tile_knots(gpu, tiles[0]), rest), 0.05, "metres: it is bent")
			body.free()
			await ticks(100)  # which way a squashed blade unfolds may hang on its last bits
			var off := difference(tiles)
			print("    parity without a buffer, method %d: %s of a blade's length" % [method, String.num_scientific(off)])
			assert_less(off, AFTER_CONTACT)
		var now := gpu.get_counters()
		assert_greater(now.edge_tile_steps, 0)
		assert_greater(now.free_tile_steps, 0)
		assert_greater(now.simulated_blades / BLADES, now.edge_tile_steps + now.free_tile_steps, "and by the pass for all tiles")
		assert_less(gpu.get_memory_usage() - now.pool_bytes - memory, ROOM, "bytes: no buffer for the step")
		gpu.free()
		cpu.free()

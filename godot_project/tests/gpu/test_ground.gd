# SPDX-License-Identifier: MIT
## Bodies roll down a hillside through two fields in the same place, one on each backend.
extends "res://tests/hill_case.gd"


func test_both_backends_on_a_hillside() -> void:
	add_hill()
	await ticks(2)
	var properties := {size = Vector2(12, 10), pool_tiles = 512, sleep_mode = GrassField.SLEEP_TIMER}
	var gpu := add_field(properties)
	gpu.bake_ground()
	properties.map = gpu.map
	properties.backend = GrassField.BACKEND_CPU
	var cpu := add_field(properties)
	await ticks(3)
	assert_eq(gpu.get_statistics().backend, "GPU")
	assert_eq(cpu.get_statistics().backend, "CPU")
	var bodies := let_go()
	var bent := 0.0
	for i in 60:
		await ticks(1)
		if not assert_eq(awake_tiles(gpu), awake_tiles(cpu), "tick %d" % i):
			return
	for tile in awake_tiles(cpu):
		var by_gpu := tile_knots(gpu, tile)
		var by_cpu := tile_knots(cpu, tile)
		for blade in BLADES:
			var root := by_gpu[blade * KNOTS]
			assert_near(root.distance_to(by_cpu[blade * KNOTS]), 0.0, 1e-4, "roots")
			assert_near(root.y, hill_height(root.x, root.z), 0.05)
	for body in bodies:
		bent = maxf(bent, gpu.get_bend_at(body.position).length())
		assert_near(gpu.get_bend_at(body.position), cpu.get_bend_at(body.position), 0.1, "how far the grass bends")
	assert_greater(bent, 0.05)
	assert_true(all_finite(gpu, awake_tiles(gpu)))

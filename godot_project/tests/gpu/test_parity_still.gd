# SPDX-License-Identifier: MIT
## Bodies at rest in the grass: the GPU against the CPU.
extends "res://tests/parity_case.gd"

const SINKING := 0.02  # metres a tick
const LAID := 1e-4  # of a blade's length


## A slab that lies on the grass: what it holds sticks, to the bit, on both.
func test_held_blades_stand_still_on_both() -> void:
	if not await add_pair():
		return
	cpu.sleep_mode = GrassField.SLEEP_TIMER  # which leaves no tile as it is
	gpu.sleep_mode = GrassField.SLEEP_TIMER
	var slab := box(Vector3(0.8, 0.1, 0.8))
	var body := add_held_body(slab, PLACE + Vector3(0, 0.5, 0))
	for i in 30:
		body.position.y = maxf(body.position.y - SINKING, 0.2)
		await ticks(1)
	await ticks(90)
	var tile := gpu.get_tile_at(PLACE)
	var poses: Array[PackedVector3Array] = [tile_knots(cpu, tile), tile_knots(gpu, tile)]
	await ticks(1)
	var still_now: Array[int] = []
	var bends: Array[float] = []
	for i in 2:
		var now := tile_knots([cpu, gpu][i], tile)
		var still := 0
		var sum := 0.0
		for blade in BLADES:
			still += 1 if now.slice(KNOTS * blade, KNOTS * (blade + 1)) == poses[i].slice(KNOTS * blade, KNOTS * (blade + 1)) else 0
		for k in now.size():
			sum += now[k].y
		still_now.append(still)
		bends.append(1e3 * sum / now.size())
	print(
		(
			"    under a slab stand still: CPU %d, GPU %d of %d blades; knots %.3f and %.3f mm high"
			% [still_now[0], still_now[1], BLADES, bends[0], bends[1]]
		)
	)
	assert_greater(still_now[0], BLADES / 2)
	assert_near(still_now[1], still_now[0], 3)
	assert_near(bends[1], bends[0], 0.02 * bends[0], "mm")


## A boulder that appears on a tile, all of whose roots it covers.
func test_boulders_lay_blades_alike() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
		return
	var tile := gpu.get_tile_at(PLACE)
	for method: GrassField.SolverMethod in [GrassField.METHOD_DIRECT, GrassField.METHOD_PBD]:
		for field: GrassField in [gpu, cpu]:
			field.method = method
		for field: GrassField in [gpu, cpu]:
			await grown(field)
		await compiled(gpu)  # for another method the field is made anew
		var body := add_held_body(ball(0.4), PLACE - Vector3(0, 0.15, 0))
		await ticks(60)
		var poses: Array[PackedVector3Array] = [tile_knots(cpu, tile), tile_knots(gpu, tile)]
		await ticks(5)
		assert_less(farthest(tile_knots(cpu, tile), poses[0]), 1e-5, "metres, on the CPU")
		assert_less(farthest(tile_knots(gpu, tile), poses[1]), 1e-5, "metres, on the GPU")
		assert_less(height_of(gpu, tile), 20.0, "mm: they lie")
		var off := difference([tile])
		print("    parity below a boulder: %s of a blade's length" % String.num_scientific(off))
		assert_less(off, LAID)
		body.free()
		await ticks(240)


## A plank that appears around blades has none in it.
func test_a_plank_that_appears_pierces_no_blade() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
		return
	var plank := box(Vector3(1.0, 0.045, 0.8))
	var body := add_held_body(plank, Vector3(PLACE.x, 0.12, PLACE.z))
	await ticks(60)
	var tile := gpu.get_tile_at(PLACE)
	for field: GrassField in [gpu, cpu]:
		var inside := 0
		for knot in tile_knots(field, tile):
			var from := (knot - body.global_position).abs()
			inside += int(from.x < 0.499 and from.y < 0.0215 and from.z < 0.399)
		assert_eq(inside, 0, "knots")


## Tiles below what stands still are left as they are, on both, and taken up again when it moves.
func test_left_alone_under_what_stands_still() -> void:
	if not await add_pair():
		return
	var body := add_held_body(ball(0.3), PLACE + Vector3(0, 0.25, 0))
	await ticks(150)
	for field: GrassField in [cpu, gpu]:
		assert_eq(field.get_counters().still_tiles, field.get_awake_tile_count())
	assert_greater(gpu.get_awake_tile_count(), 0)
	var tile := gpu.get_tile_at(PLACE)
	var steps: int = gpu.get_counters().steps
	var height := height_of(gpu, tile)
	await ticks(30)
	assert_eq(gpu.get_counters().steps, steps, "no dispatch")
	assert_eq(height_of(gpu, tile), height)
	assert_near(height_of(cpu, tile), height, 0.02 * height, "mm")
	body.free()
	await ticks(90)
	assert_greater(height_of(gpu, tile), height + 5.0, "mm")
	assert_near(height_of(gpu, tile), height_of(cpu, tile), 0.02 * height, "mm")


## Of a tile's knots on average, mm.
func height_of(field: GrassField, tile: Vector2i) -> float:
	var sum := 0.0
	var knots := tile_knots(field, tile)
	for knot in knots:
		sum += knot.y
	return 1e3 * sum / knots.size()

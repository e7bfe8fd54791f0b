# SPDX-License-Identifier: MIT
## The GPU's simulation against the CPU's, at rest, over many steps and until tiles sleep.
extends "res://tests/parity_case.gd"

const FEW := 0.01  # share of the blades, see share_apart()
const IN_CONTACT := 2e-3  # of a blade's length, when a body comes to rest on it
const MANY_STEPS := 1e-3  # of a blade's length, after 600 steps without


func test_rest_is_the_same() -> void:
	if not await add_pair({seed = 3}):
		return
	for tile: Vector2i in [Vector2i(1, 1), Vector2i(6, 5)]:
		await assert_same_rest(tile)


func test_knots_of_a_tile_are_those_of_its_blades() -> void:
	if not await add_pair():
		return
	add_held_body(ball(0.2), PLACE)
	await ticks(10)
	var tile := gpu.get_tile_at(PLACE)
	var knots := tile_knots(gpu, tile)
	assert_eq(knots.size(), BLADES * KNOTS)
	assert_greater(farthest(knots, tile_knots(gpu, Vector2i.ZERO)), 1.0, "metres from the first tile")
	for blade: int in [0, 1, 17, 38, 62, 63]:  # a wait for the device each
		assert_eq(gpu.wait_for_knots([gpu.get_tile_blades(tile)[blade]]), blade_of(knots, blade))


func test_six_hundred_steps_without_contact() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
		return
	var body := add_held_body(ball(0.3), PLACE + Vector3(0.35, 0.15, 0.0))  # blades lean at it
	await seen()
	body.free()
	var tiles: Array[Vector2i] = [gpu.get_tile_at(PLACE)]
	var most := 0.0
	var bent := tile_knots(cpu, tiles[0])
	await ticks(60)  # what contact has made of rounding dies down
	for i in 60:
		most = maxf(most, difference(tiles))
		await ticks(10)
	most = maxf(most, difference(tiles))
	print("    parity over 600 steps without contact: %s of a blade's length" % String.num_scientific(most))
	assert_less(most, MANY_STEPS)
	var risen := tile_knots(cpu, tiles[0])
	var leaning := 0  # by more than 5 cm
	for blade in BLADES:
		leaning += 1 if farthest(blade_of(bent, blade), blade_of(risen, blade)) > 0.05 else 0
	assert_greater(leaning, 6)
	assert_eq(gpu.get_counters().steps, cpu.get_counters().steps)
	assert_eq(gpu.get_counters().simulated_blades, cpu.get_counters().simulated_blades)
	assert_greater(gpu.get_counters().free_tile_steps, 600, "by the passes of tiles without colliders")
	assert_greater(gpu.get_counters().strain_blades, 400 * BLADES, "most of them by their strains")
	assert_less(gpu.get_counters().free_tile_steps * BLADES, gpu.get_counters().simulated_blades, "but not those that the body was on")


func memory_without_pool() -> int:
	return gpu.get_memory_usage() - gpu.get_counters().pool_bytes


# 1,089 tiles of 1 m. On most devices simulate has room for 256 at once; tests/drivers/test_own_work.gd is for those where it needs none.
func test_a_step_of_more_tiles_than_there_is_room_for() -> void:
	var size := Vector2(33, 33)
	if not await add_pair({size = size, density = 64.0, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
		return
	var memory := memory_without_pool()
	var rest := tile_knots(gpu, Vector2i.ZERO)
	var force := GrassForce3D.new()
	force.kind = GrassForce3D.KIND_DOWNWASH
	force.speed = 8.0
	force.radius = 60.0
	force.position.y = 1.0
	add_child(force)
	for i in 60:  # the force rises
		if gpu.get_awake_tile_count() == 33 * 33:
			break
		await ticks(1)
	await ticks(16)
	assert_eq(gpu.get_awake_tile_count(), 33 * 33)
	assert_near(memory_without_pool() - memory, 0, 1e6, "bytes: the room is of all fields")
	var blades := PackedInt64Array()
	for tile in awake_tiles(gpu):
		blades.append_array(gpu.get_tile_blades(tile))
	var off := farthest(gpu.wait_for_knots(blades), cpu.wait_for_knots(blades))
	print("    parity of 1,089 tiles: %s m" % String.num_scientific(off))
	assert_less(off, MANY_STEPS)
	assert_greater(farthest(tile_knots(gpu, Vector2i.ZERO), rest), 1e-3, "metres: the force reaches all tiles")


func test_after_a_change_of_method_blades_meet_bodies_alike() -> void:
	if not await add_pair({method = GrassField.METHOD_PBD, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
		return
	var tiles: Array[Vector2i] = [gpu.get_tile_at(PLACE)]
	for method: GrassField.SolverMethod in [GrassField.METHOD_DIRECT, GrassField.METHOD_PBD]:
		for field: GrassField in [gpu, cpu]:
			field.method = method
		for field: GrassField in [gpu, cpu]:
			await grown(field)
		await compiled(gpu)
		assert_eq([gpu.get_awake_tile_count(), cpu.get_awake_tile_count()], [0, 0], "made anew, at rest")
		var body := add_held_body(ball(0.3), PLACE + Vector3(0.35, 0.15, 0.0))
		await seen()
		body.free()
		await ticks(10)
		var off := difference(tiles)
		print("    parity after a change of method: %s of a blade's length" % String.num_scientific(off))
		assert_less(share_apart(tiles, IN_CONTACT), 2.0 / BLADES, "one blade may slip in another way")


func test_squashed_blades_rise_to_the_same_place() -> void:  # which way one unfolds may hang on its last bits: on the way they part
	if not await add_pair({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
		return
	var tiles: Array[Vector2i] = [gpu.get_tile_at(PLACE)]
	var rest := tile_knots(gpu, tiles[0])
	var body := add_held_body(ball(0.2), PLACE)
	await seen()
	assert_greater(farthest(tile_knots(gpu, tiles[0]), rest), 0.1, "squashed, metres")
	body.free()
	var most := 0.0
	for i in 30:
		await ticks(10)
		most = maxf(most, difference(tiles))
	var off := difference(tiles)
	print(
		"    parity after squashing: %s of a blade's length on the way, then %s" % [String.num_scientific(most), String.num_scientific(off)]
	)
	assert_less(off, MANY_STEPS)


func test_fields_that_changed_while_they_stood() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.1, settle_time = 0.1}):
		return
	var reed := GrassSpecies.new()
	reed.patch = GrassPatch.new()
	reed.patch.length_max = 0.9
	reed.natural_frequency = 1.0
	var map := full_map()
	map.stroke(brush(GrassBrush.TOOL_CUT, 0.6, {cut_height = 0.3}), Vector2.ZERO, Vector2.ZERO)
	for change: Dictionary in [
		{pool_tiles = 64}, {map = map}, {species = [GrassSpecies.new(), reed]}, {pool_tiles = 900}, {map = null}, {species = []}
	]:
		var property: String = change.keys()[0]
		for field: GrassField in [gpu, cpu]:
			field.set(property, change[property])
		for field: GrassField in [gpu, cpu]:
			await grown(field)
		await compiled(gpu)
		var body := add_held_body(ball(0.2), PLACE)
		await ticks(4)
		var tiles := awake_tiles(cpu)
		assert_eq(awake_tiles(gpu), tiles, property)
		assert_greater(tiles.size(), 3, property)
		var off := share_apart(tiles, MANY_STEPS)
		print("    parity after another `%s`: %s of the blades part" % [property, off])
		assert_less(off, FEW, property)
		body.free()
		await ticks(30)
		assert_eq(gpu.get_awake_tile_count() + cpu.get_awake_tile_count(), 0, property)


func test_the_same_tiles_are_awake_in_every_tick() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.3, settle_time = 0.2, pool_tiles = 24}):
		return
	var body := add_held_body(ball(0.2), Vector3(-2.5, 0.2, 0.2))
	var most := 0
	for i in 200:
		body.position.x += 0.04
		await ticks(1)
		var awake := awake_tiles(cpu)
		most = maxi(most, awake.size())
		if not assert_eq(awake_tiles(gpu), awake, "tick %d" % i):
			return
		if not assert_eq(gpu.get_counters().woken, cpu.get_counters().woken, "tick %d" % i):
			return
	assert_greater(most, 5)
	assert_eq(awake_tiles(gpu).size(), 0, "at the end all sleep")
	assert_greater(gpu.get_counters().woken, 15)


func test_settled_on_the_gpu_too() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.3, settle_time = 0.3}):
		return
	var tile := gpu.get_tile_at(PLACE)
	var rest := tile_knots(gpu, tile)
	var body := add_held_body(ball(0.2), PLACE)
	await ticks(20)
	assert_greater(farthest(tile_knots(gpu, tile), rest), 0.05)
	body.free()
	var last := PackedVector3Array()
	var limit := 120
	while gpu.is_tile_awake(tile) and limit > 0:
		last = tile_knots(gpu, tile)
		await ticks(1)
		limit -= 1
	assert_false(gpu.is_tile_awake(tile), "asleep")
	assert_less(farthest(last, rest), 1e-3, "the last simulated pose")


## Energies arrive late from the GPU, so it may sleep later than the CPU, never before. Nothing else is asked of the GPU
## here: reading knots would bring the energies too.
func test_asleep_by_energy_on_the_gpu_too() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_ENERGY}):
		return
	var body := add_held_body(ball(0.2), PLACE)
	await ticks(20)
	body.free()
	var ends := {}
	for i in 400:
		for field: GrassField in [cpu, gpu]:
			if not ends.has(field) and field.get_awake_tile_count() == 0:
				ends[field] = i
		await ticks(1)
	if not assert_eq(ends.size(), 2, "both sleep"):
		return
	print("    asleep by energy: CPU after %d ticks, GPU after %d" % [ends[cpu], ends[gpu]])
	assert_true(ends[gpu] >= ends[cpu], "not before")
	assert_less(ends[gpu] - ends[cpu], 60, "ticks later")
	assert_eq(gpu.get_counters().woken, cpu.get_counters().woken)


func test_nothing_moves_when_the_gpu_puts_a_tile_to_sleep() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_ENERGY}):
		return
	var tile := gpu.get_tile_at(PLACE)
	var rest := tile_knots(gpu, tile)
	var body := add_held_body(ball(0.2), PLACE)
	await ticks(20)
	body.free()
	var poses: Array[PackedVector3Array] = [tile_knots(gpu, tile)]
	while gpu.is_tile_awake(tile) and poses.size() < 400:
		await ticks(1)
		poses.append(tile_knots(gpu, tile))
	if not assert_false(gpu.is_tile_awake(tile), "asleep"):
		return
	var step := 0.0
	for i in 10:  # settling is shorter
		step = maxf(step, farthest(poses[-1 - i], poses[-2 - i]))
	var way := farthest(poses[-11], rest)
	print("    the last 10 of %d ticks moved blades by %.3f mm, one by %.3f mm" % [poses.size(), 1e3 * way, 1e3 * step])
	assert_less(way, 1e-3, "metres")
	assert_less(step, 1e-3, "metres")


## Hills, cuts, combing and wear: growth travels to the GPU when tiles wake and when the map changes below them.
func test_a_map_is_simulated_alike() -> void:
	var map := full_map()
	var heights := Image.create_empty(8, 8, false, Image.FORMAT_RF)
	for x in 8:
		for z in 8:
			heights.set_pixel(x, z, Color(0.2 * x, 0, 0))
	map.set_ground(heights, Rect2(-4, -4, 8, 8))
	map.stroke(brush(GrassBrush.TOOL_COMB, 1.0), Vector2(-1, 0), Vector2(1, 0))
	if not await add_pair({map = map, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
		return
	var tile := gpu.get_tile_at(PLACE)
	for woken: Vector2i in [tile, Vector2i(1, 6)]:
		await assert_same_rest(woken)
	var ground := gpu.get_knots(tile, 0)[0].y
	assert_greater(ground, 0.5, "metres, up the hill")
	var body := add_held_body(ball(0.2), PLACE + Vector3(0, ground, 0))
	await seen()
	var bent := difference([tile])
	var bends: Array[Vector3] = []
	await ticks(10)
	for field: GrassField in [cpu, gpu]:
		bends.append(field.get_bend_at(PLACE))
	print("    parity on a hill: %s of a blade's length; bend CPU %s, GPU %s" % [String.num_scientific(bent), bends[0], bends[1]])
	assert_less(bent, IN_CONTACT)
	assert_greater(bends[0].length(), 0.05)
	assert_near(bends[1], bends[0], 0.05)
	body.free()
	map.stroke(brush(GrassBrush.TOOL_CUT, 2.0, {cut_height = 0.1}), Vector2(0, 0), Vector2(0, 0))
	await ticks(200)
	var cut := difference([tile])
	print("    parity after a cut under an awake tile: %s of a blade's length" % String.num_scientific(cut))
	assert_true(gpu.is_tile_awake(tile))
	assert_less(cut, MANY_STEPS)
	var stump := blade_of(tile_knots(gpu, tile), 5)
	assert_less(stump[0].distance_to(stump[15]), 0.11)

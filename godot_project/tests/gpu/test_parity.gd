# SPDX-License-Identifier: MIT
## The GPU's simulation against the CPU's: two fields of one seed on one spot, pushed by the same bodies.
extends "res://tests/field_case.gd"

const ONE_STEP := 1e-5 # of a blade's length, after one step with contact
const MANY_STEPS := 1e-3 # of a blade's length, after 600 steps without
const OVER_THE_GRASS := 0.75 # metres
const SINKING := 0.02 # metres a tick
const CREEPING := 0.002 # metres a tick
const THIN := 0.005 # metres, half of what is thinner than a segment
const HALF_STICK := 0.6 # metres
const SKIN := 0.005 # metres, more than knots feel a surface from
const PLACE := Vector3(0.25, 0.25, 0.25)

var cpu: GrassField
var gpu: GrassField


func add_pair(properties := {}) -> bool:
	gpu = add_field(properties)
	cpu = add_field(properties)
	cpu.backend = GrassField.BACKEND_CPU
	await ticks(2)
	return assert_eq(gpu.get_statistics().backend, "GPU") and assert_eq(cpu.get_statistics().backend, "CPU")


## The farthest that a knot of the GPU lies from the CPU's, as a share of its blade's length, over all awake tiles.
func difference(tiles: Array[Vector2i]) -> float:
	var most := 0.0
	for tile in tiles:
		for blade in BLADES:
			most = maxf(most, blade_difference(tile, blade))
	return most


func blade_difference(tile: Vector2i, blade: int) -> float:
	var a := gpu.get_knots(tile, blade)
	return farthest(a, cpu.get_knots(tile, blade)) / (15 * a[0].distance_to(a[1]))


func bodies_of_all_shapes() -> Array[AnimatableBody3D]:
	var capsule := CapsuleShape3D.new()
	capsule.radius = 0.1
	capsule.height = 0.5
	var box := BoxShape3D.new()
	box.size = Vector3(0.3, 0.2, 0.4)
	var cylinder := CylinderShape3D.new()
	cylinder.radius = 0.15
	cylinder.height = 0.3
	var hull := ConvexPolygonShape3D.new()
	hull.points = PackedVector3Array([Vector3(0.2, 0, 0), Vector3(-0.2, 0, 0), Vector3(0, 0.2, 0.1), Vector3(0, -0.2, 0), Vector3(0, 0, 0.2), Vector3(0, 0, -0.2)])
	var bodies: Array[AnimatableBody3D] = []
	for shape: Shape3D in [ball(0.2), capsule, box, cylinder, hull]:
		var body := add_held_body(shape, Vector3(-1.5 + 0.75 * bodies.size(), OVER_THE_GRASS, 0.3))
		body.rotation = Vector3(0.3, 0.2, 0.1) * bodies.size()
		bodies.append(body)
	return bodies


func test_rest_is_the_same() -> void:
	if not await add_pair({seed = 3}):
		return
	assert_eq(difference([Vector2i.ZERO, Vector2i(7, 7)]), 0.0)


func test_the_first_contact() -> void:
	if not await add_pair():
		return
	var bodies := bodies_of_all_shapes()
	for i in 60:
		for body in bodies:
			body.position.y -= SINKING
		await ticks(1)
		if difference(awake_tiles(cpu)) > 0.0:
			break
	var tiles := awake_tiles(cpu)
	assert_eq(awake_tiles(gpu), tiles)
	assert_greater(tiles.size(), 10)
	var off := difference(tiles)
	print("    parity at the first contact: %s of a blade's length" % String.num_scientific(off))
	assert_less(off, ONE_STEP)
	for body in bodies:
		body.free()
	var still := add_field({simulated = false})
	await ticks(2)
	var bent := 0.0
	for tile in tiles:
		bent = maxf(bent, farthest(tile_knots(cpu, tile), tile_knots(still, tile)))
	assert_greater(bent, 1e-4, "metres: the contact bent blades")


## Thin and sharp shapes beside the field's first tiles, level, lower than the blades' tips.
func sharp_bodies() -> Array[AnimatableBody3D]:
	var stick := CapsuleShape3D.new()
	stick.radius = THIN
	stick.height = 2 * HALF_STICK
	var rod := CylinderShape3D.new()
	rod.radius = THIN
	rod.height = 2 * HALF_STICK
	var lath := BoxShape3D.new()
	lath.size = Vector3(2 * THIN, 2 * HALF_STICK, 2 * THIN)
	var bodies: Array[AnimatableBody3D] = []
	for shape: Shape3D in [stick, rod, lath]:
		var body := add_held_body(shape, Vector3(-2.6, 0.2 + 0.05 * bodies.size(), 1.3 * bodies.size() - 1.3))
		body.rotation = Vector3(PI / 2, 0.1 * bodies.size(), 0)
		bodies.append(body)
	return bodies


## How near one of these points is to the middle line of one of the bodies, metres.
func nearest(points: PackedVector3Array, bodies: Array[AnimatableBody3D]) -> float:
	var least := INF
	for body in bodies:
		var half := body.global_basis.y * HALF_STICK
		for point in points:
			var on_line := Geometry3D.get_closest_point_to_segment(point, body.position - half, body.position + half)
			least = minf(least, point.distance_to(on_line))
	return least


## What is thinner than a segment bends blades by the edges between their knots.
func test_the_first_contact_of_edges() -> void:
	if not await add_pair():
		return
	var bodies := sharp_bodies()
	var still := add_field({simulated = false})
	await ticks(2)
	var first := PackedVector3Array()
	for z in still.get_tiles().y:
		first.append_array(tile_knots(still, Vector2i(0, z)))
	var by_edges := 0
	var bent := {}
	var most := 0.0
	for i in 200:
		for body in bodies:
			body.position.x += CREEPING if nearest(first, [body]) < 0.05 else SINKING
		await ticks(1)
		for tile in awake_tiles(cpu):
			for blade in BLADES:
				var rest := still.get_knots(tile, blade)
				if not bent.has([tile, blade]) and farthest(cpu.get_knots(tile, blade), rest) > 1e-5:
					bent[[tile, blade]] = true
					if nearest(rest, bodies) > THIN + SKIN + CREEPING:
						by_edges += 1
						most = maxf(most, blade_difference(tile, blade))
		if by_edges >= 5:
			break
	print("    parity when edges alone first bend a blade, %d of %d: %s of its length" % [by_edges, bent.size(), String.num_scientific(most)])
	assert_greater(by_edges, 4, "blades that no knot's contact bent first")
	assert_less(most, ONE_STEP)


## A slab that lies on the grass: what it holds sticks, to the bit, on both.
func test_held_blades_stand_still_on_both() -> void:
	if not await add_pair():
		return
	var slab := BoxShape3D.new()
	slab.size = Vector3(0.8, 0.1, 0.8)
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
	print("    under a slab stand still: CPU %d, GPU %d of %d blades; knots %.3f and %.3f mm high" % [still_now[0], still_now[1], BLADES, bends[0], bends[1]])
	assert_greater(still_now[0], BLADES / 2)
	assert_near(still_now[1], still_now[0], 3)
	assert_near(bends[1], bends[0], 0.02 * bends[0], "mm")


func test_six_hundred_steps_without_contact() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
		return
	var body := add_held_body(ball(0.2), PLACE)
	await seen()
	body.free()
	var tiles: Array[Vector2i] = [gpu.get_tile_at(PLACE)]
	var most := 0.0
	for i in 12:
		most = maxf(most, difference(tiles))
		await ticks(50)
	most = maxf(most, difference(tiles))
	print("    parity over 600 steps without contact: %s of a blade's length" % String.num_scientific(most))
	assert_less(most, MANY_STEPS)
	assert_eq(gpu.get_statistics().steps, cpu.get_statistics().steps)
	assert_eq(gpu.get_statistics().simulated_blades, cpu.get_statistics().simulated_blades)


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
		if not assert_eq(gpu.get_statistics().slept, cpu.get_statistics().slept, "tick %d" % i):
			return
	assert_greater(most, 5)
	assert_eq(awake_tiles(gpu).size(), 0, "at the end all sleep")
	assert_greater(gpu.get_statistics().slept, 15)


## Contacts amplify rounding, so the long run is compared as a whole: how far blades are bent on average.
func test_bent_alike_under_a_moving_body() -> void:
	if not await add_pair():
		return
	var tile := Vector2i(4, 4)
	var rest := tile_knots(cpu, tile)
	var body := add_held_body(ball(0.2), Vector3(-1, 0.2, 0.2))
	for i in 40:
		body.position.x += 0.03
		await ticks(1)
	var bends: Array[float] = []
	for field: GrassField in [cpu, gpu]:
		var knots := tile_knots(field, tile)
		var sum := 0.0
		for i in knots.size():
			sum += knots[i].distance_to(rest[i])
		bends.append(1e3 * sum / knots.size())
	print("    mean bend under a moving ball: CPU %.3f mm, GPU %.3f mm" % [bends[0], bends[1]])
	assert_greater(bends[0], 10.0)
	assert_near(bends[1], bends[0], 0.02 * bends[0], "mm")


func test_settled_on_the_gpu_too() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.3, settle_time = 0.3}):
		return
	var tile := gpu.get_tile_at(PLACE)
	var rest := tile_knots(gpu, tile)
	var body := add_held_body(ball(0.2), PLACE)
	await ticks(20)
	assert_greater(farthest(tile_knots(gpu, tile), rest), 0.05)
	body.free()
	var last := rest
	var limit := 120
	while gpu.is_tile_awake(tile) and limit > 0:
		last = tile_knots(gpu, tile)
		await ticks(1)
		limit -= 1
	assert_less(farthest(last, rest), 1e-3, "the last simulated pose")
	assert_eq(tile_knots(gpu, tile), rest, "asleep")


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
	assert_eq(gpu.get_statistics().slept, cpu.get_statistics().slept)


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
	assert_eq(poses[-1], rest, "asleep")
	var step := 0.0
	for i in 10: # settling is shorter
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
	assert_eq(difference([tile, Vector2i(1, 6)]), 0.0, "at rest")
	var ground := gpu.get_knots(tile, 0)[0].y
	assert_greater(ground, 0.5, "metres, up the hill")
	var body := add_held_body(ball(0.2), PLACE + Vector3(0, ground, 0))
	await seen()
	var bent := difference([tile])
	var bends: Array[Vector3] = []
	await ticks(10)
	for field: GrassField in [cpu, gpu]:
		bends.append(field.bend_at(PLACE))
	print("    parity on a hill: %s of a blade's length; bend CPU %s, GPU %s" % [String.num_scientific(bent), bends[0], bends[1]])
	assert_less(bent, MANY_STEPS)
	assert_greater(bends[0].length(), 0.05)
	assert_near(bends[1], bends[0], 0.05)
	body.free()
	map.stroke(brush(GrassBrush.TOOL_CUT, 2.0, { cut_height = 0.1 }), Vector2(0, 0), Vector2(0, 0))
	await ticks(200)
	var cut := difference([tile])
	print("    parity after a cut under an awake tile: %s of a blade's length" % String.num_scientific(cut))
	assert_true(gpu.is_tile_awake(tile))
	assert_less(cut, MANY_STEPS)
	assert_less(gpu.get_knots(tile, 5)[0].distance_to(gpu.get_knots(tile, 5)[15]), 0.11)

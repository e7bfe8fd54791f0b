# SPDX-License-Identifier: MIT
## The GPU's contacts against the CPU's.
extends "res://tests/parity_case.gd"

const ONE_STEP := 1e-5  # of a blade's length, after one step with contact
const SINKING := 0.02  # metres a tick
const BENT := 1e-4  # metres, and more: not by rounding
const OVER_THE_GRASS := 0.75  # metres
const CREEPING := 0.002  # metres a tick
const THIN := 0.005  # metres, half of what is thinner than a segment
const HALF_STICK := 0.6  # metres
const UNDER_A_BALL := 1e-3  # of a blade's length, after ten steps, of steady blades
const NUDGE := 1e-6  # metres: a few times what a card's rounding moves a blade
const STEADY := 1e-4  # of a blade's length: the most that a nudge changes where a steady blade is after ten steps
const ABOVE_THE_TIPS := 0.62  # metres: near enough to be in the lists of tiles
const CROWDED := 2e-3  # of a blade's length
const FEW_APART := 0.02  # share of the blades
const SKIN := 0.0025  # metres, more than knots feel a surface from


## Returns how far the knots of a tile are from `rest` on average, mm: on the CPU and on the GPU.
func mean_bends(tile: Vector2i, rest: PackedVector3Array) -> Array[float]:
	var bends: Array[float] = []
	for field: GrassField in [cpu, gpu]:
		var knots := tile_knots(field, tile)
		var sum := 0.0
		for i in knots.size():
			sum += knots[i].distance_to(rest[i])
		bends.append(1e3 * sum / knots.size())
	return bends


func every_tile(field: GrassField) -> Array[Vector2i]:
	var tiles: Array[Vector2i] = []
	for x in field.get_grid_size().x:
		for z in field.get_grid_size().y:
			tiles.append(Vector2i(x, z))
	return tiles


func bodies_of_all_shapes() -> Array[AnimatableBody3D]:
	var capsule := CapsuleShape3D.new()
	capsule.radius = 0.1
	capsule.height = 0.5
	var cylinder := CylinderShape3D.new()
	cylinder.radius = 0.15
	cylinder.height = 0.3
	var hull := ConvexPolygonShape3D.new()
	hull.points = PackedVector3Array(
		[Vector3(0.2, 0, 0), Vector3(-0.2, 0, 0), Vector3(0, 0.2, 0.1), Vector3(0, -0.2, 0), Vector3(0, 0, 0.2), Vector3(0, 0, -0.2)]
	)
	var bodies: Array[AnimatableBody3D] = []
	for shape: Shape3D in [ball(0.2), capsule, box(Vector3(0.3, 0.2, 0.4)), cylinder, hull]:
		var body := add_held_body(shape, Vector3(-1.5 + 0.75 * bodies.size(), OVER_THE_GRASS, 0.3))
		body.rotation = Vector3(0.3, 0.2, 0.1) * bodies.size()
		bodies.append(body)
	return bodies


func test_the_first_contact() -> void:
	if not await add_pair():
		return
	var bodies := bodies_of_all_shapes()
	var still := add_field({simulated = false})
	await ticks(2)
	var rest := knots_of(still, every_tile(still))
	var tiles: Array[Vector2i] = []
	var bent := 0.0
	for i in 60:
		for body in bodies:
			body.position.y -= SINKING
		await ticks(1)
		tiles = awake_tiles(cpu)
		for tile in tiles:
			bent = maxf(bent, farthest(tile_knots(cpu, tile), rest[tile]))
		if bent > BENT:
			break
	assert_eq(awake_tiles(gpu), tiles)
	assert_greater(tiles.size(), 10)
	var off := difference(tiles)
	print("    parity at the first contact: %s of a blade's length" % String.num_scientific(off))
	assert_less(off, ONE_STEP)
	assert_greater(bent, BENT, "metres: the contact bent blades")


## Thin and sharp shapes beside the field's first tiles, level, lower than the blades' tips.
func sharp_bodies() -> Array[AnimatableBody3D]:
	var stick := CapsuleShape3D.new()
	stick.radius = THIN
	stick.height = 2 * HALF_STICK
	var rod := CylinderShape3D.new()
	rod.radius = THIN
	rod.height = 2 * HALF_STICK
	var lath := box(Vector3(2 * THIN, 2 * HALF_STICK, 2 * THIN))
	var bodies: Array[AnimatableBody3D] = []
	for shape: Shape3D in [stick, rod, lath]:
		var body := add_held_body(shape, Vector3(-2.6, 0.2 + 0.05 * bodies.size(), 1.3 * bodies.size() - 1.3))
		body.rotation = Vector3(PI / 2, 0.1 * bodies.size(), 0)
		bodies.append(body)
	return bodies


## Returns how near one of these points is to the middle line of one of the bodies, metres.
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
	var rest := knots_of(still, every_tile(still))
	var first := PackedVector3Array()
	for z in still.get_grid_size().y:
		first.append_array(rest[Vector2i(0, z)])
	var by_edges := 0
	var bent := {}
	var most := 0.0
	for i in 200:
		for body in bodies:
			body.position.x += CREEPING if nearest(first, [body]) < 0.05 else SINKING
		await ticks(1)
		for tile in awake_tiles(cpu):
			var now := tile_knots(cpu, tile)
			var fresh: Array[int] = []  # blades that edges alone bend from this tick on
			for blade in BLADES:
				var at_rest := blade_of(rest[tile], blade)
				if not bent.has([tile, blade]) and farthest(blade_of(now, blade), at_rest) > 1e-5:
					bent[[tile, blade]] = true
					if nearest(at_rest, bodies) > THIN + SKIN + CREEPING:
						fresh.append(blade)
			var off := blade_differences(tile) if fresh else PackedFloat64Array()
			for blade in fresh:
				by_edges += 1
				most = maxf(most, off[blade])
		if by_edges >= 5:
			break
	print(
		"    parity when edges alone first bend a blade, %d of %d: %s of its length" % [by_edges, bent.size(), String.num_scientific(most)]
	)
	assert_greater(by_edges, 4, "blades that no knot's contact bent first")
	assert_less(most, ONE_STEP)


## Contacts amplify rounding, so the long run is compared as a whole: how far blades are bent on average.
func test_bent_alike_under_a_moving_body() -> void:
	for rate: float in [400.0, 1600.0]:
		if not await add_pair({contact_rate = rate}):
			return
		var tile := Vector2i(4, 4)
		var rest := tile_knots(cpu, tile)
		var body := add_held_body(ball(0.2), Vector3(-1, 0.2, 0.2))
		for i in 40:
			body.position.x += 0.03
			await ticks(1)
		var bends := mean_bends(tile, rest)
		print("    mean bend under a moving ball, %d Hz: CPU %.3f mm, GPU %.3f mm" % [rate, bends[0], bends[1]])
		assert_greater(bends[0], 10.0)
		assert_near(bends[1], bends[0], 0.02 * bends[0], "mm")
		for node: Node in [body, cpu, gpu]:
			node.free()


## Fields on the CPU that are where the pair is, but for a nudge. A leaf that is hit edge-on falls to the side that rounding says: on
## the CPU alone a nudge moves one of the tile's blades by three hundredths of its length in ten steps.
func add_nudged() -> Array[GrassField]:
	var fields: Array[GrassField] = []
	for way: Vector3 in [Vector3.LEFT, Vector3.RIGHT, Vector3.FORWARD, Vector3.BACK]:
		var properties := {position = NUDGE * way, backend = GrassField.BACKEND_CPU, simulation_detail = GrassField.SIMULATION_WHOLE}
		fields.append(add_field(properties))
	return fields


## Tiles under what is round and large are left to the pass that knows no edges, and bend as on the CPU all the same.
func test_edges_are_asked_only_near_what_is_sharp() -> void:
	if not await add_pair():
		return
	var nudged := add_nudged()
	var body := add_held_body(ball(1.0), PLACE + Vector3(0, 1.2, 0))
	await ticks(10)
	assert_eq(gpu.get_counters().edge_tile_steps, 0)
	var tile := gpu.get_tile_at(PLACE)
	assert_true(gpu.is_tile_awake(tile) and cpu.is_tile_awake(tile))
	var off := blade_differences(tile)
	var by_nudges := nudged.map(func(field: GrassField) -> PackedFloat64Array: return blade_differences(tile, field))
	var steady := range(BLADES).filter(
		func(blade: int) -> bool: return by_nudges.all(func(by_nudge: PackedFloat64Array) -> bool: return by_nudge[blade] < STEADY)
	)
	var most := 0.0
	for blade: int in steady:
		most = maxf(most, off[blade])
	print(
		(
			"    parity under a ball of 1 m, without edges: %s of a blade's length, %d steady blades"
			% [String.num_scientific(most), steady.size()]
		)
	)
	assert_less(most, UNDER_A_BALL)
	assert_greater(steady.size(), 0.9 * BLADES)
	for field: GrassField in nudged:
		field.free()
	body.free()
	add_held_body(box(Vector3(0.5, 0.2, 0.5)), PLACE + Vector3(0, 0.2, 0))
	await ticks(5)
	assert_greater(gpu.get_counters().edge_tile_steps, 0)


## A workgroup shares the first 32 colliders of its tile. Of this crowd only the last one reaches the grass.
func test_a_crowd_over_one_tile() -> void:
	if not await add_pair():
		return
	for i in 40:
		add_held_body(ball(0.01), PLACE + Vector3(0.01 * (i - 20), ABOVE_THE_TIPS, 0.0))
	add_held_body(ball(0.15), PLACE + Vector3(0.0, 0.1, 0.0))
	await ticks(2)
	await compiled(gpu)
	await seen()
	var tile := gpu.get_tile_at(PLACE)
	var still := add_field({simulated = false})
	await ticks(2)
	assert_greater(gpu.get_counters().crowd_tile_steps, 0)
	assert_greater(farthest(tile_knots(gpu, tile), tile_knots(still, tile)), 0.1, "metres: the last ball presses blades")
	await ticks(60)
	assert_less(share_apart([tile], CROWDED), FEW_APART)


func test_bent_alike_beside_a_body_that_grows() -> void:
	if not await add_pair({contact_rate = 1600.0}):
		return
	var tile := Vector2i(4, 4)
	var rest := tile_knots(cpu, tile)
	var shape := ball(0.1)
	add_held_body(shape, Vector3(0.1, 0.2, 0.2))
	await ticks(20)
	for i in 30:
		shape.radius *= 1.03
		await ticks(1)
	var bends := mean_bends(tile, rest)
	print("    mean bend beside a ball that grows: CPU %.3f mm, GPU %.3f mm" % bends)
	assert_greater(bends[0], 10.0)
	assert_near(bends[1], bends[0], 0.02 * bends[0], "mm")

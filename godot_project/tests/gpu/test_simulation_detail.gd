# SPDX-License-Identifier: MIT
## Only the blades that cameras need are simulated; they move as if all were, and others join them in their pose.
extends "res://tests/view_case.gd"

const FIRST := 4  # blades of a far tile that are simulated
const APART := 2e-3  # of a blade's length
const FEW := 0.03  # share of the blades
const FAR := Vector3(3, 3, 5)


func add_bodies() -> Array[AnimatableBody3D]:
	var box := BoxShape3D.new()
	box.size = Vector3(0.5, 0.3, 0.4)
	var bodies: Array[AnimatableBody3D] = []
	for i in 6:
		var body := add_held_body(ball(0.2) if i % 2 == 0 else box, Vector3(-3.0, 0.15, i - 2.4))
		remove_child(body)
		viewport.add_child(body)
		bodies.append(body)
	return bodies


## Returns blades of the awake tiles, the first `count` of each.
func blades_of(field: GrassField, count: int) -> PackedInt64Array:
	var blades := PackedInt64Array()
	for tile in awake_tiles(field):
		blades.append_array(field.get_tile_blades(tile).slice(0, count))
	return blades


func add_whole_and_seen(properties := {}) -> Array[GrassField]:
	var fields: Array[GrassField] = []
	for detail: GrassField.SimulationDetail in [GrassField.SIMULATION_WHOLE, GrassField.SIMULATION_SEEN]:
		fields.append(
			add_seen_field(
				properties.merged(
					{size = Vector2(12, 8), simulation_detail = detail, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}
				)
			)
		)
	return fields


func roll(bodies: Array[AnimatableBody3D], count: int) -> void:
	for i in count:
		for body in bodies:
			body.position.x += 0.03
			body.rotate_z(-0.1)
		await ticks(1)


## Waits until tiles can share workgroups: the first step with thinned tiles asks for those passes.
func shared(field: GrassField, bodies: Array[AnimatableBody3D]) -> void:
	await compiled(field)
	await roll(bodies, 8)
	await compiled(field)


func test_the_simulated_blades_of_far_tiles_move_as_in_whole_ones() -> void:
	look(FAR, Vector3.ZERO)
	for properties: Dictionary in [{}, {method = GrassField.METHOD_PBD}]:
		var fields := add_whole_and_seen(properties)
		await fields_shown()
		var bodies := add_bodies()
		await shared(fields[1], bodies)
		await roll(bodies, 45)
		var before := fields[1].get_counters()
		await roll(bodies, 1)
		var after := fields[1].get_counters()
		var tiles: int = after.tile_steps - before.tile_steps
		assert_greater(tiles, 80)
		assert_less(after.simulated_blades - before.simulated_blades, 0.3 * tiles * BLADES)
		if after.workgroups > 0:  # on the GPU
			assert_less(after.workgroups - before.workgroups, 0.4 * tiles, "tiles share workgroups")
		var blades := blades_of(fields[0], FIRST)
		assert_eq(blades, blades_of(fields[1], FIRST))
		var whole := fields[0].wait_for_knots(blades)
		var thinned := fields[1].wait_for_knots(blades)
		var apart := 0
		var bent := 0
		for blade in blades.size():
			var own := blade_of(whole, blade)
			var off := farthest(own, blade_of(thinned, blade)) / length_of(whole, blade)
			apart += int(off > APART)
			bent += int(own[15].y - own[0].y < 0.8 * length_of(whole, blade))
		print("    %d of %d blades are apart, %d are bent" % [apart, blades.size(), bent])
		assert_less(apart, FEW * blades.size() + 1)
		assert_greater(bent, 50)
		for node: Node in fields + bodies as Array[Node]:
			node.free()


func test_blades_join_in_the_pose_of_their_neighbours() -> void:
	look(FAR, Vector3.ZERO)
	var fields := add_whole_and_seen()
	await fields_shown()
	var bodies := add_bodies()
	await shared(fields[1], bodies)
	await roll(bodies, 60)
	assert_eq(fields[1].get_counters().widened_tiles, 0)
	for body in bodies:
		body.free()  # they would bend by themselves what has joined upright
	viewport.size = Vector2i(2560, 1440)  # as if the camera came near
	viewport.render_target_update_mode = SubViewport.UPDATE_WHEN_VISIBLE  # nobody looks: it is not drawn
	await drawn()
	assert_greater(fields[1].get_counters().widened_tiles, 100)
	var blades := blades_of(fields[0], BLADES)
	var whole := fields[0].wait_for_knots(blades)
	var joined := fields[1].wait_for_knots(blades)
	for field in fields:
		field.free()
	var untouched := add_whole_and_seen()[0]
	await fields_shown()
	var rest := untouched.wait_for_knots(blades)
	var alike := 0.0
	var bent := 0
	for blade in blades.size():
		var own := blade_of(whole, blade)
		var length := own[0].distance_to(own[1]) / CLAMP_SHARE
		assert_near(length_of(joined, blade), length_of(whole, blade), 1e-3 * length)
		var bend := own[15] - blade_of(rest, blade)[15]
		if bend.length() > 0.3 * length and blade % BLADES >= BLADES / 2:  # the first ones were simulated before
			bent += 1
			alike += (blade_of(joined, blade)[15] - blade_of(rest, blade)[15]).dot(bend) / bend.length_squared()
	print("    %d bent blades have joined with %.2f of their bend" % [bent, alike / bent])
	assert_greater(bent, 150)
	assert_greater(alike, 0.15 * bent)  # 0.25; their own rest: 0.00


## Returns the greatest change from one frame to the next while the camera comes nearer to balls that lie in the grass.
func most_change(field: GrassField) -> float:
	var most := 0.0
	var before: Image = null
	for i in 25:
		look(Vector3(0.4, 1.3, lerpf(5.0, 3.6, i / 24.0)), Vector3.ZERO)
		await frames(1)
		var now := await next_picture()
		most = maxf(most, difference(now, before).y) if before else 0.0
		before = now
	assert_false(field.get_statistics().waiting)
	return most


func test_nothing_jumps_as_blades_join() -> void:
	viewport.free()
	open_view(Vector2i(192, 108))
	add_light()
	var changes := PackedFloat64Array()
	for detail: GrassField.SimulationDetail in [GrassField.SIMULATION_WHOLE, GrassField.SIMULATION_SEEN]:
		var field := add_seen_field(
			{size = Vector2(12, 12), simulation_detail = detail, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 60.0}
		)
		look(Vector3(0.4, 1.7, 12.0), Vector3.ZERO)
		await fields_shown()
		var bodies := add_bodies()
		await shared(field, bodies)
		await roll(bodies, 60)
		await ticks(20)
		changes.append(await most_change(field))
		assert_eq(field.get_counters().widened_tiles > 20, detail == GrassField.SIMULATION_SEEN)
		for node: Node in bodies + [field] as Array[Node]:
			node.free()
	print("    most change of a frame: %.5f if whole, %.5f if seen" % [changes[0], changes[1]])
	assert_less(changes[1], 1.15 * changes[0])


## A wind bends the grass and is gone. Unlike a body it amplifies no rounding.
func blow(count := 30) -> void:
	var wind := GrassForce3D.new()
	wind.kind = GrassForce3D.KIND_WIND
	wind.speed = 8.0
	wind.radius = 6.0
	wind.turbulence = 0.0
	viewport.add_child(wind)
	await ticks(count)
	wind.free()


## Returns how many of the blades are farther apart than a share of their length.
func count_apart(a: PackedVector3Array, b: PackedVector3Array, most: float) -> int:
	var apart := 0
	for blade in a.size() / KNOTS:
		apart += int(farthest(blade_of(a, blade), blade_of(b, blade)) > most * length_of(a, blade))
	return apart


func test_blades_by_their_strains_swing_as_on_the_cpu() -> void:
	look(FAR, Vector3.ZERO)
	var fields := add_whole_and_seen()
	fields.append(add_whole_and_seen({backend = GrassField.BACKEND_CPU})[1])
	for field in fields:
		field.species = kind({damping_ratio = 0.1})  # so that they still swing when they are alone
	await fields_shown()
	await blow(3)
	await ticks(125)  # the first step by strains asks for its pass
	await compiled(fields[1])
	await blow()
	await ticks(125)
	var blades := blades_of(fields[0], FIRST)
	var knots: Array[PackedVector3Array] = []
	for field in fields:
		assert_greater(field.get_counters().strain_blades, 20 * BLADES)
		knots.append(field.wait_for_knots(blades))
	assert_less(count_apart(knots[0], knots[1], 0.02), FEW * blades.size())
	assert_less(count_apart(knots[1], knots[2], 5e-3), FEW * blades.size(), "GPU and CPU")
	await ticks(8)
	var later := fields[1].wait_for_knots(blades)
	var moved := 0
	for blade in blades.size():
		var length := length_of(knots[0], blade)
		moved += int(farthest(blade_of(knots[1], blade), blade_of(later, blade)) > 0.005 * length)
		assert_near(length_of(knots[1], blade), length, 1e-3 * length)
	assert_greater(moved, 20)

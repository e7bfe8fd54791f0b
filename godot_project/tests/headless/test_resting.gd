# SPDX-License-Identifier: MIT
## Fields that nothing touches rest: nothing is called for them, however many they are, and whatever may bend them is noticed at once.
extends "res://tests/field_case.gd"

const MIDDLE := Vector3(0.25, 0.25, 0.25)
const FAR := Vector3(0, 0, 200)
const QUIET := 10  # ticks
const SOON := 3  # ticks in which a body is found, read, and bends grass


func add_floor() -> StaticBody3D:
	var slab := box(Vector3(400, 1, 400))
	return add_body(StaticBody3D.new(), slab, Vector3(0, -0.5, 0))


## Fields in rows, so near that their boxes overlap.
func add_fields(count: int) -> Array[GrassField]:
	var fields: Array[GrassField] = []
	for i in count:
		fields.append(add_field({size = Vector2(2, 2), position = Vector3(4 * (i % 16), 0, 4 * (i / 16))}))
	return fields


func total(fields: Array[GrassField], counter: String) -> int:
	var sum := 0
	for field in fields:
		sum += field.get_counters()[counter]
	return sum


## Waits until the fields have rested for some ticks.
func rested(fields: Array[GrassField]) -> void:
	var state := {visits = -1, quiet = 0}
	var rest := func() -> bool:
		var visits := total(fields, "visited_ticks") + total(fields, "visited_frames")
		state.quiet = state.quiet + 1 if visits == state.visits else 0
		state.visits = visits
		return state.quiet > QUIET
	await wait_until(rest, "the fields rest", true)


## Returns whether the field is visited within some ticks.
func stirs(field: GrassField, count := SOON) -> bool:
	var before: int = field.get_counters().visited_ticks
	await ticks(count)
	return field.get_counters().visited_ticks > before


## Adds a resting field on a floor.
func add_resting_field(properties := {}) -> GrassField:
	add_floor()
	var field := add_field(properties)
	await rested([field])
	return field


## The engine makes one call a tick and one a frame for all fields, and all fields together read a floor once.
func test_nothing_is_called_for_fields_at_rest() -> void:
	add_floor()
	for count: int in [1, 64, 200]:
		var fields := add_fields(count)
		await rested(fields)
		var listeners := get_tree().physics_frame.get_connections().size() + get_tree().process_frame.get_connections().size()
		var before := {}
		for key: String in ["visited_ticks", "visited_frames", "body_reads", "shape_reads", "engine_calls", "wind_updates"]:
			before[key] = total(fields, key)
		await ticks(20)
		for key: String in before:
			var reads := 20 * 3 if key == "engine_calls" else 0  # that it exists, is in the tree, and where it is
			assert_eq(total(fields, key) - before[key], reads, "%s of %d fields" % [key, count])
		for field in fields:
			assert_false(field.is_processing_internal() or field.is_physics_processing_internal())
			field.free()
		assert_less(listeners, 8, "of the tree's ticks and frames")


func areas_of(fields: Array[GrassField]) -> int:
	await rested(fields)
	return fields[0].get_counters().areas


func test_fields_side_by_side_share_areas() -> void:
	var fields := add_fields(64)
	assert_eq(await areas_of(fields), 1, "64 side by side")
	for field in fields:
		field.free()
	fields = [add_field(), add_field({position = FAR}), add_field({position = -FAR})]
	assert_eq(await areas_of(fields), 3, "between them lie bodies of others")
	fields.append(add_field({position = FAR + Vector3(5, 0, 0)}))
	assert_eq(await areas_of(fields), 3)
	fields.append(add_field({collision_mask = 2}))
	assert_eq(await areas_of(fields), 4, "other bodies")
	for field in fields.slice(1):
		field.free()
	assert_eq(await areas_of([fields[0]]), 1)


## Fields that share an area know the same bodies as fields alone, however the area changes meanwhile.
func test_bodies_are_known_while_neighbours_come_and_go() -> void:
	add_floor()
	var field := add_field()
	add_held_body(ball(0.2), MIDDLE)
	add_held_body(ball(0.2), MIDDLE + Vector3(0, 0.1, 0))
	await ticks(SOON)
	assert_eq(field.get_body_count(), 3)
	var others: Array[GrassField] = []
	for i in 12:
		others.append(add_field({position = Vector3(6 * (i % 3) - 6, 0, 6 * (i / 3) - 6), collision_mask = 1 + 2 * int(i == 11)}))
		await ticks(1)
		assert_eq(field.get_body_count(), 3, "%d come" % i)
		if i % 3 == 2:
			others.pop_at(1).free()
			await ticks(1)
			assert_eq(field.get_body_count(), 3, "%d gone" % i)
	assert_eq(field.get_counters().areas, 2)
	for other in others:
		other.position.y += 0.5
	await ticks(SOON)
	assert_eq(field.get_body_count(), 3, "they moved")
	assert_eq(field.get_counters().areas, 1 + others.size(), "who moves has its own")
	for other in others:
		other.position.x += 50.0
	field.position.x += 0.5
	await ticks(SOON)
	assert_eq(field.get_body_count(), 3, "all have moved")
	for other in others:
		assert_eq(other.get_body_count(), 1, "the floor")
	for other in others:
		other.free()
	field.collision_mask = 4
	await ticks(SOON)
	assert_eq(field.get_body_count(), 0)
	field.collision_mask = 1
	await ticks(SOON)
	assert_eq(field.get_body_count(), 3)
	assert_eq(field.get_counters().areas, 1)


## All fields that leave at once are told what left with them.
func test_a_world_that_shifts_keeps_its_bodies() -> void:
	var floor_ := add_floor()
	var fields := add_fields(9)
	var body := add_held_body(ball(0.2), MIDDLE)
	await ticks(SOON)
	for round_ in 3:
		for node: Node3D in fields + [floor_, body]:
			node.position += Vector3(100, 0, 0)
		await ticks(10)
		assert_eq(fields[0].get_body_count(), 2)
		assert_eq(fields[8].get_body_count(), 1)
		assert_eq(fields[0].get_counters().areas, 1)
	body.free()
	fields[8].free()
	await ticks(SOON)
	assert_eq(fields[0].get_body_count(), 1)


func test_a_body_stirs_only_the_fields_that_it_is_near() -> void:
	add_floor()
	var fields := add_fields(32)
	await rested(fields)
	var before: Array[int] = []
	for field in fields:
		before.append(field.get_counters().visited_ticks)
	var body := add_held_body(ball(0.2), MIDDLE)
	await ticks(SOON)
	for i in fields.size():
		var away := maxf(absf(fields[i].position.x), absf(fields[i].position.z))
		var visits: int = fields[i].get_counters().visited_ticks - before[i]
		if away < 5.0:
			assert_greater(visits, 0, fields[i].name)
		elif away > 9.0:
			assert_eq(visits, 0, fields[i].name)
	assert_greater(fields[0].get_awake_tile_count(), 0)
	body.free()
	await rested(fields)
	assert_eq(fields[0].get_awake_tile_count(), 0)


func test_a_body_on_a_border_bends_both_fields() -> void:
	add_floor()
	var fields: Array[GrassField] = [add_field(), add_field({position = Vector3(4, 0, 0)}), add_field({position = Vector3(0, 0, 4)})]
	await rested(fields)
	add_held_body(ball(0.4), Vector3(2, 0.2, 2))
	await seen()
	for field in fields:
		assert_eq(field.get_counters().colliders, 1, "once each")
		assert_greater(field.get_awake_tile_count(), 0)


func test_ground_that_a_script_moves_is_noticed() -> void:
	var field := await add_resting_field()
	var wall := add_body(StaticBody3D.new(), ball(0.3), MIDDLE)
	await rested([field])
	assert_eq(field.get_awake_tile_count(), 0, "it is ground")
	for i in 10:
		wall.position.x += 0.02
		await ticks(1)
	assert_greater(field.get_awake_tile_count(), 0)
	await rested([field])  # it is ground there, too


func test_a_body_of_the_server_alone_is_noticed() -> void:
	var field := await add_resting_field()
	var shape := ball(0.3)
	var body := PhysicsServer3D.body_create()
	PhysicsServer3D.body_set_mode(body, PhysicsServer3D.BODY_MODE_STATIC)
	PhysicsServer3D.body_add_shape(body, shape.get_rid())
	PhysicsServer3D.body_set_state(body, PhysicsServer3D.BODY_STATE_TRANSFORM, Transform3D(Basis(), MIDDLE))
	PhysicsServer3D.body_set_space(body, get_world_3d().space)
	await rested([field])
	for i in 10:
		PhysicsServer3D.body_set_state(body, PhysicsServer3D.BODY_STATE_TRANSFORM, Transform3D(Basis(), MIDDLE + Vector3(0.02 * i, 0, 0)))
		await ticks(1)
	await ticks(1)
	assert_greater(field.get_awake_tile_count(), 0)
	PhysicsServer3D.free_rid(body)


func test_a_fast_body_is_noticed_on_its_way() -> void:
	var field := await add_resting_field()
	var body := RigidBody3D.new()
	body.gravity_scale = 0.0
	body.linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	body.linear_damp = 0.0
	add_body(body, ball(0.2), Vector3(-30, 0.3, 0.25))
	body.linear_velocity = Vector3(290, 0, 0)
	var awake := 0
	for i in 20:
		await ticks(1)
		awake = maxi(awake, field.get_awake_tile_count())
	assert_greater(awake, 4, "its way is swept")


func test_what_scripts_do_stirs() -> void:
	var field := await add_resting_field({map = full_map()})
	var node := Node3D.new()
	add_child(node)
	var acts: Dictionary[String, Callable] = {
		"push()": func() -> void: field.push(MIDDLE, Vector3(3, 0, 0), 1.0, 0.1),
		"blast()": func() -> void: field.blast(MIDDLE, 3.0, 1.0, 0.1),
		"register_collider()": func() -> void: field.register_collider(node, ball(0.2)),
		"unregister_collider()": func() -> void: field.unregister_collider(node),
		"its place": func() -> void: field.position.y += 0.1,
		"its map": func() -> void: field.map.stroke(brush(GrassBrush.TOOL_ERASE, 0.5), Vector2.ZERO, Vector2.ZERO),
		"a property": func() -> void: field.sleep_delay = 7.0,
		"another size": func() -> void: field.size = Vector2(6, 6),
		"regrowth": func() -> void: field.regrowth = 10.0,
		"no regrowth": func() -> void: field.regrowth = 0.0,
	}
	for act in acts:
		acts[act].call()
		assert_true(await stirs(field), act)
		if act not in ["register_collider()", "regrowth"]:
			await rested([field])


## The box in which it watches follows.
func test_bodies_on_ground_that_was_laid_later_are_noticed() -> void:
	var field := await add_resting_field()
	var slab := box(Vector3(40, 1, 40))
	add_body(StaticBody3D.new(), slab, Vector3(0, 11.5, 0))
	await ticks(SOON)
	assert_greater(field.bake_ground(), 0)
	await rested([field])
	add_held_body(ball(0.2), Vector3(0.25, 12.2, 0.25))
	await ticks(SOON)
	assert_greater(field.get_awake_tile_count(), 0)


func test_movers_that_no_area_reports_stir_where_they_are() -> void:
	var field := await add_resting_field()
	var force := GrassForce3D.new()
	force.kind = GrassForce3D.KIND_WIND
	force.radius = 2.0
	force.position = FAR
	add_child(force)
	assert_false(await stirs(field), "a force far away")
	force.position = MIDDLE
	await ticks(SOON)
	assert_greater(field.get_awake_tile_count(), 0)
	force.free()
	await rested([field])
	var skeleton := Skeleton3D.new()
	for i in 2:
		skeleton.add_bone("bone %d" % i)
	skeleton.set_bone_parent(1, 0)
	skeleton.set_bone_pose_position(1, Vector3(0.5, 0, 0))
	var bones := GrassBoneColliders3D.new()
	skeleton.add_child(bones)
	skeleton.position = FAR
	add_child(skeleton)
	assert_false(await stirs(field), "a skeleton far away")
	skeleton.position = MIDDLE
	await ticks(SOON)
	assert_greater(field.get_awake_tile_count(), 0)


func test_an_area_stirs_once_it_blows() -> void:
	var field := await add_resting_field()
	var area := Area3D.new()
	add_shape_to_area(area, ball(2.0))
	var source := Node3D.new()
	area.add_child(source)
	add_child(area)
	area.wind_source_path = area.get_path_to(source)
	await rested([field])
	area.wind_force_magnitude = 10.0
	await ticks(20)
	assert_greater(field.get_awake_tile_count(), 0)


func add_shape_to_area(area: Area3D, shape: Shape3D) -> void:
	var node := CollisionShape3D.new()
	node.shape = shape
	area.add_child(node)


func test_a_sleeping_body_that_is_moved_or_woken_is_noticed() -> void:
	var field := await add_resting_field()
	var body := add_body(RigidBody3D.new(), box(Vector3(0.4, 0.4, 0.4)), Vector3(4.5, 0.2, 0)) as RigidBody3D
	await wait_until(func() -> bool: return body.sleeping, "the body sleeps", true)
	await rested([field])
	body.apply_central_impulse(Vector3(-8, 0, 0))
	await ticks(30)
	assert_greater(field.get_awake_tile_count(), 0)


func test_a_paused_tree_visits_nothing() -> void:
	var field := await add_resting_field()
	get_tree().paused = true
	process_mode = Node.PROCESS_MODE_ALWAYS
	field.process_mode = Node.PROCESS_MODE_PAUSABLE
	field.push(MIDDLE, Vector3(3, 0, 0), 1.0, 0.1)
	assert_false(await stirs(field, 5))
	get_tree().paused = false
	assert_true(await stirs(field))


func test_bodies_of_another_world_stir_nothing() -> void:
	var field := await add_resting_field()
	var other := SubViewport.new()
	other.own_world_3d = true
	add_child(other)
	var there := GrassField.new()
	there.size = Vector2(4, 4)
	other.add_child(there)
	await rested([field, there])
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	add_shape(body, ball(0.2))
	body.position = MIDDLE
	var before: int = field.get_counters().visited_ticks
	other.add_child(body)
	await ticks(SOON)
	assert_greater(there.get_awake_tile_count(), 0)
	assert_eq(field.get_counters().visited_ticks, before)


func test_a_field_that_leaves_and_enters_rests_again() -> void:
	var field := await add_resting_field()
	remove_child(field)
	await ticks(2)
	add_child(field)
	await rested([field])
	add_held_body(ball(0.2), MIDDLE)
	await ticks(SOON)
	assert_greater(field.get_awake_tile_count(), 0)

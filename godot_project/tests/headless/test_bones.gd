# SPDX-License-Identifier: MIT
## A skeleton without physics bends grass with capsules along its bones.
extends "res://tests/field_case.gd"


## Hip, knee and ankle above each other, 0.4 m apart; the last bone has no length.
func add_leg(place: Vector3, properties := {}) -> Skeleton3D:
	var skeleton := Skeleton3D.new()
	for name: String in ["Hip", "Knee", "Ankle"]:
		var index := skeleton.add_bone(name)
		if index > 0:
			skeleton.set_bone_parent(index, index - 1)
			skeleton.set_bone_rest(index, Transform3D(Basis(), Vector3(0, -0.4, 0)))
	skeleton.set_bone_rest(0, Transform3D(Basis(), Vector3(0, 0.85, 0)))
	skeleton.reset_bone_poses()
	skeleton.position = place
	var bones := GrassBoneColliders3D.new()
	for property: String in properties:
		bones.set(property, properties[property])
	skeleton.add_child(bones)
	add_child(skeleton)
	return skeleton


func test_bones_bend_grass_as_they_swing() -> void:
	var field := add_field()
	var entered := []
	field.body_entered_grass.connect(entered.append)
	var leg := add_leg(Vector3(0.25, 0, 0.25))
	await ticks(3)
	assert_true(field.is_tile_awake(field.get_tile_at(leg.position)))
	assert_eq(field.get_counters().colliders, 2, "thigh and shin")
	assert_eq(field.get_counters().bones, 2)
	assert_eq(entered, [leg.get_child(0)])
	var tile := field.get_tile_at(Vector3(0.25, 0, 0.75))
	var rest := tile_knots(field, tile)
	for step in 20:  # the leg swings towards +z
		leg.set_bone_pose_rotation(0, Quaternion(Vector3.RIGHT, -0.06 * step))
		await ticks(1)
	assert_greater(farthest(tile_knots(field, tile), rest), 0.1, "metres: the foot has passed through")
	leg.free()
	await ticks(1)
	assert_eq(field.get_counters().bones, 0)
	await ticks_to_sleep(field)


func test_which_bones_bend() -> void:
	var field := add_field()
	var leg := add_leg(Vector3(0.25, 0, 0.25), {bones = PackedStringArray(["Knee"])})
	var bones: GrassBoneColliders3D = leg.get_child(0)
	await ticks(3)
	assert_eq(field.get_counters().colliders, 1, "the shin")
	bones.length_min = 0.5
	await ticks(2)
	assert_eq(field.get_counters().colliders, 0, "too short")
	bones.length_min = 0.1
	bones.enabled = false
	await ticks(2)
	assert_eq(field.get_counters().colliders, 0)
	bones.enabled = true
	bones.bones = PackedStringArray(["Tail"])
	await ticks(2)
	assert_eq(field.get_counters().colliders, 0, "no such bone")


func test_without_a_skeleton_it_bends_nothing() -> void:
	var field := add_field()
	var bones := GrassBoneColliders3D.new()
	add_child(bones)
	await ticks(3)
	assert_eq(field.get_counters().colliders, 0)


func test_a_skeleton_that_is_put_elsewhere_leaves_the_grass_between_alone() -> void:
	var field := add_field({size = Vector2(12, 4)})
	var leg := add_leg(Vector3(-5, 0, 0.25))
	await ticks(5)
	leg.position.x = 5
	await ticks(3)
	assert_false(field.is_tile_awake(field.get_tile_at(Vector3(0, 0, 0.25))))
	assert_true(field.is_tile_awake(field.get_tile_at(leg.position)))


func add_chain(place: Vector3, count: int) -> Skeleton3D:
	var skeleton := Skeleton3D.new()
	for i in count:
		skeleton.add_bone("Bone%d" % i)
		if i > 0:
			skeleton.set_bone_parent(i, i - 1)
			skeleton.set_bone_rest(i, Transform3D(Basis(), Vector3(0.2, 0, 0)))
	skeleton.reset_bone_poses()
	skeleton.position = place
	skeleton.add_child(GrassBoneColliders3D.new())
	add_child(skeleton)
	return skeleton


func calls_of(fields: Array[GrassField], count: int) -> int:
	var before := 0
	for field in fields:
		before -= field.get_counters().engine_calls
	await ticks(count)
	for field in fields:
		before += field.get_counters().engine_calls
	return before


## A bone is asked for its parent and its pose; the node whether it is in the tree, for its skeleton, and that for its place and how many
## bones it has.
func test_each_bone_near_the_grass_is_counted() -> void:
	var field := add_field()
	var chain := add_chain(Vector3(0, 0.2, 0), 11)
	await ticks(5)
	assert_eq(field.get_counters().bones, 10)
	var before := field.get_counters()
	await ticks(40)
	var after_ := field.get_counters()
	assert_eq(after_.engine_calls - before.engine_calls, 40 * (4 + 2 * 11))
	assert_eq(after_.body_reads - before.body_reads, 40 * 10)
	(chain.get_child(0) as GrassBoneColliders3D).bones = PackedStringArray(["Bone3", "Bone4"])
	await ticks(5)
	assert_eq(field.get_counters().bones, 2)
	# Ten of them have a parent whose name counts, and three poses are needed.
	assert_eq(await calls_of([field], 40), 40 * (4 + 11 + 10 + 3))


## They are looked at in every eighth tick, and their skeleton's place in each, once for all fields.
func test_skeletons_far_away_cost_next_to_nothing() -> void:
	var fields: Array[GrassField] = []
	for i in 4:
		fields.append(add_field({position = Vector3(8 * i, 0, 0)}))
	for i in 5:
		add_chain(Vector3(1400, 0.2, 3 * i), 60)
	await ticks(10)
	assert_eq(fields[0].get_counters().bones, 0)
	assert_eq(await calls_of(fields, 80), 5 * (80 * 3 + 80 / 8 * (1 + 2 * 60)))


func test_fields_share_what_is_read() -> void:
	var fields: Array[GrassField] = []
	for i in 4:
		fields.append(add_field({position = Vector3(2 * i, 0, 0)}))
	add_chain(Vector3(0, 0.2, 0), 60)
	await ticks(10)
	for field in fields:
		assert_eq(field.get_counters().bones, 59)
	assert_eq(await calls_of(fields, 40), 40 * (4 + 2 * 60))


func test_who_comes_from_afar_bends_grass_at_once() -> void:
	var field := add_field()
	var chain := add_chain(Vector3(1400, 0.2, 0), 6)
	await ticks(10)
	chain.position.x = 0.0
	await ticks(2)
	assert_eq(field.get_counters().bones, 5, "a skeleton")
	chain.position.x = 1400.0
	await ticks(10)
	assert_eq(field.get_counters().bones, 0)
	chain.set_bone_pose_position(0, Vector3(-1400, 0, 0))
	await ticks(10)
	assert_eq(field.get_counters().bones, 5, "its bones alone: within eight ticks")


## Fields share what was read of a skeleton in a tick, and a listener of one of them may free it before the next one reads.
func test_a_listener_of_one_field_frees_the_skeleton_that_the_next_one_reads() -> void:
	var first := add_field()
	var second := add_field({position = Vector3(50, 0, 0)})
	var leg := add_leg(Vector3(50.25, 0, 0.25))
	var bones: GrassBoneColliders3D = leg.get_child(0)
	bones.reparent(self)
	bones.skeleton = bones.get_path_to(leg)
	await ticks(3)
	assert_eq(second.get_counters().bones, 2)
	first.body_entered_grass.connect(leg.free.unbind(1), CONNECT_ONE_SHOT)
	add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	var held := [leg]  # a lambda may hold no freed object
	await wait_until(func() -> bool: return not is_instance_valid(held[0]), "the skeleton is freed", true)
	assert_eq(second.get_counters().bones, 0, "in the same tick")

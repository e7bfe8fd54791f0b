# SPDX-License-Identifier: MIT
## Grass on moving ground: a raft that carries a field is its ground and wakes nothing, however it moves; other bodies aboard bend the
## grass.
extends "res://tests/field_case.gd"

const RAFTS: Array[String] = ["synced", "animatable", "rigid", "frozen", "character", "static"]
## Those that move with a parent: rigid and synced bodies stay where they are in the world.
const PARTS: Array[String] = ["animatable", "frozen", "character", "static"]
const SIDE := 12.0  # metres, of the raft and its lawn


## Adds a raft with its top at y = 0, at `place`.
func add_raft(kind: String, parent: Node, place := Vector3.ZERO) -> PhysicsBody3D:
	var raft: PhysicsBody3D
	match kind:
		"rigid", "frozen":
			raft = RigidBody3D.new()
			raft.gravity_scale = 0.0
			raft.linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
			raft.angular_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
			raft.can_sleep = false
			raft.mass = 1e5
			raft.freeze = kind == "frozen"
			raft.freeze_mode = RigidBody3D.FREEZE_MODE_KINEMATIC
		"character":
			raft = CharacterBody3D.new()
			raft.motion_mode = CharacterBody3D.MOTION_MODE_FLOATING
		"synced", "animatable":
			raft = AnimatableBody3D.new()
			raft.sync_to_physics = kind == "synced"
		"static":
			raft = StaticBody3D.new()
	var deck := box(Vector3(SIDE, 1, SIDE))
	add_shape(raft, deck, Transform3D(Basis(), Vector3(0, -0.5, 0)))
	raft.position = place
	parent.add_child(raft)
	return raft


## Tick `tick` of a voyage at 6 m/s that turns and bobs.
func sail(raft: Node3D, kind: String, tick: int) -> void:
	var time := tick / 60.0
	var velocity := Vector3(6.0 * sin(time), 0.8 * cos(3.0 * time), 6.0)
	if kind == "rigid":
		raft.linear_velocity = velocity
		raft.angular_velocity = Vector3(0.05 * sin(2.0 * time), 0.4, 0.0)
	elif kind == "character":
		raft.velocity = velocity
		raft.rotation.y += 0.4 / 60.0
		raft.move_and_slide()
	else:
		raft.transform = Transform3D(Basis(Vector3.UP, 0.4 / 60.0) * raft.basis, raft.position + velocity / 60.0)


func add_lawn(parent: Node, properties := {}) -> GrassField:
	var field := GrassField.new()
	field.size = Vector2(SIDE, SIDE)
	field.density = 256.0
	for property: String in properties:
		field.set(property, properties[property])
	parent.add_child(field)
	return field


func test_a_raft_wakes_nothing() -> void:
	for kind in RAFTS:
		var raft := add_raft(kind, self)
		var field := add_lawn(raft)
		await ticks(10)
		var most := field.get_awake_tile_count()
		for i in 90:
			sail(raft, kind, i)
			await ticks(1)
			most = maxi(most, field.get_awake_tile_count())
		assert_greater(raft.position.length(), 6.0, "%s: it sails" % kind)
		assert_greater(field.get_body_count(), 0, "%s: it is seen" % kind)
		assert_eq(most, 0, "%s: tiles awake at once" % kind)
		assert_eq(field.get_counters().woken, 0, kind)
		assert_eq(field.get_counters().body_reads, 0, kind)
		raft.free()


func test_a_raft_beside_the_field_wakes_nothing() -> void:
	for kind in PARTS:
		var ship := Node3D.new()
		add_child(ship)
		add_raft(kind, ship)
		var field := add_lawn(ship)
		await ticks(10)
		for i in 90:
			sail(ship, "", i)
			await ticks(1)
		assert_greater(field.get_body_count(), 0, "%s: it is seen" % kind)
		assert_eq(field.get_counters().woken, 0, kind)
		ship.free()


## A house on an island that a script moves is as much a wall as before.
func test_a_house_on_an_island_bends_nothing() -> void:
	var island := Node3D.new()
	add_child(island)
	add_raft("static", island)
	var field := add_lawn(island)
	var house := StaticBody3D.new()
	var walls := box(Vector3(3, 3, 3))
	add_shape(house, walls, Transform3D(Basis(), Vector3(2, 1, 2)))
	island.add_child(house)
	await ticks(10)
	for i in 90:
		sail(island, "", i)
		await ticks(1)
	assert_greater(field.get_body_count(), 1, "it is seen")
	assert_eq(field.get_counters().woken, 0)


## The wheels of a truck that carries a lawn are part of it.
func test_a_truck_with_a_lawn_wakes_nothing() -> void:
	add_body(StaticBody3D.new(), WorldBoundaryShape3D.new(), Vector3(0, -1.6, 0))
	var truck := VehicleBody3D.new()
	var bed := box(Vector3(4, 0.5, 6))
	add_shape(truck, bed, Transform3D(Basis(), Vector3(0, -0.25, 0)))
	truck.mass = 500.0
	for place: Vector3 in [Vector3(-1.8, -0.6, 2), Vector3(1.8, -0.6, 2), Vector3(-1.8, -0.6, -2), Vector3(1.8, -0.6, -2)]:
		var wheel := VehicleWheel3D.new()
		wheel.position = place
		wheel.wheel_radius = 0.7
		wheel.use_as_traction = true
		truck.add_child(wheel)
	add_child(truck)
	var field := add_lawn(truck, {size = Vector2(4, 6)})
	await ticks(30)
	truck.engine_force = 800.0
	await ticks(90)
	assert_greater(truck.position.length(), 1.0, "it drives")
	assert_eq(field.get_counters().wheels, 0)
	assert_eq(field.get_counters().woken, 0)


## A body on board that stands, for all that is done to it, where the raft takes it.
func test_who_is_aboard_bends_the_grass() -> void:
	for kind: String in ["synced", "animatable", "rigid"]:
		var raft := add_raft(kind, self)
		var field := add_lawn(raft)
		var crate := add_held_body(ball(0.3), Vector3.ZERO)
		remove_child(crate)
		crate.position = Vector3(2.1, 0.25, 1.1)
		raft.add_child(crate)
		var roller := add_body(RigidBody3D.new(), ball(0.3), Vector3(-2.1, 0.35, -1.1)) as RigidBody3D
		roller.lock_rotation = true  # else it stays behind
		var walker := CharacterBody3D.new()
		var shape := CapsuleShape3D.new()
		shape.radius = 0.25
		shape.height = 1.2
		add_body(walker, shape, Vector3(0, 0.65, 3))
		await ticks(10)
		for i in 60:
			sail(raft, kind, i)
			walker.velocity.y -= 9.8 / 60.0
			walker.velocity.x = -0.5
			walker.move_and_slide()
			await ticks(1)
		var at_crate := raft.to_global(Vector3(2.1, 0, 1.1))
		assert_true(field.is_tile_awake(field.get_tile_at(at_crate)), "%s: below the crate" % kind)
		assert_less(field.get_bend_at(at_crate).y, -0.1, "%s: the crate presses it" % kind)
		assert_true(field.is_tile_awake(field.get_tile_at(roller.position)), "%s: below the ball" % kind)
		assert_true(field.is_tile_awake(field.get_tile_at(walker.position)), "%s: below the walker" % kind)
		assert_less(field.get_awake_tile_count(), 250, "%s: and their wakes" % kind)
		for body: Node in [crate, roller, walker]:
			body.free()
		for i in 900:
			sail(raft, kind, i)
			await ticks(1)
			if field.get_awake_tile_count() == 0:
				break
		assert_eq(field.get_awake_tile_count(), 0, "%s: alone" % kind)
		raft.free()


## 60 x 60 m of it were 14,400 tiles, and the pool has 4,096.
func test_an_island_leaves_the_pool_to_others() -> void:
	var island := add_raft("animatable", self)
	(island.get_child(0).get("shape") as BoxShape3D).size = Vector3(60, 1, 60)
	var field := add_lawn(island, {size = Vector2(60, 60)})
	var body := add_held_body(ball(0.3), Vector3(0, 0.2, 0))
	remove_child(body)
	body.position = Vector3(20.1, 0.2, 20.1)
	island.add_child(body)
	await ticks(20)
	for i in 30:
		sail(island, "animatable", i)
		await ticks(1)
	assert_true(field.is_tile_awake(field.get_tile_at(island.to_global(Vector3(20.1, 0, 20.1)))))
	assert_less(field.get_awake_tile_count(), 40)
	assert_eq(field.get_statistics().refused, 0)


## A field that is taken from one raft to another one belongs to that.
func test_a_field_changes_its_raft() -> void:
	var raft := add_raft("animatable", self)
	var other := add_raft("animatable", self, Vector3(0, 0, 40))
	var field := add_lawn(raft)
	await ticks(10)
	raft.remove_child(field)
	other.add_child(field)
	raft.position = Vector3(0, 0.7, 40)  # now a lid upon the grass
	await ticks(10)
	assert_greater(field.get_awake_tile_count(), 100)


func test_rays_for_the_ground_meet_what_carries_the_field() -> void:
	for kind: String in ["animatable", "rigid", "character"]:
		var raft := add_raft(kind, self)
		var field := add_lawn(raft, {position = Vector3(0, 0.4, 0), size = Vector2(4, 4)})
		add_body(AnimatableBody3D.new(), ball(1.0), Vector3(0, 2, 0))
		await ticks(3)
		assert_greater(field.bake_ground(), 15, kind)
		await grown(field)
		assert_near(field.get_knots(Vector2i(4, 4), 10)[0].y, raft.position.y, 0.01, kind)
		raft.free()

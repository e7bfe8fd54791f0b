# SPDX-License-Identifier: MIT
## CPU time of a field, stage by stage, against its tiles and the bodies that move in it. It must not grow with the field. Bodies float to
## and fro among the blades and never meet each other, so that physics has little to do.
extends Node3D

const Scenery := preload("res://bench/scenery.gd")

const CROWD := 70.0  # metres: the bodies stay together on any field
const SIZES: Array[float] = [70.5, 500.0, 2000.0]  # metres: 20 thousand, 1 million, 16 million tiles
const BODIES: Array[int] = [0, 128, 1024, 5000]
const WARM_UP := 120  # ticks, so that tiles fall asleep as others wake
const TICKS := 240
const SOFTWARE := 0.2  # share of these ticks where blades are solved in software: seconds a tick; they are not drawn there
const STAGES: Array[String] = ["gather_ms", "tiles_ms", "upload_ms", "frame_ms"]
const COUNTS: Array[String] = ["body_reads", "shape_reads", "engine_calls", "tiles_looked_at", "uploaded_bytes", "steps", "culls"]  # a tick


func run(p_software: bool) -> Array[PackedStringArray]:
	var header: PackedStringArray = ["tiles", "bodies", "awake_tiles"]
	for stage in STAGES:
		header.append_array([stage, stage + "_p95"])
	header.append_array(COUNTS.map(func(p_name: String) -> String: return p_name + "_a_tick"))
	header.append("build_ms")
	var rows: Array[PackedStringArray] = [header]
	get_viewport().disable_3d = p_software
	for bodies: int in BODIES:
		for size: float in SIZES:
			rows.append(await _measure(size, bodies, SOFTWARE if p_software else 1.0))
			print(", ".join(rows[-1]))
	get_viewport().disable_3d = false
	return rows


func _measure(p_size: float, p_bodies: int, p_share: float) -> PackedStringArray:
	var field := GrassField.new()
	field.simulation_detail = GrassField.SIMULATION_WHOLE
	field.size = Vector2(p_size, p_size)
	add_child(field)
	var camera := Camera3D.new()
	camera.position = Vector3(0.0, CROWD, 0.0)  # sees all of the crowd: nothing of it is left out
	camera.rotation_degrees.x = -90.0
	add_child(camera)
	await Scenery.compiled(field)
	var bodies: Array[RigidBody3D] = []
	for i in p_bodies:
		bodies.append(_add_body(i))
	var times: Dictionary[String, Array] = {}
	var before := {}
	var ticks := roundi(p_share * TICKS)
	var warm_up := roundi(p_share * WARM_UP)
	for tick in warm_up + ticks:
		await get_tree().physics_frame
		_turn_back(bodies)
		if tick == warm_up:
			before = field.get_statistics().merged(field.get_counters())
		if tick >= warm_up:
			var now := field.get_statistics().merged(field.get_counters())
			for stage in STAGES:
				times.get_or_add(stage, []).append(now[stage])
	var after := field.get_statistics().merged(field.get_counters())
	var row: PackedStringArray = [str(field.get_grid_size().x * field.get_grid_size().y), str(p_bodies), str(after.awake_tiles)]
	for stage in STAGES:
		times[stage].sort()
		row.append_array(["%.4f" % times[stage][times[stage].size() >> 1], "%.4f" % times[stage][times[stage].size() * 95 / 100]])
	for count in COUNTS:
		row.append("%.1f" % (float(after[count] - before[count]) / ticks))
	row.append("%.2f" % after.build_ms)
	for body in bodies:
		body.queue_free()
	field.queue_free()
	camera.queue_free()
	await get_tree().process_frame
	return row


func _add_body(p_index: int) -> RigidBody3D:
	var body := RigidBody3D.new()
	var shape := CollisionShape3D.new()
	match p_index % 4:
		0:
			shape.shape = SphereShape3D.new()
			shape.shape.radius = 0.25
		1:
			shape.shape = BoxShape3D.new()
			shape.shape.size = Vector3(0.5, 0.3, 0.4)
		2:
			shape.shape = CapsuleShape3D.new()
			shape.shape.radius = 0.15
			shape.shape.height = 0.6
		3:
			shape.shape = CylinderShape3D.new()
			shape.shape.radius = 0.2
			shape.shape.height = 0.4
	body.add_child(shape)
	body.gravity_scale = 0.0
	body.linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	body.angular_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	body.collision_mask = 0
	body.can_sleep = false
	body.position = Vector3(fmod(p_index * 0.618034, 1.0) - 0.5, 0.0, fmod(p_index * 0.754878, 1.0) - 0.5) * CROWD + Vector3(0.0, 0.3, 0.0)
	body.linear_velocity = Vector3.RIGHT.rotated(Vector3.UP, 2.4 * p_index) * (1.0 + p_index % 5)
	body.angular_velocity = Vector3(0.3, 1.0, 0.2)
	add_child(body)
	return body


func _turn_back(p_bodies: Array[RigidBody3D]) -> void:
	for body in p_bodies:
		var flat := Vector2(body.position.x, body.position.z)
		if maxf(absf(flat.x), absf(flat.y)) > 0.5 * CROWD and flat.dot(Vector2(body.linear_velocity.x, body.linear_velocity.z)) > 0.0:
			body.linear_velocity = -body.linear_velocity

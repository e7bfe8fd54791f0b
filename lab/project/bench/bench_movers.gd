# SPDX-License-Identifier: MIT
## The cost of each kind of mover in a tick: its parts, the reads that it needs, the tiles that it wakes. One of each moves to and fro in a
## meadow.
extends Node3D

const Scenery := preload("res://bench/scenery.gd")
const Measure := preload("res://bench/measure.gd")
const MOVERS: Array[String] = ["none", "ball", "vehicle", "skeleton", "soft_body", "trimesh", "height_map", "node"]
const SIDE := 24.0  # metres
const WAY := 4.0  # metres to each side
const SPEED := 2.0  # m/s
const WHEELS: Array[Vector3] = [Vector3(0.8, 0, 1.2), Vector3(-0.8, 0, 1.2), Vector3(0.8, 0, -1.2), Vector3(-0.8, 0, -1.2)]
const BONES := 20
const WARM_UP := 120  # ticks: meshes are split, grass wakes and sleeps again
const TICKS := 240
const SOFTWARE := 0.2  # share of these ticks where blades are solved in software
const TIMES: Array[String] = ["gather_ms", "tiles_ms", "upload_ms", "simulate_ms"]
const PARTS: Array[String] = ["wheels", "bones", "soft_bodies", "mesh_pieces", "colliders", "awake_tiles"]  # medians
const COUNTS: Array[String] = ["body_reads", "shape_reads", "engine_calls", "tiles_looked_at", "tile_steps"]  # a tick


func run(p_software: bool) -> Array[PackedStringArray]:
	var header: PackedStringArray = ["mover"]
	header.append_array(PARTS)
	header.append_array(COUNTS.map(func(p_name: String) -> String: return p_name + "_a_tick"))
	header.append_array(TIMES)
	var rows: Array[PackedStringArray] = [header]
	get_viewport().disable_3d = p_software
	for mover in MOVERS:
		rows.append(await _measure(mover, SOFTWARE if p_software else 1.0))
		print(", ".join(rows[-1]))
	get_viewport().disable_3d = false
	return rows


func _measure(p_mover: String, p_share: float) -> PackedStringArray:
	var field := GrassField.new()
	field.simulation_detail = GrassField.SIMULATION_WHOLE
	field.size = Vector2.ONE * SIDE
	field.measure_time = true
	var camera := Camera3D.new()
	camera.position.y = SIDE
	camera.rotation_degrees.x = -90.0
	var mover := _make(p_mover, field)
	for node: Node3D in [field, camera, mover]:
		add_child(node)
	await Scenery.compiled(field)
	var warm_up := roundi(p_share * WARM_UP)
	var values := {}
	for name in PARTS + TIMES:
		values[name] = [] as Array[float]
	var before := {}
	var ticks := roundi(p_share * TICKS)
	for tick in warm_up + ticks:
		mover.position.x += _place(tick / 60.0) - _place((tick - 1) / 60.0)  # a soft body's own position is always zero
		await get_tree().physics_frame
		var now := field.get_statistics().merged(field.get_counters())
		if tick == warm_up:
			before = now
		if tick >= warm_up:
			for name in PARTS + TIMES:
				values[name].append(float(now[name]) if now.awake_tiles > 0 or name.begins_with("gather") else 0.0)
	var after := field.get_statistics().merged(field.get_counters())
	for node: Node3D in [field, camera, mover]:
		node.queue_free()
	await get_tree().process_frame
	var row := PackedStringArray([p_mover])
	for name in PARTS:
		row.append("%d" % Measure.median(values[name]))
	for name in COUNTS:
		row.append("%.1f" % (float(after[name] - before[name]) / ticks))
	for name in TIMES:  # on software Vulkan the last one says nothing
		row.append("%.4f" % Measure.median(values[name]))
	return row


## Returns the place along x, moving to and fro at SPEED.
func _place(p_seconds: float) -> float:
	return 2.0 * WAY * absf(fposmod(SPEED * p_seconds / (4.0 * WAY), 1.0) * 2.0 - 1.0) - WAY


func _make(p_mover: String, p_field: GrassField) -> Node3D:
	match p_mover:
		"ball":
			return _body(_ball())
		"vehicle":
			return _vehicle()
		"skeleton":
			return _skeleton()
		"soft_body":
			return _soft_body()
		"trimesh":
			var torus := TorusMesh.new()
			torus.rings = 24
			torus.ring_segments = 8
			var shape := ConcavePolygonShape3D.new()
			shape.set_faces(torus.get_faces())
			return _body(shape)
		"height_map":
			return _body(HeightMapShape3D.new())
	var node := Node3D.new()
	node.position.y = 0.3
	if p_mover == "node":
		p_field.register_collider(node, _ball())
	return node


func _ball() -> SphereShape3D:
	var ball := SphereShape3D.new()
	ball.radius = 0.3
	return ball


func _body(p_shape: Shape3D) -> AnimatableBody3D:
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	_add_shape(body, p_shape, 0.0)
	body.position.y = 0.3
	return body


func _add_shape(p_body: CollisionObject3D, p_shape: Shape3D, p_height: float) -> void:
	var node := CollisionShape3D.new()
	node.shape = p_shape
	node.position.y = p_height
	p_body.add_child(node)


## Frozen, so that it stays where it is put; its chassis is above the grass.
func _vehicle() -> VehicleBody3D:
	var vehicle := VehicleBody3D.new()
	vehicle.freeze = true
	vehicle.freeze_mode = RigidBody3D.FREEZE_MODE_KINEMATIC
	var chassis := BoxShape3D.new()
	chassis.size = Vector3(1.4, 0.4, 3.0)
	_add_shape(vehicle, chassis, 1.2)
	for place in WHEELS:
		var wheel := VehicleWheel3D.new()
		wheel.position = place + Vector3(0, 0.4, 0)
		wheel.wheel_radius = 0.4
		vehicle.add_child(wheel)
	return vehicle


## Returns a chain of bones, 0.2 m each, a little above the ground.
func _skeleton() -> Skeleton3D:
	var skeleton := Skeleton3D.new()
	for i in BONES + 1:
		skeleton.add_bone("Bone%d" % i)
		if i > 0:
			skeleton.set_bone_parent(i, i - 1)
			skeleton.set_bone_rest(i, Transform3D(Basis(), Vector3(0, 0, 0.2)))
	skeleton.set_bone_rest(0, Transform3D(Basis(), Vector3(0, 0.3, -0.1 * BONES)))
	skeleton.reset_bone_poses()
	skeleton.add_child(GrassBoneColliders3D.new())
	return skeleton


## Returns a ball whose points are all pinned: it keeps its shape and stays where it is put.
func _soft_body() -> SoftBody3D:
	var sphere := SphereMesh.new()
	sphere.radius = 0.3
	sphere.height = 0.6
	sphere.radial_segments = 16
	sphere.rings = 8
	var body := SoftBody3D.new()
	body.mesh = ArrayMesh.new()
	(body.mesh as ArrayMesh).add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, sphere.get_mesh_arrays())
	body.position.y = 0.35
	for i in (body.mesh as ArrayMesh).surface_get_array_len(0):
		body.set_point_pinned(i, true)
	return body

# SPDX-License-Identifier: MIT
## The cost of forces in a meadow from eye level: none, one of each kind, and as many as act at once, in a small field and in a large one.
extends Node3D

const FrameTimer := preload("res://bench/frame_timer.gd")
const Scenery := preload("res://bench/scenery.gd")
const DENSITY := 64.0  # blades a square metre
const SIDES: Array[float] = [60.0, 400.0]  # metres
const KINDS := {
	none = [],
	wind = [GrassForce3D.KIND_WIND],
	downwash = [GrassForce3D.KIND_DOWNWASH],
	vortex = [GrassForce3D.KIND_VORTEX],
	blast = [GrassForce3D.KIND_BLAST],
	weak_wind = [GrassForce3D.KIND_WIND],
	all = [],
}
const RADIUS := 8.0  # metres
const SETTLED := 30  # ticks


func run(p_software: bool) -> Array[PackedStringArray]:
	var rows: Array[PackedStringArray] = [
		["forces", "side_m", "count", "awake_tiles", "gpu_ms", "simulate_ms", "cull_ms", "gather_ms", "tiles_ms", "upload_ms"]
	]
	for side: float in [8.0] if p_software else SIDES:
		for kind: String in KINDS:
			rows.append(await _measure(kind, side, p_software))
	return rows


func _measure(p_kind: String, p_side: float, p_software: bool) -> PackedStringArray:
	var camera := Scenery.add_camera(self)
	var sun := Scenery.add_sun(self, false)
	var timer := FrameTimer.new(get_viewport(), p_software)
	FrameTimer.look(camera, "eye", minf(p_side, SIDES[0]))
	var field := GrassField.new()
	field.simulation_detail = GrassField.SIMULATION_WHOLE
	field.size = Vector2.ONE * p_side
	field.density = DENSITY
	field.measure_time = true
	field.wind_speed = 3.0
	add_child(field)
	await Scenery.compiled(field)
	var forces := _make(p_kind)
	for force in forces:
		add_child(force)
		if force.kind == GrassForce3D.KIND_BLAST:
			force.fire()
	for i in SETTLED:
		await get_tree().physics_frame
	var times: Dictionary = await timer.measure(camera)
	times.merge(field.get_statistics())
	times.merge(field.get_counters())
	if times.awake_tiles == 0:
		times.simulate_ms = 0.0  # what is known is the last field's
	for node: Node in [camera, sun, field] + forces:
		node.queue_free()
	await get_tree().process_frame
	var row := PackedStringArray([p_kind, str(p_side), str(times.forces), str(times.awake_tiles)])
	for part: String in ["gpu_ms", "simulate_ms", "cull_ms", "gather_ms", "tiles_ms", "upload_ms"]:
		row.append("%.4f" % times[part])
	return row


## A blast that lasts as long as the measurement; sixteen rotors, one over another.
func _make(p_kind: String) -> Array[GrassForce3D]:
	var forces: Array[GrassForce3D] = []
	for i in 16 if p_kind == "all" else KINDS[p_kind].size():
		var force := GrassForce3D.new()
		force.kind = GrassForce3D.KIND_DOWNWASH if p_kind == "all" else KINDS[p_kind][0]
		force.speed = 2.5 if p_kind == "weak_wind" else 18.0
		force.radius = RADIUS
		force.duration = 10.0
		force.position = Vector3(2.0 * (i % 4) - 3.0 if p_kind == "all" else 0.0, 1.0, 2.0 * floorf(i / 4.0))
		forces.append(force)
	return forces

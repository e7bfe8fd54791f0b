# SPDX-License-Identifier: MIT
## The paper's table 2: GPU time of a frame by passes, 4 million blades, 128 thrown bodies, 4x MSAA.
extends Node3D

const FrameTimer := preload("res://bench/frame_timer.gd")
const Scenery := preload("res://bench/scenery.gd")
const Table := preload("res://bench/table.gd")

const SIDE := 128.0  # metres: 4,194,304 blades
const BODIES := 128
const FROM := 5.0  # seconds after the throw
const TO := 8.0


func run(r_table: Table, p_software: bool) -> void:
	r_table.columns(["pass", "gpu_ms", "blades", "awake_blades", "outcome"])
	var side := 8.0 if p_software else SIDE
	var timer := FrameTimer.new(get_viewport(), p_software)
	get_viewport().msaa_3d = Viewport.MSAA_4X
	var camera := Scenery.add_camera(self)
	FrameTimer.look(camera, "eye", side)
	Scenery.add_ground(self)
	Scenery.add_sun(self, false)
	for body in Scenery.throw(self, 8 if p_software else BODIES, side, 7):
		body.add_to_group("thrown")
	var empty := await timer.measure(camera)
	var field := GrassField.new()
	field.simulation_detail = GrassField.SIMULATION_WHOLE
	field.size = Vector2(side, side)
	field.measure_time = true
	field.sleep_mode = GrassField.SLEEP_TIMER  # as in the paper
	add_child(field)
	await Scenery.compiled(field)
	get_tree().call_group("thrown", "queue_free")
	Scenery.throw(self, 8 if p_software else BODIES, side, 7)
	var tick := 0
	var values := {simulate = [] as Array[float], cull = [] as Array[float], frame = [] as Array[float], awake = [] as Array[float]}
	var most := 20 if p_software else roundi(TO * Engine.physics_ticks_per_second)
	while tick < most:
		await get_tree().physics_frame
		tick += 1
		if tick > most * FROM / TO:
			var now := field.get_statistics()
			values.simulate.append(now.simulate_ms)
			values.cull.append(now.cull_ms)
			values.frame.append(RenderingServer.viewport_get_measured_render_time_gpu(get_viewport().get_viewport_rid()))
			values.awake.append(float(now.awake_tiles) * 64.0)
	var median := preload("res://bench/measure.gd").median
	var blades := field.get_blade_count()
	var awake := int(median.call(values.awake))
	var frame: float = median.call(values.frame)
	var passes := {
		"simulate": median.call(values.simulate),
		"cull": median.call(values.cull),
		"draw grass": frame - empty.gpu_ms,
		"all else drawn": empty.gpu_ms
	}
	for name: String in passes:
		r_table.add(
			{
				"pass": name,
				"gpu_ms": passes[name],
				"blades": blades,
				"awake_blades": awake,
				"outcome": "ok" if awake > 0 else "no blade was awake"
			}
		)
	get_viewport().msaa_3d = Viewport.MSAA_DISABLED

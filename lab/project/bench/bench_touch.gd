# SPDX-License-Identifier: MIT
## The frames in which many bodies touch sleeping grass at once, one by one: how long each took and where, and what the field did in it.
## Each turn of the bodies is measured without grass first, then on one field of 128 m: twice from rest, and once while the slots of the
## turn before still exist.
extends Node3D

const Scenery := preload("res://bench/scenery.gd")
const SIDE := 128.0  # metres
const CROWD := 128
const SPEED := 1.5  # m/s
const BEFORE := 2  # frames that are listed before the touch
const FRAMES := 30
const SLEEP := 900  # frames, until all slots are freed
const SOFTWARE := 0.125  # share of bodies and of the side, where the GPU is software
const COUNTERS := ["pool_slots", "woken", "gather_ms", "tiles_ms", "upload_ms"]
const TIMES := ["wall_ms", "reports_ms", "tick_ms", "frame_ms", "draw_ms", "simulate_ms"]

var _share := 1.0
var _bodies: Array[AnimatableBody3D] = []
var _marks: Array[int] = [0, 0, 0, 0, 0]  # microseconds: the end of the frame before, the tick, the frame, the draw, its end


func run(p_software: bool) -> Array[PackedStringArray]:
	_share = SOFTWARE if p_software else 1.0
	var camera := Scenery.add_camera(self)
	var sun := Scenery.add_sun(self, true)
	camera.position = Vector3(0, 12, 0.6 * _side())
	camera.look_at_from_position(camera.position, Vector3.ZERO)
	get_tree().physics_frame.connect(_mark.bind(1))
	get_tree().process_frame.connect(_mark.bind(2))
	RenderingServer.frame_pre_draw.connect(_mark.bind(3))
	RenderingServer.frame_post_draw.connect(_mark.bind(4))
	var columns := PackedStringArray(["turn", "frame"])
	columns.append_array(TIMES)
	columns.append_array(COUNTERS)
	var rows: Array[PackedStringArray] = [columns]
	await _pass(60)
	rows.append_array(await _turn("no grass", null))
	_clear()
	var field := GrassField.new()
	field.size = Vector2.ONE * _side()
	field.measure_time = true
	add_child(field)
	await Scenery.compiled(field)
	await _pass(60)
	for turn: String in ["first touch", "again", "slots exist"]:
		rows.append_array(await _turn(turn, field))
		_clear()
		await _pass(SLEEP if turn == "first touch" else 60)
	for node: Node in [field, sun, camera]:
		node.queue_free()
	return rows


func _side() -> float:
	return SIDE * sqrt(_share)


## Puts the bodies there and lists the frames around that.
func _turn(p_name: String, p_field: GrassField) -> Array[PackedStringArray]:
	var rows: Array[PackedStringArray] = []
	var woken := 0
	for frame in range(-BEFORE, FRAMES):
		if frame == 0:
			_bodies = Scenery.add_crowd(self, int(CROWD * _share), 0.9 * _side())
		for body in _bodies:
			body.position.x += SPEED / Engine.physics_ticks_per_second
		await RenderingServer.frame_post_draw
		var row := PackedStringArray([p_name, str(frame)])
		for i in 4:
			row.append("%.3f" % ((_marks[4] - _marks[0]) * 1e-3 if i == 0 else (_marks[i] - _marks[i - 1]) * 1e-3))
		row.insert(6, "%.3f" % ((_marks[4] - _marks[3]) * 1e-3))
		var counters := p_field.get_counters() if p_field else {}
		row.append("%.3f" % (p_field.get_statistics().simulate_ms if p_field else 0.0))
		for name: String in COUNTERS:
			var value: float = counters.get(name, 0)
			row.append("%.3f" % value if name.ends_with("_ms") else str(int(value) - (woken if name == "woken" else 0)))
		woken = counters.get("woken", 0)
		rows.append(row)
	return rows


func _clear() -> void:
	for body in _bodies:
		body.queue_free()
	_bodies.clear()


func _pass(p_frames: int) -> void:
	for i in p_frames if _share == 1.0 else mini(p_frames, 40):
		await RenderingServer.frame_post_draw


func _mark(p_which: int) -> void:
	if p_which == 1:
		_marks[0] = _marks[4]
	_marks[p_which] = Time.get_ticks_usec()

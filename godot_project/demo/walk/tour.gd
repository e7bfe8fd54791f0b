# SPDX-License-Identifier: MIT
## Takes the pictures of the walk: presses the keys that a player would press, and waits.
extends RefCounted

const Shots := preload("res://demo/shots.gd")

var _walk: Node3D
var _shots: Shots


func _init(p_walk: Node3D) -> void:
	_walk = p_walk


func record(folder: String) -> void:
	_walk.panel.visible = false
	if RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU:  # one cascade: a frame takes seconds
		_walk.get_node("Sun").directional_shadow_mode = DirectionalLight3D.SHADOW_ORTHOGONAL
	RenderingServer.viewport_set_measure_render_time(_walk.get_viewport().get_viewport_rid(), true)
	_shots = Shots.new(_walk.get_viewport(), folder)
	await _shots.warm_up()
	await _on_foot()
	await _with_the_mower()
	await _in_the_jeep()
	await _in_weather()


func _on_foot() -> void:
	_walk.panel.visible = true
	await _hold(["walk_forward"], 0.6)
	await _shots.picture()  # the panel tells what was drawn, and between pictures nothing is
	_walk.panel.tell(1.0, _walk.country.field, _walk.day.hour, _walk.weather.kind, "")
	await _take("1_morning")
	_walk.panel.visible = false
	await _hold(["walk_forward", "walk_sprint"], 0.9)
	_walk.eye.behind = true
	await _hold([], 0.1)
	await _take("2_kicked")
	_walk.eye.behind = false


func _with_the_mower() -> void:
	_walk.reset()
	_walk.walker.global_position = _walk.hills.on_ground(_walk.MOWER + Vector3(0.0, 0.0, 1.4), 0.05)
	await _hold(["walk_use"], 0.1)
	await _hold(["walk_forward"], 5.0)
	await _hold(["walk_use"], 0.1)
	await _hold(["walk_back"], 1.2)
	_walk.eye.pitch = -0.3
	await _hold([], 0.2)
	await _take("3_mown")
	_walk.eye.yaw = 1.1
	_walk.eye.pitch = -0.18
	await _hold([], 0.1)
	await _hold(["walk_blast"], 0.2)
	await _take("4_blast")
	await _hold([], 2.0)


func _in_the_jeep() -> void:
	_walk.reset()
	_walk.walker.global_position = _walk.hills.on_ground(_walk.jeep.get_door(), 0.05)
	await _hold(["walk_use"], 0.1)
	await _hold(["walk_forward"], 1.4)
	await _hold(["walk_forward", "walk_left"], 1.6)
	await _take("5_jeep")
	_walk.eye.yaw = PI - 0.25
	_walk.eye.pitch = -0.4
	await _hold(["walk_forward"], 0.3)
	await _take("6_tracks")
	_walk.eye.yaw = 0.0
	_walk.eye.pitch = 0.0
	_walk.day.hour = 22.5
	await _hold(["walk_forward"], 0.5)
	await _take("7_night")


func _in_weather() -> void:
	_walk.reset()
	_walk.day.hour = 15.0
	for kind: String in ["windy", "rain", "snow"]:
		_walk.weather.kind = kind
		_walk.weather.settle()
		await _hold([], 1.0)
		await _take("%d_%s" % [8 + ["windy", "rain", "snow"].find(kind), kind])
	_walk.weather.kind = "clear"
	_walk.weather.settle()
	_walk.day.hour = 17.2
	_walk.walker.global_position = _walk.hills.on_ground(Vector3(20.0, 0.0, 24.0), 0.05)
	await _hold([], 0.3)
	await _take("11_evening")


func _hold(actions: Array[StringName], seconds: float) -> void:
	for action in actions:
		Input.action_press(action)
	for i in roundi(seconds * Engine.physics_ticks_per_second):
		await _walk.get_tree().physics_frame
	for action in actions:
		Input.action_release(action)


func _take(p_name: String) -> void:
	await _shots.take(p_name)
	var awake := 0
	var blades := 0
	var triangles := 0
	var simulated := 0.0
	for field: GrassField in _walk.country.fields:
		var facts := field.get_statistics().merged(field.get_counters())
		awake += facts.awake_tiles
		blades += facts.drawn_blades
		triangles += facts.drawn_triangles + facts.shadow_triangles
		simulated += facts.simulate_ms + facts.cull_ms
	var counted := "%d tiles awake, %d blades and %d triangles drawn, those of shadows with them" % [awake, blades, triangles]
	var drawn := RenderingServer.viewport_get_measured_render_time_gpu(_walk.get_viewport().get_viewport_rid())
	print("%s: %s; GPU time %.1f ms to draw and %.2f to simulate and cull." % [p_name, counted, drawn, simulated])

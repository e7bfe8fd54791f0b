# SPDX-License-Identifier: MIT
## Ends the game as soon as it has drawn a field with plants: the engine still makes pipelines then. Started by tools/test/quitting.py.
extends Node3D

const PRESETS := "res://addons/grass_field/presets/%s.tres"


func _ready() -> void:
	var camera := Camera3D.new()
	camera.position = Vector3(0, 1.5, 6)
	add_child(camera)
	var sun := DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-50, 30, 0)
	sun.shadow_enabled = true
	add_child(sun)
	var field := GrassField.new()
	field.size = Vector2(10, 10)
	field.density = 60.0
	field.species = [load(PRESETS % "meadow"), load(PRESETS % "ox_eye_daisy")]
	add_child(field)
	while field.get_statistics().waiting:
		await RenderingServer.frame_post_draw
	await RenderingServer.frame_post_draw
	print("drawn: %d plants" % field.get_counters().drawn_plants)
	get_tree().quit()

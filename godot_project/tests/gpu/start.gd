# SPDX-License-Identifier: MIT
## Draws a small field until all of its passes are compiled, lets a box bend it and ends the game. Started by tools/test/starting.py,
## several times with the same user folder.
extends Node3D

const PATIENCE := 300.0  # seconds


func _ready() -> void:
	var camera := Camera3D.new()
	camera.position = Vector3(0, 1.2, 2.5)
	camera.rotation_degrees = Vector3(-20, 0, 0)
	add_child(camera)
	var field := GrassField.new()
	field.size = Vector2(4, 4)
	field.wind_speed = 0.0
	field.soil_enabled = false  # the picture shows blades and nothing else
	add_child(field)
	var window := get_viewport().get_viewport_rid()
	RenderingServer.viewport_set_update_mode(window, RenderingServer.VIEWPORT_UPDATE_DISABLED)  # but for its pictures
	var deadline := Time.get_ticks_msec() + 1000.0 * PATIENCE
	while (field.get_statistics().waiting or field.get_statistics().compiling > 0) and Time.get_ticks_msec() < deadline:
		OS.delay_msec(50)  # frames only take the time of the threads that compile
		await get_tree().process_frame
	_add_box()
	for i in 12:
		await get_tree().physics_frame
	var knots := field.wait_for_knots(field.get_tile_blades(field.get_tile_at(Vector3.ZERO)))
	RenderingServer.viewport_set_update_mode(window, RenderingServer.VIEWPORT_UPDATE_ALWAYS)
	var picture := await _picture()
	field.hide()
	var covered := _count_differing(picture, await _picture())
	var words := "GRASS-START bent %d: knots %d, picture %d, %d of its %d pixels show blades"
	var pixels := picture.get_width() * picture.get_height()
	print(words % [field.get_counters().simulated_blades, hash(knots), hash(picture.get_data()), covered, pixels])
	get_tree().quit()


func _add_box() -> void:
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	shape.shape.size = Vector3(0.5, 0.2, 0.5)
	body.add_child(shape)
	body.position = Vector3(0, 0.2, 0)
	add_child(body)


## Returns a picture that shows everything as it is now.
func _picture() -> Image:
	for i in 3:
		await RenderingServer.frame_post_draw
	return get_viewport().get_texture().get_image()


func _count_differing(a: Image, b: Image) -> int:
	var count := 0
	for y in a.get_height():
		for x in a.get_width():
			count += int(a.get_pixel(x, y) != b.get_pixel(x, y))
	return count

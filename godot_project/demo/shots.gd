# SPDX-License-Identifier: MIT
## Takes pictures of a viewport. Between two pictures the 3D view is off, so that software rendering, which takes
## seconds for a frame, does not hold up the physics.
extends RefCounted

const COMPILING := 120_000  # milliseconds

var draw_ms := 0.0  ## GPU time of the last picture's frame, as the engine measures it (0: unknown)

var _viewport: Viewport
var _folder: String


func _init(p_viewport: Viewport, p_folder: String) -> void:
	_viewport = p_viewport
	_folder = p_folder
	DirAccess.make_dir_recursive_absolute(p_folder)
	RenderingServer.viewport_set_measure_render_time(p_viewport.get_viewport_rid(), true)


## Draws once, so that shaders are compiled, and waits for the shaders of the grass, without which it is not drawn, and for its passes,
## without which it does not bend.
func warm_up() -> void:
	await _draw(2)
	var deadline := Time.get_ticks_msec() + COMPILING
	for field: GrassField in _viewport.find_children("*", "GrassField", true, false):
		while (field.get_statistics().waiting or field.get_statistics().compiling > 0) and Time.get_ticks_msec() < deadline:
			await _viewport.get_tree().process_frame


func take(p_name: String) -> void:
	var path := _folder.path_join(p_name + ".png")
	var error := (await picture()).save_png(path)
	if error != OK:
		push_error("Demo: cannot write %s (%s)." % [path, error_string(error)])


func picture() -> Image:
	await _draw(3)
	draw_ms = RenderingServer.viewport_get_measured_render_time_gpu(_viewport.get_viewport_rid())
	return _viewport.get_texture().get_image()


func _draw(p_frames: int) -> void:
	_viewport.disable_3d = false
	_viewport.get_tree().paused = true  # nothing moves while the picture is taken
	for i in p_frames:  # measured times arrive two frames late
		await RenderingServer.frame_post_draw
	_viewport.get_tree().paused = false
	_viewport.disable_3d = true

# SPDX-License-Identifier: MIT
## Both eyes of a headset in one draw, with the engine's shaders for it (`xr/shaders/enabled`, which tools/test/stereo.py sets in a copy of
## the project): the right eye sees as much grass as a camera in its place, strip by strip.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(210, 200)  # pixels of an eye
const STRIPS := 7  # of a picture, from left to right
# Of a strip's pixels.
const ALIKE := 0.003
const MISSING := 0.03
const SAME := 0.001  # the mean difference of two pictures, of all channels


class Headset:
	extends "res://tests/gpu/test_eyes.gd".Headset

	func _get_render_target_size() -> Vector2:
		return Vector2(SIZE)

	func _pre_draw_viewport(_render_target: RID) -> bool:
		return true


var headset: Headset
var eyes_camera: XRCamera3D


func before() -> void:
	open_view(SIZE)
	add_light()
	camera.free()
	headset = Headset.new()
	XRServer.add_interface(headset)
	assert_true(headset.initialize())
	var origin := XROrigin3D.new()
	viewport.add_child(origin)
	eyes_camera = XRCamera3D.new()
	origin.add_child(eyes_camera)


func after() -> void:
	viewport.use_xr = false
	XRServer.primary_interface = null
	headset.uninitialize()
	XRServer.remove_interface(headset)


## Returns what the right eye was shown last.
func right_picture() -> Image:
	var device := RenderingServer.get_rendering_device()
	var texture := RenderingServer.texture_get_rd_texture(viewport.get_texture().get_rid())
	assert_eq(device.texture_get_format(texture).array_layers, 2, "a layer for each eye")
	return Image.create_from_data(SIZE.x, SIZE.y, false, Image.FORMAT_RGBA8, device.texture_get_data(texture, 1))


## Returns what a camera in the right eye's place is shown.
func mono_picture() -> Image:
	viewport.use_xr = false
	camera = Camera3D.new()
	viewport.add_child(camera)
	camera.set_frustum(0.1, Vector2(0.5 * (Headset.OUTER - Headset.INNER) * 0.05, 0), 0.05, 100.0)
	camera.transform = headset._get_transform_for_view(1, Transform3D())
	camera.current = true
	await drawn()
	return await picture()


## Returns the share of each strip that shows grass.
func grass(image: Image) -> PackedFloat32Array:
	var shares := PackedFloat32Array()
	for strip in STRIPS:
		shares.append(share_of(image.get_region(Rect2i(strip * SIZE.x / STRIPS, 0, SIZE.x / STRIPS, SIZE.y)), is_green))
	return shares


func most_apart(a: PackedFloat32Array, b: PackedFloat32Array) -> float:
	var most := 0.0
	for i in STRIPS:
		most = maxf(most, absf(a[i] - b[i]))
	return most


func test_no_wedge_of_blades_is_missing_in_the_right_eye() -> void:
	add_seen_field({size = Vector2(16, 16), soil_enabled = false})
	eyes_camera.current = true
	viewport.use_xr = true
	await drawn()
	await RenderingServer.frame_post_draw
	var right := right_picture()
	# As if the left eye were all that the field knew: the renderer is told of the right one once the field has been told.
	var show_both := func() -> void: headset.eyes = [0, 1]
	var hide_right := func() -> void: headset.eyes = [0]
	RenderingServer.frame_pre_draw.connect(show_both)
	RenderingServer.frame_post_draw.connect(hide_right)
	await drawn()
	await RenderingServer.frame_post_draw
	var without := right_picture()
	RenderingServer.frame_pre_draw.disconnect(show_both)
	RenderingServer.frame_post_draw.disconnect(hide_right)
	headset.eyes = [0, 1]
	var mono := await mono_picture()
	print("    grass in strips: right eye %s; a camera in its place %s; left eye's tiles %s" % [grass(right), grass(mono), grass(without)])
	assert_less(most_apart(grass(right), grass(mono)), ALIKE, "the right eye against a camera in its place")
	assert_greater(most_apart(grass(without), grass(mono)), MISSING, "with the left eye's tiles only")


func test_ground_flowers_and_far_grass_look_as_in_a_camera() -> void:
	add_seen_field({size = Vector2(64, 64), species = [preload("res://addons/grass_field/presets/meadow.tres")], lod_far = 60.0})
	eyes_camera.current = true
	viewport.use_xr = true
	await drawn()
	await RenderingServer.frame_post_draw
	var right := right_picture()
	var mono := await mono_picture()
	assert_greater(share_of(mono, is_green), 0.2, "grass")
	print("    the right eye against a camera in its place: greatest and mean difference %s" % [difference(right, mono)])
	assert_less(difference(right, mono).y, SAME)

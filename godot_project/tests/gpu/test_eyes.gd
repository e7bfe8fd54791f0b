# SPDX-License-Identifier: MIT
## A headset's two eyes. An XR interface of the test's own gives the engine their places and projections, and shows nothing: to draw for
## both eyes, a project has to enable shaders (`xr/shaders/enabled`).
extends "res://tests/view_case.gd"


class Headset:
	extends XRInterfaceExtension
	const APART := 0.064
	const OUTER := 1.4  # each eye sees farther on its own side
	const INNER := 0.7
	var is_on := false
	var eyes: Array[int] = [0, 1]  # that it shows; 0: left

	func _get_name() -> StringName:
		return &"Headset of a test"

	func _get_capabilities() -> int:
		return XRInterface.XR_STEREO

	func _is_initialized() -> bool:
		return is_on

	func _initialize() -> bool:
		is_on = true
		XRServer.primary_interface = self
		return true

	func _uninitialize() -> void:
		is_on = false

	func _get_render_target_size() -> Vector2:
		return Vector2(2000, 2000)

	func _get_view_count() -> int:
		return eyes.size()

	func _get_camera_transform() -> Transform3D:
		return Transform3D(Basis(), Vector3(0, 1.5, 0))

	func _get_transform_for_view(view: int, cam_transform: Transform3D) -> Transform3D:
		return cam_transform * Transform3D(Basis(), Vector3((eyes[view] - 0.5) * APART, 1.5, 0))

	func _get_projection_for_view(view: int, _aspect: float, near: float, far: float) -> PackedFloat64Array:
		var left := -near * (INNER if eyes[view] == 1 else OUTER)
		var right := near * (OUTER if eyes[view] == 1 else INNER)
		var projection := Projection.create_frustum(left, right, -near, near, near, far)
		var numbers := PackedFloat64Array()
		for column in 4:
			for row in 4:
				numbers.append(projection[column][row])
		return numbers

	func _process() -> void:
		pass

	func _pre_draw_viewport(_render_target: RID) -> bool:
		return false


var headset: Headset
var origin: XROrigin3D


func before() -> void:
	open_view(Vector2i(128, 128))
	headset = Headset.new()
	XRServer.add_interface(headset)
	assert_true(headset.initialize())
	camera.free()
	origin = XROrigin3D.new()
	viewport.add_child(origin)
	camera = XRCamera3D.new()
	origin.add_child(camera)
	viewport.use_xr = true


func after() -> void:
	viewport.use_xr = false
	XRServer.primary_interface = null
	headset.uninitialize()
	XRServer.remove_interface(headset)


## Returns what `eye` sees of a point of the world, by the interface's own numbers.
func is_in_view(eye: int, point: Vector3) -> bool:
	var size := headset.get_render_target_size()
	var projection := headset.get_projection_for_view(eye, size.x / size.y, camera.near, camera.far)
	var place := headset.get_transform_for_view(eye, XRServer.world_origin).affine_inverse() * point
	var clip := projection * Vector4(place.x, place.y, place.z, 1.0)
	return clip.w > 0.0 and absf(clip.x) < clip.w and absf(clip.y) < clip.w and absf(clip.z) < clip.w


func test_both_eyes_see_their_tiles() -> void:
	var field := add_seen_field({size = Vector2(16, 16)})
	var alone := []
	for eye: int in 2:
		headset.eyes = [eye]
		await drawn()
		alone.append(field.get_statistics().drawn_tiles)
	headset.eyes = [0, 1]
	await drawn()
	var side: float = field.get_tile_size()
	var seen := [0, 0]
	var either := 0
	for z in roundi(16 / side):
		for x in roundi(16 / side):
			var middle := Vector3((x + 0.5) * side - 8, 0.1, (z + 0.5) * side - 8)
			var eyes := [is_in_view(0, middle), is_in_view(1, middle)]
			for i in 2:
				seen[i] += int(eyes[i])
			either += int(eyes[0] or eyes[1])
	print(
		(
			"    tiles whose middle is seen: left %d, right %d, either %d; drawn %d; for one eye %s"
			% [seen[0], seen[1], either, field.get_statistics().drawn_tiles, alone]
		)
	)
	assert_greater(either, maxi(seen[0], seen[1]) + 5, "each eye sees tiles that the other does not")
	var both: int = field.get_statistics().drawn_tiles
	assert_true(both >= either, "all of them are drawn")
	for eye in 2:
		assert_greater(both - alone[eye], 0.8 * (either - seen[eye]), "with those that eye %d alone does not see" % eye)
	field.backend = GrassField.BACKEND_CPU
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, both, "the CPU backend chooses the same tiles")
	camera.cull_mask = 2
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, 0, "the camera's mask counts for its eyes")
	camera.cull_mask = 1
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, both)
	origin.position.z = -30
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, 0, "they move with their origin")

# SPDX-License-Identifier: MIT
## History of TAA: a body that passes through grass leaves no ghost. A second view of the same world, with sixteen samples a pixel and
## without TAA, shows what each frame should be.
extends "res://tests/view_case.gd"

const MOTION_VECTORS := true  # see runner.gd
const SIZE := Vector2i(256, 144)
const FINER := 4  # samples a pixel along each side
const FROM := Vector3(0, 1.0, 2.6)
const SPEED := 5.0  # metres a second
const RADIUS := 0.2
const AT := Vector3(0, 0.2, 0.4)

var exact: SubViewport
var ball_body: AnimatableBody3D


func before() -> void:
	open_view(SIZE)
	add_light()
	viewport.use_taa = true
	exact = SubViewport.new()
	exact.size = SIZE * FINER
	exact.world_3d = viewport.find_world_3d()
	exact.render_target_update_mode = SubViewport.UPDATE_DISABLED  # but where it is compared: it takes sixteen times as long
	add_child(exact)
	exact.add_child(Camera3D.new())
	look(FROM, AT)
	exact.get_child(0).transform = camera.transform
	exact.get_child(0).fov = camera.fov


## A red ball in the grass, which the picture shows.
func add_red_ball(place: Vector3) -> void:
	ball_body = add_held_body(ball(RADIUS), place)
	remove_child(ball_body)
	viewport.add_child(ball_body)
	var mesh := MeshInstance3D.new()
	mesh.mesh = SphereMesh.new()
	mesh.mesh.radius = RADIUS
	mesh.mesh.height = 2.0 * RADIUS
	mesh.mesh.material = StandardMaterial3D.new()
	mesh.mesh.material.albedo_color = Color(0.9, 0.05, 0.05)
	ball_body.add_child(mesh)


## How far this frame is from what it should be, the mean of the grass where the ball was in the last seconds; its own place is left out.
func error_of_frame() -> float:
	await RenderingServer.frame_post_draw
	var shown := viewport.get_texture().get_image()
	var right := exact.get_texture().get_image()
	right.resize(SIZE.x, SIZE.y, Image.INTERPOLATE_LANCZOS)
	var middle := camera.unproject_position(ball_body.global_position)
	var radius := camera.unproject_position(ball_body.global_position + Vector3(0, RADIUS, 0)).distance_to(middle)
	var sum := 0.0
	var count := 0
	for y in range(roundi(middle.y - 1.5 * radius), roundi(middle.y + 1.5 * radius)):
		for x in range(roundi(middle.x - 6.0 * radius), roundi(middle.x + radius)):
			if Vector2(x, y).distance_to(middle) < 1.2 * radius:
				continue
			var off := shown.get_pixel(x, y) - right.get_pixel(x, y)
			sum += (absf(off.r) + absf(off.g) + absf(off.b)) / 3.0
			count += 1
	return sum / count


func mean_error(frame_count: int, each_frame: Callable) -> float:
	var sum := 0.0
	exact.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	for frame in frame_count:
		each_frame.call(frame)
		sum += await error_of_frame()
	exact.render_target_update_mode = SubViewport.UPDATE_DISABLED
	return sum / frame_count


func test_a_body_that_passes() -> void:
	add_seen_field({size = Vector2(10, 10)})
	add_red_ball(Vector3(-1.5, 0.2, 0.6))
	ball_body.position.x = 0.2
	await drawn()
	await frames(24)
	var still := await mean_error(4, func(_frame: int) -> void: pass)
	ball_body.position.x = -1.5
	await frames(60)
	for frame in 20:
		ball_body.position.x += SPEED / 60.0
		await frames(1)
	var passing := await mean_error(8, func(_frame: int) -> void: ball_body.position.x += SPEED / 60.0)
	print("    %.4f off beside a ball that lies, %.4f behind one that rolls" % [still, passing])
	assert_less(passing, 1.3 * still)

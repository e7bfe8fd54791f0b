# SPDX-License-Identifier: MIT
## A ball rolls through grass at 20 ticks a second, seen from the side at 60 frames a second: the grass ends right at the ball as it is
## drawn, also in frames between two ticks.
extends "res://tests/view_case.gd"

const TICKS_A_SECOND := 20  # three frames a tick
const SPEED := 6.0  # m/s: 0.3 m a tick
const RADIUS := 0.3
const SCALE := 96  # pixels a metre
const BAND := 0.05  # metres above and below the ball's middle, in which blades are looked for
const COVERED := 0.4  # share of a column's pixels in the band that are green where grass stands

var ticks_before: int


func before() -> void:
	ticks_before = Engine.physics_ticks_per_second
	open_view(Vector2i(4 * SCALE, SCALE))
	add_light()
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = 1.0
	look(Vector3(0, 0.45, 5), Vector3(0, 0.45, 0))


func after() -> void:
	Engine.physics_ticks_per_second = ticks_before
	get_tree().physics_interpolation = false


## A ball that rolls along x. It is drawn over the blades, so that its silhouette is whole.
func add_rolling_ball(place: Vector3) -> void:
	var mesh := MeshInstance3D.new()
	mesh.mesh = SphereMesh.new()
	mesh.mesh.radius = RADIUS
	mesh.mesh.height = 2.0 * RADIUS
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.albedo_color = Color.RED
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	material.no_depth_test = true
	mesh.material_override = material
	var body := RigidBody3D.new()
	body.gravity_scale = 0.0
	body.linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	body.linear_velocity.x = SPEED
	body.angular_velocity.z = -SPEED / RADIUS
	body.position = place
	add_shape(body, ball(RADIUS))
	body.add_child(mesh)
	viewport.add_child(body)


## Pixels from the ball's front to the grass that stands before it.
func gap(image: Image) -> int:
	var middle := roundi((0.45 - RADIUS + 0.5) * SCALE)
	var band := roundi(BAND * SCALE)
	var front := 0
	for x in image.get_width():
		front = x if is_red(image.get_pixel(x, middle)) else front
	for x in range(front + 1, image.get_width()):
		var green := 0
		for y in range(middle - band, middle + band):
			green += int(is_green(image.get_pixel(x, y)))
		if green >= COVERED * 2 * band:
			return x - front - 1
	return image.get_width()


## Returns the gaps in the frames of three ticks, while physics is interpolated.
func roll(mode: Node.PhysicsInterpolationMode) -> PackedInt32Array:
	get_tree().physics_interpolation = true
	var field := add_seen_field({size = Vector2(8, 0.1), density = 4000.0, pool_tiles = 256})
	field.physics_interpolation_mode = mode
	await drawn()
	Engine.physics_ticks_per_second = TICKS_A_SECOND
	add_rolling_ball(Vector3(-1.8, RADIUS, 0))
	await ticks(5)
	var gaps := PackedInt32Array()
	for frame in 9:
		await RenderingServer.frame_post_draw
		gaps.append(gap(viewport.get_texture().get_image()))
	return gaps


func test_grass_stands_right_before_the_ball_that_is_drawn() -> void:
	var gaps := await roll(Node.PHYSICS_INTERPOLATION_MODE_INHERIT)
	print("    pixels between the ball and the grass before it, at %d pixels a metre: %s" % [SCALE, gaps])
	assert_less(Array(gaps).max(), 0.04 * SCALE)


func test_grass_that_is_not_interpolated_runs_ahead_of_the_ball() -> void:
	var gaps := await roll(Node.PHYSICS_INTERPOLATION_MODE_OFF)
	print("    pixels between the ball and the grass before it, at %d pixels a metre: %s" % [SCALE, gaps])
	assert_greater(Array(gaps).max(), 0.08 * SCALE)

# SPDX-License-Identifier: MIT
## The moving picture of the README: bodies roll through a meadow, blade by blade it bends, and it rises. `./grass demo --video` has
## the engine's movie writer record it. Says on the console which frames are the film: those before them wait for the driver.
extends Node3D

const LENGTH := 6.0 # seconds
const FADE := 0.5 # seconds at the end that the encoder fades into the beginning
const COMPILING := 150_000 # milliseconds
const COLORS: Array[Color] = [Color(0.75, 0.22, 0.15), Color(0.2, 0.4, 0.65), Color(0.85, 0.6, 0.2)]
## Radius, place (field space), velocity. Metres and seconds.
const BALLS: Array[Array] = [
	[0.24, Vector3(-3.6, 0.24, 0.25), Vector3(3.4, 0, -0.1)],
	[0.34, Vector3(4.8, 0.34, -1.3), Vector3(-3.2, 0, 0.25)],
	[0.16, Vector3(-4.6, 0.16, 0.95), Vector3(2.7, 0, -0.05)],
]

var _frame := 0 # of the movie

@onready var _field: GrassField = $Field


func _ready() -> void:
	await _compiled()
	print("film: from frame %d, %d frames, fade %d" % [_frame, roundi(LENGTH * 60.0), roundi(FADE * 60.0)])
	for i in BALLS.size():
		add_child(_ball(BALLS[i][0], BALLS[i][1], BALLS[i][2], COLORS[i]))
	await get_tree().create_timer(LENGTH + FADE + 0.1).timeout
	get_tree().quit()


func _process(_delta: float) -> void:
	_frame += 1


## Grass stands until the driver has compiled its passes, and shaders take a frame or two.
func _compiled() -> void:
	var deadline := Time.get_ticks_msec() + COMPILING
	for i in 10:
		await get_tree().process_frame
	while _field.get_statistics().compiling > 0 and Time.get_ticks_msec() < deadline:
		await get_tree().process_frame


func _ball(radius: float, place: Vector3, velocity: Vector3, color: Color) -> RigidBody3D:
	var body := RigidBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = SphereShape3D.new()
	shape.shape.radius = radius
	var look := MeshInstance3D.new()
	look.mesh = SphereMesh.new()
	look.mesh.radius = radius
	look.mesh.height = 2.0 * radius
	look.material_override = StandardMaterial3D.new()
	look.material_override.albedo_color = color
	look.material_override.roughness = 0.5
	body.add_child(shape)
	body.add_child(look)
	body.position = place
	body.linear_velocity = velocity
	body.angular_velocity = Vector3(velocity.z, 0.0, -velocity.x) / radius # it rolls
	return body

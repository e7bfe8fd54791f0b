# SPDX-License-Identifier: MIT
## The moving picture of the README: bodies roll through a meadow, which bends blade by blade and rises again. `./grass demo --video`
## records it with the engine's movie writer. The scene prints which frames are the film: those before them wait for the driver.
extends Node3D

const LENGTH := 5.0  # seconds
const FADE := 0.5  # seconds at the end that the encoder fades into the beginning
const COMPILING := 150_000  # milliseconds
const LOG := 1.7  # metres long; the rest are balls
## Radius, place, velocity, colour. Metres and seconds.
const BODIES: Array[Array] = [
	[0.36, Vector3(-4.4, 0.36, 0.5), Vector3(4.2, 0, -0.1), Color(0.75, 0.22, 0.15)],
	[0.2, Vector3(0.5, 0.2, -5.2), Vector3(0, 0, 3.4), Color(0.45, 0.3, 0.18)],
	[0.5, Vector3(6.6, 0.5, -2.7), Vector3(-4.0, 0, 0), Color(0.2, 0.4, 0.65)],
]

var _frame := 0  # of the movie

@onready var _field: GrassField = $Field


func _ready() -> void:
	await _compiled()
	print("film: from frame %d, %d frames, fade %d" % [_frame, roundi(LENGTH * 60.0), roundi(FADE * 60.0)])
	for i in BODIES.size():
		add_child(_body(BODIES[i][0], BODIES[i][1], BODIES[i][2], BODIES[i][3], i == 1))
	await get_tree().create_timer(LENGTH + FADE + 0.1).timeout
	get_tree().quit()


func _process(_delta: float) -> void:
	_frame += 1


## Waits for the grass: it is drawn when its shaders are ready, and does not bend until the driver has compiled its passes.
func _compiled() -> void:
	var deadline := Time.get_ticks_msec() + COMPILING
	for i in 10:
		await get_tree().process_frame
	while (_field.get_statistics().waiting or _field.get_statistics().compiling > 0) and Time.get_ticks_msec() < deadline:
		await get_tree().process_frame


func _body(radius: float, place: Vector3, velocity: Vector3, color: Color, is_log: bool) -> RigidBody3D:
	var body := RigidBody3D.new()
	var shape := CollisionShape3D.new()
	var look := MeshInstance3D.new()
	if is_log:
		shape.shape = CapsuleShape3D.new()
		shape.shape.height = LOG
		look.mesh = CapsuleMesh.new()
		look.mesh.radius = radius
		look.mesh.height = LOG
		shape.rotation.z = 0.5 * PI
		look.rotation.z = 0.5 * PI
	else:
		shape.shape = SphereShape3D.new()
		look.mesh = SphereMesh.new()
		look.mesh.radius = radius
		look.mesh.height = 2.0 * radius
	shape.shape.radius = radius
	look.material_override = StandardMaterial3D.new()
	look.material_override.albedo_color = color
	look.material_override.roughness = 0.5
	body.add_child(shape)
	body.add_child(look)
	body.position = place
	body.linear_velocity = velocity
	body.angular_velocity = Vector3(velocity.z, 0.0, -velocity.x) / radius  # it rolls
	return body

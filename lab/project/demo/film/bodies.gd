# SPDX-License-Identifier: MIT
## Balls and a log roll through the meadow.
extends "res://demo/film/shot.gd"

const Look := preload("res://demo/walk/look.gd")
const BodyLook := preload("res://demo/body_look.gd")
const LOG := 1.5  # metres long; the rest are balls
## Radius, place, velocity, number of the colour. Metres and seconds.
const BODIES: Array[Array] = [
	[0.34, Vector3(-4.4, 0.36, -0.4), Vector3(3.5, 0, 0.1), 0],
	[0.2, Vector3(1.2, 0.2, -6.4), Vector3(-0.3, 0, 3.6), 2],
	[0.5, Vector3(6.4, 0.5, -2.9), Vector3(-3.8, 0, 0.1), 2],
	[0.24, Vector3(-3.4, 0.24, -4.6), Vector3(2.6, 0, 1.7), 1],
]

const AT := Vector3(0.0, 0.3, -1.2)  # what the camera looks at

var _bodies: Array[RigidBody3D] = []


func prepare() -> void:
	lead = 0.35
	for row in BODIES:
		_bodies.append(_body(row[0], row[2], row[3], row == BODIES[1]))
		_bodies[-1].position = on_ground(row[1])
		add_child(_bodies[-1])


## Returns the body that is nearest to the middle of the picture.
func subject() -> Vector3:
	var nearest := _bodies[0].global_position
	for body in _bodies:
		if body.global_position.distance_to(on_ground(AT)) < nearest.distance_to(on_ground(AT)):
			nearest = body.global_position
	return nearest


func look(share: float) -> void:
	aim(Vector3(lerpf(-0.7, 0.5, share), lerpf(1.7, 1.9, share), 3.4), AT + Vector3(lerpf(-0.5, 0.3, share), 0.0, 0.0), 52.0)


func _body(radius: float, velocity: Vector3, color: int, is_log: bool) -> RigidBody3D:
	var body := RigidBody3D.new()
	var shape: Shape3D
	var look: MeshInstance3D
	if is_log:
		shape = CapsuleShape3D.new()
		shape.height = LOG
		look = Look.add_mesh(body, BodyLook.mesh(BodyLook.Kind.LOG, color), Vector3.ZERO)
		look.scale = Vector3(radius / BodyLook.LOG.x, LOG / BodyLook.LOG.y, radius / BodyLook.LOG.x)
	else:
		shape = SphereShape3D.new()
		look = Look.add_mesh(body, BodyLook.mesh(BodyLook.Kind.BALL, color), Vector3.ZERO)
		look.scale = Vector3.ONE * radius / BodyLook.BALL
	shape.radius = radius
	look.rotation.z = 0.5 * PI if is_log else 0.0
	Look.add_shape(body, shape).rotation = look.rotation
	body.mass = 40.0
	body.linear_velocity = velocity
	body.angular_velocity = Vector3(velocity.z, 0.0, -velocity.x) / radius  # it rolls
	return body

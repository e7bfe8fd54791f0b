# SPDX-License-Identifier: MIT
## Rigid bodies of mixed shapes, thrown into a field: balls, crates, logs, bales of hay and stones.
extends RefCounted

const Look := preload("res://demo/walk/look.gd")
const BodyLook := preload("res://demo/body_look.gd")

var _random := RandomNumberGenerator.new()


func _init(p_seed: int) -> void:
	_random.seed = p_seed


## Returns a body of a random kind, 0.25 to 0.6 m in size. The same seed gives the same bodies.
func make() -> RigidBody3D:
	var size := _random.randf_range(0.25, 0.6)
	var kind := (_random.randi() % BodyLook.KINDS) as BodyLook.Kind
	var shape: Shape3D = _shape(kind, size)
	var body := RigidBody3D.new()
	Look.add_shape(body, shape)
	var color := _random.randi() % BodyLook.COLORS
	if kind == BodyLook.Kind.STONE:
		Look.add_mesh(body, BodyLook.stone((shape as ConvexPolygonShape3D).points, color), Vector3.ZERO)
	else:
		Look.add_mesh(body, BodyLook.mesh(kind, color), Vector3.ZERO).scale = size * Vector3.ONE
	body.mass = 8.0 * size * size * size / 0.064
	return body


## Places `body` above the rim of a field of `extent` metres and sends it across.
func throw(body: RigidBody3D, extent: float) -> void:
	var from := _random.randf_range(-0.45, 0.45) * extent
	var towards := Vector3(1.0, 0.0, _random.randf_range(-0.5, 0.5)).normalized()
	body.position = Vector3(-0.42 * extent, _random.randf_range(0.8, 2.5), from)
	body.rotation = Vector3(_random.randf(), _random.randf(), _random.randf()) * TAU
	body.linear_velocity = towards * _random.randf_range(4.0, 0.4 * extent + 5.0) + Vector3(0.0, _random.randf_range(0.0, 3.0), 0.0)
	body.angular_velocity = Vector3(_random.randfn(), _random.randfn(), _random.randfn()) * 6.0
	body.angular_damp = 1.2
	body.linear_damp = 0.35


## A shape of this kind; but for the stone it is as large as the unit's, times `size` (BodyLook).
func _shape(kind: BodyLook.Kind, size: float) -> Shape3D:
	match kind:
		BodyLook.Kind.BALL:
			var ball := SphereShape3D.new()
			ball.radius = size * BodyLook.BALL
			return ball
		BodyLook.Kind.CRATE:
			return Look.box(size * BodyLook.CRATE)
		BodyLook.Kind.LOG:
			var log_shape := CapsuleShape3D.new()
			log_shape.radius = size * BodyLook.LOG.x
			log_shape.height = size * BodyLook.LOG.y
			return log_shape
		BodyLook.Kind.BALE:
			var bale := CylinderShape3D.new()
			bale.radius = size * BodyLook.BALE.x
			bale.height = size * BodyLook.BALE.y
			return bale
	var points := PackedVector3Array()
	for i in 14:
		points.append(Vector3(_random.randfn(), _random.randfn(), _random.randfn()).normalized() * size * _random.randf_range(0.4, 0.6))
	var stone := ConvexPolygonShape3D.new()
	stone.points = points
	return stone

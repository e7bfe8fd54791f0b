# SPDX-License-Identifier: MIT
## A ball to kick.
extends RigidBody3D

const Look := preload("res://demo/walk/look.gd")
const Mould := preload("res://demo/walk/mould.gd")
const RADIUS := 0.22  # metres
const STRIPES: Array[Color] = [Color(0.8, 0.78, 0.72), Color(0.62, 0.16, 0.12), Color(0.8, 0.78, 0.72), Color(0.15, 0.25, 0.4)]
const SEAM := Color(0.35, 0.33, 0.3)


func _ready() -> void:
	mass = 0.45
	angular_damp = 1.0
	linear_damp = 0.15
	physics_material_override = PhysicsMaterial.new()
	physics_material_override.bounce = 0.55
	var shape := SphereShape3D.new()
	shape.radius = RADIUS
	Look.add_shape(self, shape)
	Look.add_mesh(self, mesh(), Vector3.ZERO)


## Gores of leather, with a valve at both ends.
static func mesh() -> ArrayMesh:
	var mould := Mould.new()
	mould.dirt = Vector2(-4.0 * RADIUS, 2.2 * RADIUS)  # some everywhere: it rolls
	for i in 2 * STRIPES.size():
		mould.paint(STRIPES[i % STRIPES.size()], 0.5)
		mould.gore(RADIUS, TAU * i / (2.0 * STRIPES.size()), TAU * (i + 1) / (2.0 * STRIPES.size()))
	mould.paint(SEAM, 0.6)
	for end: float in [-1.0, 1.0]:
		mould.disc(0.1 * RADIUS, 0.01, Mould.at(Vector3(0.0, 0.998 * end * RADIUS, 0.0)), 0.004)
	return mould.commit()

# SPDX-License-Identifier: MIT
## A ball to kick.
extends RigidBody3D

const Look := preload("res://demo/walk/look.gd")
const RADIUS := 0.22  # metres


func _ready() -> void:
	mass = 0.45
	angular_damp = 1.0
	linear_damp = 0.15
	physics_material_override = PhysicsMaterial.new()
	physics_material_override.bounce = 0.55
	var shape := SphereShape3D.new()
	shape.radius = RADIUS
	Look.add_shape(self, shape)
	var mesh := SphereMesh.new()
	mesh.radius = RADIUS
	mesh.height = 2.0 * RADIUS
	Look.add_mesh(self, mesh, Vector3.ZERO, Look.paint(Color(0.92, 0.9, 0.86), 0.4))
	var band := CylinderMesh.new()
	band.top_radius = 1.01 * RADIUS
	band.bottom_radius = 1.01 * RADIUS
	band.height = 0.07
	Look.add_mesh(self, band, Vector3.ZERO, Look.paint(Color(0.8, 0.15, 0.1), 0.4))

# SPDX-License-Identifier: MIT
## How somebody on foot looks: a hat, a shirt, and limbs that swing with the steps. The physics knows a capsule only.
extends Node3D

const Look := preload("res://demo/walk/look.gd")
const STRIDE := 0.75  # metres from one foot to the other
const SWING := 0.55  # radians, of a leg at full pace
const FULL_PACE := 2.2  # m/s
const SHIRT := Color(0.72, 0.2, 0.13)
const TROUSERS := Color(0.13, 0.17, 0.27)
const SKIN := Color(0.78, 0.56, 0.43)
const STRAW := Color(0.8, 0.66, 0.36)

var holds := false  ## something in front, with both hands

var _legs: Array[Node3D] = []
var _arms: Array[Node3D] = []
var _walked := 0.0  # metres


func _ready() -> void:
	_add_round(Vector3(0.0, 1.15, 0.0), 0.19, 0.68, SHIRT)
	_add_round(Vector3(0.0, 1.55, 0.0), 0.115, 0.28, SKIN)
	_add_disk(Vector3(0.0, 1.62, 0.0), 0.26, 0.025)
	_add_disk(Vector3(0.0, 1.68, 0.0), 0.125, 0.13)
	for side: float in [-1.0, 1.0]:
		_legs.append(_add_limb(Vector3(0.1 * side, 0.88, 0.0), 0.095, 0.9, TROUSERS))
		_arms.append(_add_limb(Vector3(0.24 * side, 1.4, 0.0), 0.065, 0.62, SHIRT))
		_add_round(Vector3(0.0, -0.6, 0.0), 0.06, 0.13, SKIN, _arms[-1])


## Moves the limbs after a way of `by` metres at `pace` m/s.
func step(by: float, pace: float) -> void:
	_walked += by
	var swing := SWING * minf(pace / FULL_PACE, 1.0) * sin(PI * _walked / STRIDE)
	for i in 2:
		var side := 1.0 if i else -1.0
		_legs[i].rotation.x = swing * side
		_arms[i].rotation.x = 0.85 if holds else -0.7 * swing * side


func _add_limb(at: Vector3, radius: float, length: float, color: Color) -> Node3D:
	var joint := Node3D.new()
	joint.position = at
	add_child(joint)
	_add_round(Vector3(0.0, radius - 0.5 * length, 0.0), radius, length, color, joint)
	return joint


func _add_round(at: Vector3, radius: float, height: float, color: Color, to: Node3D = self) -> void:
	var mesh := CapsuleMesh.new()
	mesh.radius = radius
	mesh.height = height
	Look.add_mesh(to, mesh, at, Look.paint(color, 0.85))


func _add_disk(at: Vector3, radius: float, height: float) -> void:
	var mesh := CylinderMesh.new()
	mesh.top_radius = radius
	mesh.bottom_radius = radius
	mesh.height = height
	Look.add_mesh(self, mesh, at, Look.paint(STRAW, 0.9))

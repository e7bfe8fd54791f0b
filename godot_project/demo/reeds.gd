# SPDX-License-Identifier: MIT
## A reed bank. A boat comes along the shore and pushes through the reeds, which rise again behind it.
extends "res://demo/place.gd"

const Look := preload("res://demo/walk/look.gd")
const Mould := preload("res://demo/walk/mould.gd")
const PLANKS := Color(0.4, 0.29, 0.19)
const SPEED := 1.6  # m/s

var _sailed := 13.0  # metres

@onready var _boat: AnimatableBody3D = $Boat
@onready var _course: Curve3D = ($Course as Path3D).curve


func _ready() -> void:
	var mould := Mould.new()
	mould.grain = Vector2(3.0, 0.5)  # planks from bow to stern
	mould.paint(PLANKS, 0.8)
	mould.hull(($Boat/Hull.shape as ConvexPolygonShape3D).points)
	Look.add_mesh($Boat, mould.commit(), Vector3.ZERO)
	super()


func happen(delta: float) -> void:
	_sailed = fmod(_sailed + SPEED * delta, _course.get_baked_length())
	var place := _course.sample_baked_with_rotation(_sailed)
	place.origin.y = 0.03 * sin(1.7 * time)
	_boat.transform = place * Transform3D(Basis(Vector3.FORWARD, 0.04 * sin(1.3 * time)), Vector3.ZERO)


func tell() -> String:
	return "At the bow, the reeds lean by %s of their height." % field.get_bend_at(_boat.global_transform * Vector3(0.0, 0.0, -1.6))

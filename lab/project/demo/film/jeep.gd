# SPDX-License-Identifier: MIT
## The jeep comes, and passes the camera closely; its tracks stay.
extends "res://demo/film/shot.gd"

const Jeep := preload("res://demo/walk/jeep.gd")
const WAY := Vector3(0.35, 0.0, -1.0)  # towards the sun, which lights its front
const SPEED := 6.5  # m/s, at the beginning

var _jeep := Jeep.new()


func prepare() -> void:
	lead = 1.0
	place = Vector3(3.0, 0.0, -9.0)
	add_child(_jeep)
	var way := WAY.normalized()
	_jeep.global_transform = Transform3D(
		Basis(Vector3.UP, atan2(way.x, way.z)), on_ground(-way * SPEED * (lead + 0.7 * seconds) + Vector3.UP * 0.35)
	)
	_jeep.linear_velocity = SPEED * way


func act(delta: float) -> void:
	_jeep.go(delta, 0.25, 0.0 if time < 0.6 * seconds else -0.35)
	_jeep.tread(delta, _country)


func subject() -> Vector3:
	return _jeep.global_position + Vector3(0.0, 0.6, 0.0)


func look(share: float) -> void:
	var eye := Vector3(-2.4, 1.05, lerpf(-1.2, -0.8, share))
	aim(eye, _jeep.global_position - place + Vector3(0.0, 0.5 - _jeep.global_position.y + 0.2, 0.0), 52.0)

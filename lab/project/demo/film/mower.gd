# SPDX-License-Identifier: MIT
## Somebody mows: the swath grows behind the mower.
extends "res://demo/film/shot.gd"

const Walker := preload("res://demo/walk/walker.gd")
const Mower := preload("res://demo/walk/mower.gd")
const WAY := Vector3(-1.0, 0.0, -0.25)  # across the shadows, so that the swath is in the sun
const PACE := 1.3  # m/s

var _walker := Walker.new()
var _mower := Mower.new()


func prepare() -> void:
	seconds = 3.0
	lead = 2.6
	place = Vector3(10.0, 0.0, 8.0)
	add_child(_walker)
	add_child(_mower)
	_mower.add_collision_exception_with(_walker)
	_walker.is_pushing = true
	_walker.global_position = on_ground(Vector3(0.0, 0.05, 0.0) - WAY.normalized() * PACE * (lead + 0.5 * seconds))


func act(delta: float) -> void:
	var way := WAY.normalized()
	var yaw := atan2(-way.x, -way.z)
	_walker.go(delta, PACE * way, yaw, _country)
	_mower.push(_walker.global_position, yaw, _hills, _country)


func subject() -> Vector3:
	return _mower.global_position + Vector3(0.0, 0.3, 0.0)


func look(share: float) -> void:
	var along := WAY.normalized() * lerpf(-1.6, 1.4, share)
	aim(along + Vector3(2.3, 1.9, 2.9), along + Vector3(0.4, 0.4, 0.0), 50.0)

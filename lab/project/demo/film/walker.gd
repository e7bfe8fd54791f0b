# SPDX-License-Identifier: MIT
## Somebody walks through high grass, which closes behind the legs.
extends "res://demo/film/shot.gd"

const Walker := preload("res://demo/walk/walker.gd")
const WAY := Vector3(0.8, 0.0, 0.6)
const PACE := 1.5  # m/s

var _walker := Walker.new()


func prepare() -> void:
	seconds = 2.8
	lead = 1.2
	place = Vector3(-9.0, 0.0, -7.0)
	add_child(_walker)
	_walker.global_position = on_ground(Vector3(0.0, 0.05, 0.0) - WAY.normalized() * PACE * (lead + 0.5 * seconds))


func act(delta: float) -> void:
	var way := WAY.normalized()
	_walker.go(delta, PACE * way, atan2(-way.x, -way.z), _country)


func subject() -> Vector3:
	return _walker.global_position + Vector3(0.0, 0.9, 0.0)


func look(share: float) -> void:
	var along := WAY.normalized() * lerpf(-1.9, 1.6, share)
	aim(along + Vector3(1.9, 1.35, 3.0), along + Vector3(-0.15, 0.72, 0.0), 48.0)

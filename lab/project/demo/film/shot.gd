# SPDX-License-Identifier: MIT
## A shot of the film: what happens in it, and where the camera is. It begins `lead` seconds before its first frame.
extends Node3D

const Hills := preload("res://demo/walk/hills.gd")
const Country := preload("res://demo/walk/country.gd")

var seconds := 2.6  ## its length
var lead := 0.5
var place := Vector3.ZERO  ## the middle of what happens; places of the shot are measured from it, heights from the ground
var wind := 2.0  ## m/s
var gusts := 0.4
var time := 0.0  ## seconds since the first frame

var _hills: Hills
var _country: Country
var _camera: Camera3D


func set_up(p_hills: Hills, p_country: Country, p_camera: Camera3D) -> void:
	_hills = p_hills
	_country = p_country
	_camera = p_camera


func _ready() -> void:
	prepare()
	time = -lead
	look(0.0)


func advance(delta: float) -> void:
	time += delta
	act(delta)
	look(clampf(time / seconds, 0.0, 1.0))


## Puts everything where it is at the beginning.
func prepare() -> void:
	pass


## What happens in a tick.
func act(_delta: float) -> void:
	pass


## Returns what the camera must show.
func subject() -> Vector3:
	return on_ground(Vector3.ZERO)


## Puts the camera where it is when the shot has passed by `share`, 0 to 1.
func look(_share: float) -> void:
	pass


func on_ground(at: Vector3) -> Vector3:
	return _hills.on_ground(place + at, at.y)


func aim(eye: Vector3, target: Vector3, fov := 45.0) -> void:
	_camera.fov = fov
	_camera.look_at_from_position(on_ground(eye), on_ground(target))

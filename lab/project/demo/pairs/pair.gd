# SPDX-License-Identifier: MIT
## A pair of pictures: what the second one shows more than the first, and where the camera is. Places are measured from its middle, their
## heights from the ground.
extends Node3D

const Stage := preload("res://demo/stage.gd")

var about := ""  ## the first half, and the second
var middle := Vector3(-3.0, 0.0, -4.0)
var eye := Vector3(0.2, 1.5, 3.6)
var target := Vector3(0.0, 0.3, 0.0)
var settles := 0.3  ## seconds, from when it is made to the picture
var rebuilds := false  ## making it changes what the field builds in the background
var stage: Stage


func place_camera(camera: Camera3D) -> void:
	camera.fov = 50.0
	camera.look_at_from_position(on_ground(eye), on_ground(target))


## Makes what a half shows, and waits until it is there.
func make(_is_after: bool) -> void:
	pass


## Undoes what grass that grows back does not.
func undo() -> void:
	pass


func on_ground(at: Vector3) -> Vector3:
	return stage.hills.on_ground(middle + at, at.y)


func wait(seconds: float) -> void:
	for i in roundi(seconds * Engine.physics_ticks_per_second):
		await get_tree().physics_frame

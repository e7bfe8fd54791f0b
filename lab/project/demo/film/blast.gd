# SPDX-License-Identifier: MIT
## A blast flattens the grass around it, and throws balls.
extends "res://demo/film/shot.gd"

const Blast := preload("res://demo/walk/blast.gd")
const Ball := preload("res://demo/walk/ball.gd")
const AT := 0.4  # seconds
const BALLS: Array[Vector3] = [Vector3(-1.0, 0.25, 0.9), Vector3(1.3, 0.25, 0.5), Vector3(0.5, 0.25, -1.2)]

var _blast := Blast.new()
var _balls: Array[RigidBody3D] = []


func prepare() -> void:
	lead = 0.8
	place = Vector3(-6.0, 0.0, 9.0)
	add_child(_blast)
	for at in BALLS:
		_balls.append(Ball.new())
		_balls[-1].position = on_ground(at)
		add_child(_balls[-1])


func act(_delta: float) -> void:
	if time >= AT and _blast.blasts == 0:
		_blast.blow(on_ground(Vector3(0.0, 0.3, 0.0)), _balls)


func look(share: float) -> void:
	aim(Vector3(lerpf(0.9, 0.5, share), lerpf(2.5, 2.7, share), lerpf(6.0, 6.3, share)), Vector3(0.0, 0.5, 0.0), 52.0)

# SPDX-License-Identifier: MIT
## Air that moves: a rotor hovers over a meadow, a whirl wanders through it, and every four seconds something blows up.
extends "res://demo/place.gd"

const EVERY := 4.0  # seconds
const FIRST := 1.0  # second

var _blasts := 0

@onready var _blast: GrassForce3D = $Blast
@onready var _helicopter: Node3D = $Helicopter
@onready var _rotor: Node3D = $Helicopter/Rotor
@onready var _whirl: GrassForce3D = $Whirl


func happen(delta: float) -> void:
	if time > FIRST + _blasts * EVERY:
		_blast.fire()
		_blasts += 1
	_helicopter.position.x = 6.0 + sin(0.6 * time)
	_helicopter.rotation.y = 0.3 * sin(0.4 * time)
	_rotor.rotate_y(25.0 * delta)
	_whirl.position = Vector3(-7.0 + 1.5 * cos(0.5 * time), 0.3, -6.0 + 1.5 * sin(0.5 * time))


func tell() -> String:
	return "%d forces." % field.get_counters().forces

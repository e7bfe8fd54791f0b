# SPDX-License-Identifier: MIT
## Fields above one another: a bridge over a meadow, a ball on each, and grass on a wall and below the bridge.
extends "res://demo/place.gd"

const ROLL := 0.8  # m/s

@onready var _balls: Array[Node] = $Balls.get_children()


func happen(delta: float) -> void:
	for ball: AnimatableBody3D in _balls:
		ball.position.x += ROLL * delta
		ball.rotate_z(-ROLL * delta / 0.35)


func tell() -> String:
	return "%d and %d tiles awake." % [field.get_awake_tile_count(), ($Bridge as GrassField).get_awake_tile_count()]

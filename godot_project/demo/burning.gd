# SPDX-License-Identifier: MIT
## A dry meadow burns: the fire runs with the wind, creeps against it, and leaves black stubble.
extends "res://demo/place.gd"

const Fire := preload("res://demo/fire.gd")

var fire: Fire


func _ready() -> void:
	fire = Fire.new(field)
	var angle := deg_to_rad(field.wind_direction)
	fire.wind = field.wind_speed * Vector2(cos(angle), sin(angle))
	fire.light($Start.global_position, 0.8)
	super()


func happen(delta: float) -> void:
	fire.advance(delta)


func tell() -> String:
	return "%d cells burn, %d have burnt." % [fire.get_burning(), fire.burnt]

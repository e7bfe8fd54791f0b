# SPDX-License-Identifier: MIT
## The walk's country on a late afternoon: the film and the pairs of pictures are taken there.
extends Node3D

const Actions := preload("res://demo/walk/actions.gd")
const Walk := preload("res://demo/walk/walk.gd")
const HOUR := 16.2  # the sun is low, and shines through the grass
const TREES_FROM := 45.0  # metres

@onready var hills: Node3D = $Hills
@onready var country: Node3D = $Country


## p_size: one of Walk.SIZES.
func make(p_size: String) -> void:
	Actions.register()  # the day asks for one of them
	var sides: Array = Walk.SIZES[p_size]
	hills.make(sides[1])
	hills.cover(0.0, 0.0)
	country.make(sides[0], hills, sides[2])
	$Trees.make(hills, TREES_FROM, 0.45 * sides[1])
	$Day.set_up($Sun, $World)
	$Day.hour = HOUR
	$Day.advance(0.0, 0.0)
	if RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU:  # one cascade: a frame takes seconds
		$Sun.directional_shadow_mode = DirectionalLight3D.SHADOW_ORTHOGONAL


func set_wind(speed: float, gusts: float) -> void:
	for field: GrassField in country.fields:
		field.wind_speed = speed
		field.gust_strength = gusts

# SPDX-License-Identifier: MIT
## A gust runs over the meadow.
extends "res://demo/film/shot.gd"

const CALM := 1.0  # m/s
const STRONG := 11.0


func prepare() -> void:
	lead = 1.5
	place = Vector3(8.0, 0.0, -4.0)
	gusts = 1.0


func act(_delta: float) -> void:
	wind = lerpf(CALM, STRONG, smoothstep(-0.8, 0.9, time))


func subject() -> Vector3:
	return on_ground(Vector3(0.0, 0.3, -2.5))


func look(share: float) -> void:
	aim(Vector3(lerpf(0.4, -0.4, share), 1.0, 2.6), Vector3(lerpf(0.2, -0.5, share), 0.62, -3.0), 50.0)

# SPDX-License-Identifier: MIT
## Rolls a ball through the grass. Exit code 0 if blades bent; the last line says what was seen.
extends Node3D

const PATIENCE := 240  # seconds: software Vulkan compiles its passes meanwhile

@onready var _meadow: GrassField = $Meadow
@onready var _ball: AnimatableBody3D = $Ball


func _ready() -> void:
	await get_tree().process_frame
	await get_tree().process_frame
	var tile := _meadow.get_tile_at(Vector3.ZERO)
	var rest := _meadow.get_tile_knots(tile)
	var bent := 0.0
	var deadline := Time.get_ticks_msec() + PATIENCE * 1000
	var tick := 0
	while bent < 0.05 and Time.get_ticks_msec() < deadline:
		await get_tree().physics_frame
		tick += 1
		_ball.position = Vector3(0.1 * sin(0.1 * tick), 0.2, 0)
		bent = _farthest(rest, _meadow.get_tile_knots(tile))
	var renderer := DisplayServer.get_name()
	if renderer != "headless":
		renderer = RenderingServer.get_current_rendering_method()
	print(
		(
			"GrassField %s, %s: %d blades, the ball bends them by %.3f m"
			% [GrassField.get_version(), renderer, _meadow.get_blade_count(), bent]
		)
	)
	get_tree().quit(0 if bent >= 0.05 and _meadow.get_blade_count() > 0 else 1)


func _farthest(a: PackedVector3Array, b: PackedVector3Array) -> float:
	var most := 0.0
	for i in mini(a.size(), b.size()):
		most = maxf(most, a[i].distance_to(b[i]))
	return most

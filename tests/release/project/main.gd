# SPDX-License-Identifier: MIT
## Pushes a ball through the grass. Exit code 0 if blades bent; the last line says what was seen. Without a window it also tells a hash of
## the blades after fixed ticks, which is the same on every system. With `-- picture.png` it keeps what a window shows, with the ball at the
## same place on every driver.
extends Node3D

const PATIENCE := 240  # seconds: software Vulkan compiles its passes meanwhile
const STEP := 1.0 / 64.0  # metres a tick, and every place of the ball, are exact numbers
const WAY := 16  # ticks from one end of the ball's way to the other

@onready var _meadow: GrassField = $Meadow
@onready var _ball: AnimatableBody3D = $Ball


func _ready() -> void:
	while _meadow.get_statistics().waiting or _meadow.get_blade_count() == 0:
		await get_tree().physics_frame
	var tile := _meadow.get_tile_at(Vector3.ZERO)
	var rest := _meadow.get_tile_knots(tile)
	var bent := 0.0
	var deadline := Time.get_ticks_msec() + PATIENCE * 1000
	var tick := 0
	while bent < 0.05 and Time.get_ticks_msec() < deadline:
		tick += 1
		await _push(tick)
		bent = _farthest(rest, _meadow.get_tile_knots(tile))
	var periods := 0
	while periods < 3:  # where a driver compiles for long, the ball has pushed more often
		tick += 1
		await _push(tick)
		periods += int(tick % (2 * WAY) == 0)
	var renderer := DisplayServer.get_name()
	var bits := ""
	if renderer == "headless":
		bits = ", bits " + _meadow.get_tile_knots(tile).to_byte_array().hex_encode().sha256_text().left(16)
	else:
		renderer = RenderingServer.get_current_rendering_method()
		for picture in OS.get_cmdline_user_args():
			await RenderingServer.frame_post_draw
			get_viewport().get_texture().get_image().save_png(picture)
	print(
		(
			"GrassField %s, %s: %d blades, the ball bends them by %.3f m%s"
			% [GrassField.get_version(), renderer, _meadow.get_blade_count(), bent, bits]
		)
	)
	get_tree().quit(0 if bent >= 0.05 and _meadow.get_blade_count() > 0 else 1)


## Moves the ball to and fro along a straight line, for one tick.
func _push(p_tick: int) -> void:
	await get_tree().physics_frame
	_ball.position = Vector3(STEP * (absi(p_tick % (2 * WAY) - WAY) - 8), 0.1875, 0)


func _farthest(a: PackedVector3Array, b: PackedVector3Array) -> float:
	var most := 0.0
	for i in mini(a.size(), b.size()):
		most = maxf(most, a[i].distance_to(b[i]))
	return most

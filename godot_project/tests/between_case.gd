# SPDX-License-Identifier: MIT
## A view of a ball that rolls through grass at few ticks a second, so that even a slow machine draws frames between two of them.
extends "res://tests/view_case.gd"

const TICKS_A_SECOND := 3
const SPEED := 0.9  # m/s: 0.3 m a tick

var ticks_before: int
var body: AnimatableBody3D


func before() -> void:
	ticks_before = Engine.physics_ticks_per_second
	open_view(Vector2i(160, 96))
	add_light()


func after() -> void:
	Engine.physics_ticks_per_second = ticks_before
	get_tree().physics_interpolation = false


## A ball that rolls through the grass while physics is interpolated, or not.
func roll(is_interpolated: bool, properties := {}) -> GrassField:
	get_tree().physics_interpolation = is_interpolated
	var field := add_seen_field({size = Vector2(8, 4), wind_speed = 0.0}.merged(properties))
	look(Vector3(0, 2.2, 1.6), Vector3(0, 0.1, 0))
	await drawn()
	body = add_held_body(ball(0.25), Vector3(-1.5, 0.2, 0))
	remove_child(body)
	viewport.add_child(body)
	body.reset_physics_interpolation()
	await ticks(5)
	await compiled(field)  # frames are mixed from then on
	Engine.physics_ticks_per_second = TICKS_A_SECOND
	return field


func move_body() -> void:
	body.position.x += SPEED / TICKS_A_SECOND


## Returns what `look_at` returns of consecutive frames of some ticks, by default their picture: [that, tick, fraction of the way to it].
func watch(count: int, look_at := func() -> Variant: return viewport.get_texture().get_image()) -> Array:
	var seen := []
	var tick := Engine.get_physics_frames()
	var end := tick + count
	while tick < end:
		await get_tree().process_frame
		if Engine.get_physics_frames() != tick:
			tick = Engine.get_physics_frames()
			move_body()
		await RenderingServer.frame_post_draw
		seen.append([look_at.call(), Engine.get_physics_frames(), Engine.get_physics_interpolation_fraction()])
	return seen


## How many of the pictures differ from one before, of those that show the same tick and enough more of its share to see it; and how many
## there are. In the first ticks the body may still stand.
func count_moving(seen: Array) -> Vector2i:
	var counts := Vector2i.ZERO
	var last: Array = seen[0]
	for now: Array in seen:
		if now[1] != last[1]:
			last = now
		elif now[1] > seen[0][1] + 1 and now[2] - last[2] > 0.04:
			counts += Vector2i(int(difference(now[0], last[0]).x > 0.02), 1)
			last = now
	return counts

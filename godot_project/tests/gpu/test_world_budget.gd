# SPDX-License-Identifier: MIT
## A GrassWorld whose pools are on the GPU.
extends "res://tests/view_case.gd"


func test_a_body_that_walks_keeps_its_grass() -> void:
	open_view(Vector2i(64, 36))
	if RenderingServer.get_rendering_device() == null:
		skip("no GPU")
		return
	expect_error("`memory_budget` (40 MB) holds grass up to")
	var field := GrassField.new()
	field.wind_speed = 0.0
	field.drawn_tiles_max = 4096
	var scene := PackedScene.new()
	scene.pack(field)
	field.free()
	var world := GrassWorld.new()
	world.plot_size = 64.0
	world.camera_radius = 150.0
	world.memory_budget = 40.0
	world.plot_scene = scene
	viewport.add_child(world)
	look(Vector3(20, 3, 20), Vector3(40, 0, 40))
	await wait_until(func() -> bool: return world.get_statistics().plots > 4, "plots stand")
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	add_shape(body, ball(0.4))
	body.position = Vector3(20, 0.4, 40)
	viewport.add_child(body)
	var least := 100
	var most := 0
	for i in 240:
		body.position.x += 0.3  # across two borders
		await ticks(1)
		least = mini(least, world.get_statistics().plots)
		most = maxi(most, world.get_statistics().memory)
	assert_greater(least, 0, "grass stands all the time")
	assert_less(most, 1.1 * 40e6, "pools grow at once, and plots leave one in a frame")
	var under := world.get_field_at(body.position)
	assert_true(under != null, "under the body")
	assert_greater(under.get_counters().pool_slots, 0, "it has a pool")
	body.free()
	await wait_until(func() -> bool: return world.get_statistics().waiting == 0 and world.get_statistics().plots > 4, "and later")

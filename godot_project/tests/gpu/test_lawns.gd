# SPDX-License-Identifier: MIT
## What many fields cost: draws, objects of the engine and memory of lawns of 16 m, 64 of which cover 128 x 128 m, as a card sees them in a
## picture of 1,080 lines.
extends "res://tests/view_case.gd"

const LINES := 36.0  # of the small picture
const SIDE := 16.0  # metres
const DETAIL := {pixels_min = 1.2 * LINES / 1080.0, lod_error = LINES / 1080.0}  # as in a large picture
const FRAMES_AFTER := 3  # until the monitors know what a frame drew


func before() -> void:
	open_view(Vector2i(64, int(LINES)))
	camera.far = 600.0
	var sun := DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-50, 40, 0)
	sun.shadow_enabled = true
	viewport.add_child(sun)


## `across` x `across` fields around the origin.
func add_lawns(across: int, properties := {}) -> Array[GrassField]:
	var lawns: Array[GrassField] = []
	for i in across * across:
		@warning_ignore("integer_division")
		var place := Vector3(i % across - 0.5 * (across - 1), 0.0, i / across - 0.5 * (across - 1)) * SIDE
		var own := {
			size = Vector2.ONE * SIDE, pool_tiles = 64, cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON, position = place
		}
		lawns.append(add_seen_field(own.merged(DETAIL).merged(properties, true)))
	return lawns


## Draw calls of a frame.
func draws() -> int:
	await ready_for_picture()
	for i in FRAMES_AFTER:
		await RenderingServer.frame_post_draw
	return RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TOTAL_DRAW_CALLS_IN_FRAME)


func test_64_lawns_take_few_draws() -> void:
	add_lawns(8)
	for view: Array in [[Vector3(0, 1.7, 66), Vector3(0, 1.7, 0)], [Vector3(3, 1.7, 5), Vector3(30, 1, -40)]]:
		look(view[0], view[1])
		var count := await draws()
		print("    64 lawns from %s: %d draws" % [view[0], count])
		assert_true(count > 64 and count <= 500, "%d draws, of 64 lawns and their soil, from %s" % [count, view[0]])


func test_far_lawns_take_fewer_draws_than_one_near() -> void:
	var lawns := add_lawns(1)
	look(Vector3(0, 1.7, 9), Vector3(0, 1, 0))
	var one := await draws()
	for i in 7:
		var more: GrassField = add_lawns(1)[0]
		more.position.x = SIDE * (i - 3.5)
		lawns.append(more)
	lawns[0].position.x = SIDE * 3.5
	look(Vector3(0, 1.7, 100), Vector3(0, 1.7, 0))
	var row := await draws()
	print("    one lawn at the feet %d draws, eight of them 100 m away %d" % [one, row])
	assert_greater(row, 8, "blades and soil of each")
	assert_true(row <= 1.5 * one, "%d draws of a far row, %d of a near lawn" % [row, one])


func test_the_cpu_draws_no_level_without_tiles() -> void:
	add_lawns(2, {backend = GrassField.BACKEND_CPU})
	look(Vector3(0, 1.7, 60), Vector3(0, 1.7, 0))
	var far := await draws()
	assert_true(far >= 8 and far <= 4 * 8, "%d draws of four far lawns" % far)
	var shown: Array[GrassField] = add_lawns(2)
	for lawn in shown:
		lawn.hide()
	assert_eq(await draws(), far, "hidden ones take none")


## Plants are drawn with their mesh up to 30 m.
func test_plants_out_of_reach_take_no_draws() -> void:
	var species := GrassSpecies.new()
	species.plant_mesh = BoxMesh.new()
	species.plant_mesh.size = Vector3(0.05, 0.3, 0.05)
	species.share = 0.001
	for backend: GrassField.BackendMode in [GrassField.BACKEND_AUTO, GrassField.BACKEND_CPU]:
		var lawn: GrassField = add_lawns(1, {species = [GrassSpecies.new(), species], backend = backend})[0]
		look(Vector3(0, 1.7, 60), Vector3(0, 1.7, 0))
		var far := await draws()
		species.plant_distance = 80.0
		await grown(lawn)
		assert_greater(await draws(), far, "within reach")
		assert_greater(lawn.get_counters().drawn_plants, 0)
		species.plant_distance = 30.0
		await grown(lawn)
		assert_eq(await draws(), far, "out of reach")
		lawn.free()


## Meshes change as a camera comes nearer: none stays behind, and what is drawn at each place does not depend on the way there.
func test_walking_leaves_nothing() -> void:
	var lawn: GrassField = add_lawns(1)[0]
	var first := {}
	var memory := 0.0
	for turn in 4:
		for away: float in [9.0, 14.0, 22.0, 35.0, 60.0, 28.0, 11.0]:
			look(Vector3(0, 1.7, away), Vector3(0, 1, 0))
			await drawn()
			var now := lawn.get_statistics()
			assert_greater(now.drawn_tiles, 0)
			assert_eq(
				first.get_or_add(away, [now.drawn_tiles, now.drawn_blades, now.drawn_triangles]),
				[now.drawn_tiles, now.drawn_blades, now.drawn_triangles],
				"from %s m" % away
			)
		await frames(5)
		if turn == 1:
			memory = Performance.get_monitor(Performance.RENDER_VIDEO_MEM_USED)
	assert_less(Performance.get_monitor(Performance.RENDER_VIDEO_MEM_USED) - memory, 2e4, "bytes")

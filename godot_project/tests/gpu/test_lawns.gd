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


func test_a_large_field_takes_few_draws() -> void:
	add_lawns(1, {size = Vector2(128, 128)})
	look(Vector3(0, 1.7, 66), Vector3(0, 1.7, 0))
	var count := await draws()
	print("    one field of 128 m: %d draws" % count)
	assert_true(count > 20 and count <= 34 + 4 * 17 + 1, "%d draws, with all levels in all cascades at most" % count)


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


## A still view of grass at rest: nothing is asked of the renderer in a frame, by however many fields.
func test_idle_lawns_ask_nothing_of_the_renderer() -> void:
	var lawns := add_lawns(2)
	look(Vector3(0, 1.7, 40), Vector3(0, 1.7, 0))
	await drawn()
	await frames(4)
	var before: Array[Dictionary] = []
	for lawn in lawns:
		before.append(lawn.get_counters())
	await unseen(func() -> void: await frames(20))
	for i in lawns.size():
		for counter: String in ["render_jobs", "culls", "instance_updates", "wind_updates", "uploaded_bytes"]:
			assert_eq(lawns[i].get_counters()[counter], before[i][counter], counter)
	camera.position.z += 1.0
	await drawn()
	for i in lawns.size():
		assert_eq(lawns[i].get_counters().culls, before[i].culls + 1, "another view")
		var jobs: int = lawns[i].get_counters().render_jobs - before[i].render_jobs
		assert_true(jobs >= 1 and jobs <= 3, "%d jobs for another view: it is drawn, and found up to date" % jobs)


func video_memory() -> float:
	await drawn()
	await frames(8)  # the engine frees two frames late
	return Performance.get_monitor(Performance.RENDER_VIDEO_MEM_USED)


## Bytes that each of `across` x `across` fields adds on the device, without its pool: what takes twice the pool shows how much that is.
func bytes_without_pool(across: int, properties: Dictionary) -> float:
	var without := await video_memory()
	var added: Array[float] = []
	for pool_tiles: int in [64, 128]:
		var fields := add_lawns(across, properties.merged({pool_tiles = pool_tiles}))
		added.append((await video_memory() - without) / (across * across))
		for field in fields:
			field.free()
		await frames(8)
	return 2.0 * added[0] - added[1]


func test_memory_of_fields_at_rest() -> void:
	add_lawns(1)  # it has what fields share
	look(Vector3(0, 1.7, 60), Vector3(0, 1.7, 0))
	var lawn := await bytes_without_pool(4, {})
	print("    a further lawn takes %.0f KB of video memory without its pool" % (lawn / 1e3))
	assert_true(lawn > 1e4 and lawn <= 2.6e5, "%.0f bytes of a lawn" % lawn)
	var large := await bytes_without_pool(1, {size = Vector2(128, 128)})
	print("    a field of 128 m takes %.1f MB" % (large / 1e6))
	assert_true(large > 1e5 and large <= 12e6, "%.0f bytes of a field of 128 m" % large)


func test_objects_of_a_lawn() -> void:
	add_lawns(1)
	await drawn()
	var without := Performance.get_monitor(Performance.OBJECT_COUNT)
	add_lawns(4)
	await drawn()
	var objects := (Performance.get_monitor(Performance.OBJECT_COUNT) - without) / 16.0
	print("    a further lawn is %.2f objects" % objects)
	assert_true(objects >= 1.0 and objects <= 10.0, "%.2f objects: the node, its materials, and few more" % objects)

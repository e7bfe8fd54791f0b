# SPDX-License-Identifier: MIT
## The debugger's monitors of all fields together. get_statistics() and get_counters() have the documented keys.
extends "res://tests/field_case.gd"

const MONITORS: Array[String] = [
	"awake_tiles", "simulated_blades", "drawn_blades", "drawn_triangles", "management", "simulate", "cull", "memory"
]
const STATISTICS: Array[String] = [
	"version",
	"backend",
	"device",
	"driver",
	"waiting",
	"compiling",
	"blades",
	"awake_tiles",
	"refused",
	"drawn_tiles",
	"drawn_blades",
	"drawn_triangles",
	"left_out_tiles",
	"management_ms",
	"simulation_coarseness",
	"simulate_ms",
	"cull_ms",
	"memory",
]
const COUNTERS: Array[String] = [
	"bare_tiles",
	"map_bytes",
	"settling_tiles",
	"still_tiles",
	"still_tile_steps",
	"tile_steps",
	"woken",
	"slept",
	"evicted",
	"yielded",
	"capped",
	"wheels",
	"bones",
	"soft_bodies",
	"mesh_pieces",
	"areas",
	"plant_nodes",
	"plant_nodes_made",
	"stems_looked_at",
	"plant_tiles_looked_at",
	"forces",
	"forces_left_out",
	"body_reads",
	"shape_reads",
	"engine_calls",
	"tiles_looked_at",
	"tiles_ranked",
	"colliders",
	"list_entries",
	"bad_colliders",
	"steps",
	"simulated_blades",
	"strain_blades",
	"uploaded_bytes",
	"knots_read",
	"knot_waits",
	"energy_reads",
	"undrawn_batches",
	"knots_age",
	"mixes",
	"culls",
	"render_jobs",
	"instance_updates",
	"drawn_plants",
	"drawn_impostors",
	"left_out_plants",
	"shadow_tiles",
	"shadow_blades",
	"shadow_triangles",
	"left_out_shadow_tiles",
	"gather_ms",
	"tiles_ms",
	"plants_ms",
	"upload_ms",
	"frame_ms",
	"build_ms",
	"builds",
	"makings",
	"pool_tiles",
	"pool_slots",
	"pool_bytes",
	"unseen_tile_steps",
	"unseen_ticks",
	"visited_ticks",
	"visited_frames",
	"wind_updates",
	"edge_tile_steps",
	"free_tile_steps",
	"crowd_tile_steps",
	"workgroups",
	"left_out_blade_steps",
	"widened_tiles",
	"followed_blade_steps",
	"timed_steps",
	"fill_cells",
	"fill_waiting",
	"terrain_queries",
	"terrain_calls",
	"terrain_waiting",
	"map_waiting",
]


func monitor(what: String) -> float:
	return Performance.get_custom_monitor("grass_field/" + what)


func has_monitors() -> int:
	var count := 0
	for what in MONITORS:
		count += int(Performance.has_custom_monitor("grass_field/" + what))
	return count


func test_statistics_are_complete() -> void:
	var field := add_field()
	await ticks(2)
	for call: Array in [[field.get_statistics(), STATISTICS], [field.get_counters(), COUNTERS]]:
		for key: String in call[1]:
			assert_true(call[0].has(key), key)
		for key: String in call[0]:
			assert_true(key in call[1], "%s is not in this test's list" % key)


func test_monitors_come_and_go_with_the_fields() -> void:
	assert_eq(has_monitors(), 0)
	var first := add_field()
	assert_eq(has_monitors(), MONITORS.size())
	var second := add_field()
	first.free()
	assert_eq(has_monitors(), MONITORS.size(), "one is left")
	remove_child(second)
	assert_eq(has_monitors(), 0, "out of the tree")
	add_child(second)
	assert_eq(has_monitors(), MONITORS.size())
	second.free()
	assert_eq(has_monitors(), 0)


func test_a_scripts_own_monitor_stays() -> void:
	Performance.add_custom_monitor("grass_field/memory", func() -> float: return 42.0)
	var field := add_field()
	assert_eq(has_monitors(), MONITORS.size())
	assert_eq(monitor("memory"), 42.0)
	field.free()
	assert_eq(has_monitors(), 1, "the script's own")
	assert_eq(monitor("memory"), 42.0)
	Performance.remove_custom_monitor("grass_field/memory")


func test_monitors_add_up_the_fields() -> void:
	var fields: Array[GrassField] = [add_field(), add_field({position = Vector3(100, 0, 0)})]
	await ticks(2)
	for what in MONITORS:
		assert_true(is_finite(monitor(what)), what)
	assert_eq(monitor("awake_tiles"), 0.0)
	monitor("simulate")  # from now on it is measured
	add_held_body(ball(0.2), Vector3(0.25, 0.25, 0.25))
	add_held_body(ball(0.4), Vector3(100.25, 0.25, 0.25))
	await ticks(5)
	var sums := {awake_tiles = 0.0, memory = 0.0, management_ms = 0.0, simulate_ms = 0.0}
	for field in fields:
		assert_greater(field.get_awake_tile_count(), 0)
		for key: String in sums:
			sums[key] += field.get_statistics()[key]
	assert_eq(monitor("awake_tiles"), sums.awake_tiles)
	assert_eq(monitor("simulated_blades"), BLADES * sums.awake_tiles)
	assert_near(monitor("memory"), sums.memory, 1e5, "bytes")
	assert_near(monitor("management"), 1e-3 * sums.management_ms, 1e-9, "seconds")
	assert_near(monitor("simulate"), 1e-3 * sums.simulate_ms, 1e-9, "seconds")
	assert_greater(sums.simulate_ms, 0.0)


func test_memory_counts_what_grows() -> void:
	var field := add_field()
	await ticks(2)
	var at_rest := field.get_memory_usage()
	assert_greater(at_rest, 16384 * 16 * 8, "at least the patch")
	var body := add_held_body(ball(0.5), Vector3(0, 0.25, 0))
	await ticks(5)
	var a_tile := 4 * 64 * (3 * 16 + 2 * 3 * 14 + 14 + 3)  # bytes of a tile's state on the CPU
	assert_true(field.get_memory_usage() - at_rest >= field.get_awake_tile_count() * a_tile, "the awake tiles' state")
	body.free()

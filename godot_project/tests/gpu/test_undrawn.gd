# SPDX-License-Identifier: MIT
## No frame is drawn while ticks go on, as behind a minimised window. The engine keeps what its device is given until a frame ends, and ends
## the game once reads take 128 MB: 2,048 ticks of one field whose energies take 64 KB. So nothing that a tick asks for may pile up, and the
## grass goes on as if it were seen.
extends "res://tests/parity_case.gd"

const BATCH := 32  # ticks that the device takes at once: UNDRAWN_TICKS in extension/shared/frames.h
const FIELDS := 4
const WORLD := preload("res://tests/world_case.gd")

## Four fields that read in each of them ended the game after 700.
var many := 10000 if OS.get_environment("GRASS_STRESS") == "full" else 1000


func after() -> void:
	RenderingServer.render_loop_enabled = true


func memory_mb() -> int:
	return int(FileAccess.open("/proc/self/statm", FileAccess.READ).get_line().split(" ")[1]) * 4 / 1024


## Ticks without a frame that is shown; `before_tick` is called with the number of each. Returns how many the engine drew all the same: two
## whenever something was freed.
func undrawn(count: int, before_tick := func(_i: int) -> void: pass) -> int:
	var drawn: Array[int] = []
	var draws := func() -> void: drawn.append(Engine.get_process_frames())
	RenderingServer.render_loop_enabled = false
	await get_tree().physics_frame
	RenderingServer.frame_pre_draw.connect(draws)
	for i in count:
		before_tick.call(i)
		await get_tree().physics_frame
	RenderingServer.frame_pre_draw.disconnect(draws)
	RenderingServer.render_loop_enabled = true
	return drawn.size()


func test_nothing_piles_up_in_many_ticks() -> void:
	var fields: Array[GrassField] = []
	for i in FIELDS:
		fields.append(add_field({size = Vector2(2, 2), density = 64.0, backend = GrassField.BACKEND_AUTO, measure_time = true}))
	await grown(fields[0])
	await compiled(fields[0])
	var body := add_held_body(ball(0.1), Vector3.ZERO)
	for i in 130:  # until the field has all slots that it will need: larger buffers make the engine draw
		body.position = Vector3(0.3 * sin(0.05 * i), 0.1, 0.0)
		await ticks(1)
	var memory: Array[int] = []
	var before := fields.map(func(field: GrassField) -> Dictionary: return field.get_counters())
	var drawn := await undrawn(
		many,
		func(i: int) -> void:
			body.position = Vector3(0.3 * sin(0.05 * i), 0.1, 0.0)
			if i == many / 10:
				memory.append(memory_mb())
	)
	memory.append(memory_mb())
	print("    memory %s MB" % [memory])
	assert_eq(drawn, 0, "drawn frames")
	assert_less(memory[1] - memory[0], 16, "MB more after %d ticks" % many)
	for i in fields.size():
		var counters := fields[i].get_counters()
		assert_greater(counters.steps - before[i].steps, many - BATCH, "ticks that are simulated")
		assert_less(counters.energy_reads - before[i].energy_reads, many / BATCH + 3, "reads of energies")
		assert_greater(counters.undrawn_batches - before[i].undrawn_batches, many / BATCH - 3)


func test_the_grass_is_right_when_drawing_goes_on() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
		return
	var tile := gpu.get_tile_at(PLACE)
	var body := add_held_body(ball(0.3), PLACE + Vector3(0.35, 0.15, 0.0))
	await ticks(5)
	assert_eq(await undrawn(2 * BATCH + 5, func(i: int) -> void: body.position.x += 0.01 * cos(0.1 * i)), 0, "drawn frames")
	assert_less(share_apart([tile], 1e-2), 0.05, "of the blades are apart")
	body.free()
	await ticks(20)
	assert_less(share_apart([tile], 1e-2), 0.05, "of the blades are apart")


func test_queries_are_answered_and_calm_tiles_sleep() -> void:
	if not await add_pair({sleep_mode = GrassField.SLEEP_ENERGY}):
		return
	var body := add_held_body(ball(0.3), PLACE + Vector3(0.1, 0.1, 0.0))
	gpu.get_bend_at(PLACE)
	await undrawn(3 * BATCH, func(_i: int) -> void: gpu.get_bend_at(PLACE))
	assert_near(gpu.get_bend_at(PLACE).length(), cpu.get_bend_at(PLACE).length(), 0.02, "metres of bend, told without a frame")
	assert_greater(cpu.get_bend_at(PLACE).length(), 0.1)
	body.free()
	await undrawn(600)
	assert_eq(gpu.get_awake_tile_count(), 0, "tiles awake, ten seconds after the body went")


func test_a_world_goes_on_and_nothing_piles_up() -> void:
	var helper := WORLD.new()
	add_child(helper)
	helper.before()
	var world: GrassWorld = helper.add_world({plot_scene = helper.pattern({density = 1.0})})
	await wait_until(func() -> bool: return world.get_field(Vector2i.ZERO) != null, "the plot below the camera is there")
	var body := add_held_body(ball(0.3), Vector3.ZERO)
	var memory: Array[int] = []
	await undrawn(
		many,
		func(i: int) -> void:
			helper.eye.position = Vector3(300.0 * sin(0.01 * i), 2.0, 0.0)
			body.position = Vector3(helper.eye.position.x, 0.2, 0.0)
			if i == many * 3 / 4:
				memory.append(memory_mb())
	)
	memory.append(memory_mb())
	print("    memory %s MB" % [memory])
	assert_less(memory[1] - memory[0], 48, "MB more in the last quarter of %d ticks" % many)
	helper.eye.position = Vector3(1000.0, 2.0, 0.0)
	await undrawn(20 * BATCH)
	var there := Vector2i(roundi(1000.0 / WORLD.PLOT), 0)
	assert_true(world.get_field(there) != null, "a plot came where the camera went, without a frame")
	helper.after()
	helper.free()

# SPDX-License-Identifier: MIT
## A test under the layer of tests/drivers/, which refuses compute passes: those of tools/test/drivers.py from the process's beginning, and
## those of refuse() from then on. A process compiles a pass once.
extends "res://tests/view_case.gd"

const PLACE := Vector3(0, 0.25, 0)
const ENGINE_SAYS: Array[String] = ["vkCreateComputePipelines", "pipeline.driver_id"]
const WARNING := "The CPU simulates and draws this field"


## Counts messages about refused passes, and warnings of fields that the CPU simulates for that reason.
class Counter:
	extends Logger
	var count := 0
	var warnings := 0
	var mutex := Mutex.new()

	func _log_error(
		_function: String,
		_file: String,
		_line: int,
		code: String,
		rationale: String,
		_notify: bool,
		_type: int,
		_traces: Array[ScriptBacktrace]
	) -> void:
		mutex.lock()
		count += int((code + rationale).contains("GrassField: the graphics driver refused"))
		warnings += int((code + rationale).contains(WARNING))
		mutex.unlock()


var said := Counter.new()


func before() -> void:
	open_view(Vector2i(96, 54))
	add_light()
	look(Vector3(0, 1.2, 3.2), Vector3(0, 0.2, 0))
	OS.add_logger(said)


func after() -> void:
	OS.remove_logger(said)
	refuse("")


func refuse(passes: String) -> void:
	OS.set_environment("GRASS_LAYER_REFUSED", passes)


## Returns the passes that the driver was asked for in this process, by the names of their files.
func asked_passes() -> PackedStringArray:
	return FileAccess.get_file_as_string(OS.get_environment("GRASS_LAYER_ASKED")).split("\n", false)


## The text of the error for a pass, which comes with the engine's own; names as in RenderingDevice.
func expect_refusal(passes: Array[String]) -> void:
	for part in ENGINE_SAYS:
		expect_error(part)
	for pass_name in passes:
		expect_error("refused the compute pass 'GrassField %s' (llvmpipe" % pass_name)


## Grass on the right half of the field, whose left half is bare.
func half_map() -> GrassMap:
	var map := full_map()
	for z in 5:
		map.stroke(brush(GrassBrush.TOOL_ERASE, 1.0), Vector2(-1.0, z - 2.0), Vector2(-1.0, z - 2.0))
	return map


func grass_of(image: Image) -> float:
	return share_of(image, is_green)


## Checks that the field is drawn and bends with `backend`, and reports this backend.
func assert_lives(field: GrassField, backend: String) -> void:
	await wait_until(func() -> bool: return field.get_statistics().backend == backend, "it is the %s's" % backend)
	await wait_until(func() -> bool: return field.get_statistics().compiling == 0, "all passes are compiled or refused")
	await drawn()
	var now := field.get_statistics().merged(field.get_counters())
	assert_eq(now.backend, backend)
	assert_false(now.waiting)
	assert_greater(now.drawn_tiles, 0)
	var grass := grass_of(await picture())
	print("    %s: %.0f %% of the picture is grass" % [backend, 100.0 * grass])
	assert_greater(grass, 0.1)
	var steps: int = now.steps
	assert_greater(await bend(field), 0.02, "a ball bends it")
	assert_greater(field.get_counters().steps, steps)


## Does the same as bend_with_ball(), in the viewport's world.
func bend(field: GrassField) -> float:
	var tile := field.get_tile_at(PLACE)
	var rest := tile_knots(field, tile)
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	add_shape(body, ball(0.2))
	body.position = PLACE
	viewport.add_child(body)
	await ticks(10)
	var bent := farthest(tile_knots(field, tile), rest)
	body.free()
	return bent

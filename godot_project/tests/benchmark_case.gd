# SPDX-License-Identifier: MIT
## Runs the demo's benchmark, a hundredth of it.
extends "res://tests/view_case.gd"

const SCENE := preload("res://demo/benchmark.tscn")
const Meter := preload("res://demo/benchmark/meter.gd")
const Parts := preload("res://demo/benchmark/parts.gd")
const Report := preload("res://demo/benchmark/report.gd")
const FOLDER := "user://benchmark_test"
const SHARE := 0.01

## As in the file that goes into a report.
var text := ""


func after() -> void:
	remove_folder(FOLDER)


## Returns the result as a tool reads it.
func measured() -> Dictionary:
	var benchmark := SCENE.instantiate()
	benchmark.share = SHARE
	benchmark.folder = FOLDER
	add_child(benchmark)
	await benchmark.ended
	benchmark.queue_free()
	text = FileAccess.get_file_as_string(FOLDER.path_join(Report.TEXT))
	return JSON.parse_string(FileAccess.get_file_as_string(FOLDER.path_join(Report.FILE)))


func check(result: Dictionary) -> void:
	assert_eq(result.version, 1.0)
	assert_eq(result.share, SHARE)
	assert_eq(result.parts.keys(), Parts.PARTS.map(func(part: Dictionary) -> String: return part.name))
	for part: String in result.parts:
		var found: Dictionary = result.parts[part]
		assert_greater(found.frames, 0.0, part)
		assert_greater(found.blades, 0.0, part)
		assert_true(text.contains(part), part)
		for time: String in Meter.TIMES:
			assert_true(found[time][0] <= found[time][1], "%s, %s: the median is not above the slowest" % [part, time])
	for key: String in ["device", "driver", "renderer", "processor", "system", "engine"]:
		assert_true(result.machine.has(key), key)

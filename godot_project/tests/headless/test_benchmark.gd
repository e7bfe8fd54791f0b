# SPDX-License-Identifier: MIT
## The demo's benchmark measures each part where nothing is drawn, and writes a file that names the machine and not its owner.
extends "res://tests/benchmark_case.gd"


func test_without_a_window() -> void:
	var result := await measured()
	check(result)
	assert_true(result.pictures.is_empty(), "nothing is drawn")
	assert_eq(result.machine.kind, "none")
	for part: String in ["walk", "bodies_10", "bodies_128"]:
		assert_greater(result.parts[part].awake_tiles, 0, part)
		assert_greater(result.parts[part].simulate[0], 0.0, part)
	assert_greater(result.parts.meadow_256.blades, 10 * result.parts.meadow_16.blades)
	assert_true(text.contains("pictures          none"), "the text says so")
	assert_false(text.contains(OS.get_environment("HOME") + "/"), "no path of this machine")

# SPDX-License-Identifier: MIT
## What a user includes in a bug report: version, backend, device and driver.
extends "res://tests/field_case.gd"


class Errors:
	extends Logger
	var texts: Array[String] = []

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
		texts.append(rationale if rationale else code)


func test_the_version_is_one_of_three_numbers() -> void:
	assert_true(RegEx.create_from_string("^\\d+\\.\\d+\\.\\d+(-\\w+)?$").search(GrassField.get_version()) != null, GrassField.get_version())


func test_statistics_name_the_build_and_the_device() -> void:
	var field := add_field()
	await ticks(2)
	var now := field.get_statistics()
	assert_eq(now.version, GrassField.get_version())
	assert_eq(now.backend, "CPU")
	assert_eq(now.device, RenderingServer.get_video_adapter_name())
	assert_eq(now.driver == "", now.device == "")


func test_the_first_error_of_a_field_names_them_once() -> void:
	expect_error("no such tile")
	var errors := Errors.new()
	var field := add_field()
	await ticks(2)
	OS.add_logger(errors)
	for i in 3:
		field.get_knots(Vector2i(-1, 0), 0)
	OS.remove_logger(errors)
	assert_eq(errors.texts.size(), 3)
	var build := "GrassField %s, CPU backend" % GrassField.get_version()
	assert_eq(errors.texts.map(func(text: String) -> bool: return text.contains(build)), [true, false, false], str(errors.texts))

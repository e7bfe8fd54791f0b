# SPDX-License-Identifier: MIT
## What a test extends: `extends "res://tests/case.gd"`.
##
## The runner makes a new instance for each function test_*(), puts it into the tree, calls it (it may await) and frees
## it with all its children. Optional: `func before()` and `func after()`, which may await as well. A failed check is
## noted and the test goes on; where that makes no sense, `if not assert_...(): return`.
## An error that the engine or a script reports while a test runs fails it, unless the test expects it (expect_error).
@tool
extends Node3D

const PATIENCE := 300.0  # seconds; on a busy machine a thread or a driver may take long for what else takes it a moment

var failures: Array[String] = []
var skipped := ""
var _expected: Array[String] = []


## Waits for `count` physics ticks (1/60 s each).
func ticks(count: int) -> void:
	for i in count:
		await get_tree().physics_frame


## Waits for `count` drawn frames.
func frames(count: int) -> void:
	for i in count:
		await get_tree().process_frame


## Frames until `condition` is true; fails after PATIENCE, with the words of `what`. For work of a thread or a driver, which takes
## seconds and no known number of frames. With `by_ticks` it returns in a tick: what a test does next, it does before the next one.
func wait_until(condition: Callable, what: String, by_ticks := false) -> bool:
	var deadline := Time.get_ticks_msec() + PATIENCE * 1000
	while not condition.call():
		if Time.get_ticks_msec() > deadline:
			return fail("waited %d s, in vain, until %s" % [PATIENCE, what])
		if by_ticks:
			await ticks(1)
		else:
			await frames(1)
	return true


func assert_true(value: bool, message := "") -> bool:
	return value or _fail("expected true", message)


func assert_false(value: bool, message := "") -> bool:
	return not value or _fail("expected false", message)


func assert_eq(got: Variant, expected: Variant, message := "") -> bool:
	var same := typeof(got) == typeof(expected) or _is_number(got) and _is_number(expected)
	return same and got == expected or _fail("expected %s, got %s" % [expected, got], message)


func assert_ne(got: Variant, unexpected: Variant, message := "") -> bool:
	var same := typeof(got) == typeof(unexpected) or _is_number(got) and _is_number(unexpected)
	return not (same and got == unexpected) or _fail("expected anything but %s" % unexpected, message)


## `got` within `tolerance` of `expected`: numbers, or vectors by their distance. NaN is near nothing.
func assert_near(got: Variant, expected: Variant, tolerance: float, message := "") -> bool:
	var off: float = absf(got - expected) if _is_number(got) else (got - expected).length()
	return off <= tolerance or _fail("expected %s within %s, got %s (off by %s)" % [expected, tolerance, got, off], message)


func assert_less(got: Variant, bound: Variant, message := "") -> bool:
	return got < bound or _fail("expected less than %s, got %s" % [bound, got], message)


func assert_greater(got: Variant, bound: Variant, message := "") -> bool:
	return got > bound or _fail("expected more than %s, got %s" % [bound, got], message)


func fail(message: String) -> bool:
	return _fail(message, "")


## Ends the test's claim to be judged: `skip("no GPU"); return`. Skips are named and counted.
func skip(reason: String) -> void:
	skipped = reason


## The test provokes an error or warning whose text contains `part`, at least once; any number is then no failure.
func expect_error(part: String) -> void:
	_expected.append(part)


## For the runner: judges the errors that were reported while the test ran.
func judge(errors: Array) -> void:
	var seen := {}
	for error: Dictionary in errors:
		var part := _expectation(error.text)
		if part:
			seen[part] = true
		elif not error.warning:
			failures.append("%s: %s" % [error.where, error.text])
	for part in _expected:
		if not seen.has(part):
			failures.append("expected an error with the words: " + part)


func _expectation(text: String) -> String:
	for part in _expected:
		if text.contains(part):
			return part
	return ""


func _is_number(value: Variant) -> bool:
	return value is float or value is int


func _fail(what: String, message: String) -> bool:
	var where := get_script().resource_path as String
	for entry in get_stack():
		if not entry.source.ends_with("tests/case.gd") and not entry.source.ends_with("tests/runner.gd"):
			where = "%s:%d" % [entry.source, entry.line]
			break
	failures.append("%s: %s%s" % [where, what, " (%s)" % message if message else ""])
	return false

# SPDX-License-Identifier: MIT
## What a test extends: `extends "res://tests/case.gd"`.
##
## The runner makes a new instance for each function test_*(), puts it into the tree, calls it (it may await) and frees
## it with all its children. Optional: `func before()` and `func after()`, which may await as well. A failed check is
## noted and the test goes on; where that makes no sense, `if not assert_...(): return`.
## An error that the engine or a script reports while a test runs fails it, unless the test expects it (expect_error).
@tool
extends Node3D

const MOST_TEXT := 200  # characters of a value in a failure
const MOST_FAILURES := 5  # of a test that are printed
const PATIENCE := 300.0  # seconds; on a busy machine a thread or a driver may take long for what else takes it a moment

var failures: Array[String] = []
var skipped := ""
var checks := 0  # assertions so far, and errors that the test expects
var _expected: Array[String] = []
var _allowed: Array[String] = []


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
	checks += 1
	return value or _fail("expected true", message)


func assert_false(value: bool, message := "") -> bool:
	checks += 1
	return not value or _fail("expected false", message)


func assert_eq(got: Variant, expected: Variant, message := "") -> bool:
	checks += 1
	var same := typeof(got) == typeof(expected) or _is_number(got) and _is_number(expected)
	return same and got == expected or _fail(_difference(got, expected), message)


func assert_ne(got: Variant, unexpected: Variant, message := "") -> bool:
	checks += 1
	var same := typeof(got) == typeof(unexpected) or _is_number(got) and _is_number(unexpected)
	return not (same and got == unexpected) or _fail("expected anything but " + _shortened(unexpected), message)


## Checks that `got` is within `tolerance` of `expected`: numbers, or vectors by their distance. NaN is near nothing.
func assert_near(got: Variant, expected: Variant, tolerance: float, message := "") -> bool:
	checks += 1
	var off: float = absf(got - expected) if _is_number(got) else (got - expected).length()
	var words := [_shortened(expected), tolerance, _shortened(got), off]
	return off <= tolerance or _fail("expected %s within %s, got %s (off by %s)" % words, message)


func assert_less(got: Variant, bound: Variant, message := "") -> bool:
	checks += 1
	return got < bound or _fail("expected less than %s, got %s" % [_shortened(bound), _shortened(got)], message)


func assert_greater(got: Variant, bound: Variant, message := "") -> bool:
	checks += 1
	return got > bound or _fail("expected more than %s, got %s" % [_shortened(bound), _shortened(got)], message)


func fail(message: String) -> bool:
	return _fail(_shortened(message), "")


## Leaves the test out: `skip("no GPU"); return`. Skips are named and counted.
func skip(reason: String) -> void:
	skipped = reason


## Expects an error or warning whose text contains `part`, at least once; any number of them is then no failure.
func expect_error(part: String) -> void:
	checks += 1
	_expected.append(part)


## Allows errors whose text contains `part`: they say nothing about the test, such as errors in what a script does.
func allow_error(part: String) -> void:
	_allowed.append(part)


## Judges the errors that were reported while the test ran; for the runner.
func judge(errors: Array) -> void:
	var seen := {}
	for error: Dictionary in errors:
		var part := _expectation(error.text)
		if part:
			seen[part] = true
		elif not error.warning:
			failures.append("%s: %s" % [error.where, _shortened(error.text)])
	for part in _expected:
		if not seen.has(part):
			failures.append("expected an error with the words: " + part)
	if checks == 0 and not failures and not skipped:
		failures.append("%s: the test checks nothing" % get_script().resource_path)


## Returns the failures in a few lines; for the runner.
func summary() -> String:
	var text := " | ".join(failures.slice(0, MOST_FAILURES))
	return text + (" | and %d more" % (failures.size() - MOST_FAILURES) if failures.size() > MOST_FAILURES else "")


## Removes a folder with its files.
func remove_folder(folder: String) -> void:
	for file in DirAccess.get_files_at(folder):
		DirAccess.remove_absolute(folder.path_join(file))
	DirAccess.remove_absolute(folder)


func _expectation(text: String) -> String:
	for part in _expected + _allowed:
		if text.contains(part):
			return part
	return ""


func _is_number(value: Variant) -> bool:
	return value is float or value is int


## Returns what differs; of long arrays the first elements that do, since a tile's knots fill pages.
func _difference(got: Variant, expected: Variant) -> String:
	if typeof(got) != typeof(expected) or typeof(got) < TYPE_ARRAY or str(got).length() + str(expected).length() <= MOST_TEXT:
		return "expected %s, got %s" % [_shortened(expected), _shortened(got)]
	if got.size() != expected.size():
		return "expected %d elements, got %d" % [expected.size(), got.size()]
	for i: int in got.size():
		if typeof(got[i]) != typeof(expected[i]) or got[i] != expected[i]:
			return "element %d of %d: expected %s, got %s" % [i, got.size(), _shortened(expected[i]), _shortened(got[i])]
	return "NaN differs from itself"


func _shortened(value: Variant) -> String:
	var text := str(value)
	return text if text.length() <= MOST_TEXT else "%s... (%d characters)" % [text.left(MOST_TEXT), text.length()]


func _fail(what: String, message: String) -> bool:
	var where := get_script().resource_path as String
	for entry in get_stack():
		if not entry.source.ends_with("tests/case.gd") and not entry.source.ends_with("tests/runner.gd"):
			where = "%s:%d" % [entry.source, entry.line]
			break
	failures.append("%s: %s%s" % [where, what, " (%s)" % _shortened(message) if message else ""])
	return false

# SPDX-License-Identifier: MIT
## Runs the tests of one layer: `godot [--headless] --path godot_project res://tests/runner.tscn -- --layer=headless`
## (or gpu), optionally with `--only=PART[,PART...]` of tests' names. `./grass test` does that and adds up the layers. Those in
## res://tests/drivers belong to the layer `gpu`, and run under a Vulkan layer (tools/test/drivers.py). The layer `editor` runs inside the
## editor: res://tests/editor/driver.gd puts this scene into it. In an export that begins with this scene (`./grass export OUT --tests`) it
## wants `--fixed-fps 60 -- --layer=gpu`, and adds up by itself.
##
## Finds res://tests/LAYER/test_*.gd. For tools/test/testing.py, which also finds out what had not run if the engine dies, it prints a line
## `GRASS-TEST plan NAME`, later `run NAME`, then `pass NAME`, `fail NAME: reason` or `skip NAME: reason`.
@tool
extends Node

const TIME_LIMIT := 900.0  # seconds; a test that takes longer is taken for hung, unless --limit=SECONDS says otherwise. A few wait for what
# may take Case.PATIENCE.
const Case := preload("res://tests/case.gd")
const FieldCase := preload("res://tests/field_case.gd")


## Collects the errors of the engine and of scripts, from any thread.
class Listener:
	extends Logger
	var _errors: Array = []
	var _mutex := Mutex.new()

	func _log_error(
		function: String, file: String, line: int, code: String, rationale: String, _notify: bool, type: int, traces: Array[ScriptBacktrace]
	) -> void:
		var where := "%s:%d in %s" % [file, line, function]
		for trace in traces:
			if trace.get_frame_count() > 0 and not file.ends_with(".gd"):  # an error in a script says where itself
				where = "%s:%d" % [trace.get_frame_file(0), trace.get_frame_line(0)]
				break
		_mutex.lock()
		_errors.append({text = rationale if rationale else code, where = where, warning = type == ERROR_TYPE_WARNING})
		_mutex.unlock()

	func take() -> Array:
		_mutex.lock()
		var taken := _errors
		_errors = []
		_mutex.unlock()
		return taken


var _listener := Listener.new()
var _passed := 0
var _failed := 0
var _skipped := 0
var _done := false


func _ready() -> void:
	if Engine.is_editor_hint() and _argument("layer", "") != "editor":
		return  # somebody looks at the scene
	if OS.has_feature("template") and not await _are_frames_fixed():
		printerr("The tests want frames of 1/60 s: add `--fixed-fps 60` before `--`.")
		get_tree().quit(2)
		return
	OS.add_logger(_listener)
	var plan := _plan(_argument("layer", "headless"), _argument("only", ""))
	for test: Dictionary in plan:
		_report("plan", test.name)
	await get_tree().process_frame
	if RenderingServer.get_rendering_device() and not Engine.is_editor_hint() and _argument("layer", "") != "drivers":
		_hide_window()
		get_tree().set_meta("first_field", await FieldCase.warm_up(self))  # no static variable: it would keep scripts alive for ever
	for test: Dictionary in plan:
		await _run(test)
	OS.remove_logger(_listener)
	if OS.has_feature("template"):  # elsewhere tools/test/testing.py adds up
		print("%d passed, %d failed%s" % [_passed, _failed, ", %d skipped" % _skipped if _skipped else ""])
		_failed += 0 if plan else 1  # nothing was tested
	for frame in 3:  # the audio thread lets sounds of the last tests fade, then frames free them
		OS.delay_msec(50)
		await get_tree().process_frame
	get_tree().quit(1 if _failed else 0)


## Tests draw in views of their own. A window that is not drawn needs no picture copied to the screen, nor waits for it.
func _hide_window() -> void:
	RenderingServer.viewport_set_update_mode(get_tree().root.get_viewport_rid(), RenderingServer.VIEWPORT_UPDATE_DISABLED)


## Returns whether frames last 1/60 s of the scene's time: nobody tells a script of the engine's own arguments.
func _are_frames_fixed() -> bool:
	for i in 5:
		await get_tree().process_frame
		if not is_equal_approx(get_process_delta_time(), 1.0 / 60.0):
			return false
	return true


func _argument(key: String, fallback: String) -> String:
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with("--%s=" % key):
			return argument.trim_prefix("--%s=" % key)
	return fallback


## Returns every test of `layer` whose name contains one of `only`'s parts: {name, path, function}. A script that does not load is one too.
func _plan(layer: String, only: String) -> Array:
	var plan := []
	for file in ResourceLoader.list_directory("res://tests/" + layer):  # in an export, too, where they have other names on disk
		if not (file.begins_with("test_") and file.ends_with(".gd")):
			continue
		var path := "res://tests/%s/%s" % [layer, file]
		for function in _functions(path):
			var test_name := "%s/%s.%s" % [layer, file.get_basename(), function]
			if not _is_wanted(path, function):
				continue
			if not only or Array(only.split(",")).any(func(part: String) -> bool: return test_name.contains(part)):
				plan.append({name = test_name, path = path, function = function})
	return plan


## With `--drawn=yes` those tests run that need a window, which their script lists as DRAWN; with `--drawn=no` all others. With
## `--motion=yes` those of scripts with a constant MOTION_VECTORS run, with `--motion=no` all others: once a frame had motion vectors, the
## engine makes each shader for them as well, which takes half as long again.
func _is_wanted(path: String, function: String) -> bool:
	var script := load(path) as GDScript
	var constants := script.get_script_constant_map() if script else {}
	return _is_chosen("drawn", constants.get("DRAWN", []).has(function)) and _is_chosen("motion", constants.has("MOTION_VECTORS"))


func _is_chosen(argument: String, has: bool) -> bool:
	return _argument(argument, "") == "" or (_argument(argument, "") == "yes") == has


func _functions(path: String) -> Array:
	var script := load(path) as GDScript
	if not script or not script.can_instantiate():
		return ["loads"]
	var names := script.get_script_method_list().map(func(method: Dictionary) -> String: return method.name)
	var tests := names.filter(func(method: String) -> bool: return method.begins_with("test_"))
	return tests if tests else ["has_tests"]


func _run(test: Dictionary) -> void:
	_report("run", test.name)
	_listener.take()
	var script := load(test.path) as GDScript
	var case: Node = script.new() if script and script.can_instantiate() else null
	if not case or not case.is_class("Node3D") or not case.has_method("judge") or not case.has_method(test.function):
		if case:
			case.free()
		_finish(test.name, '%s: does not load, has no test_*() or does not extend "res://tests/case.gd"' % test.path, "")
		return
	add_child(case)
	_done = false
	_call(case, test.function)
	var limit := float(_argument("limit", str(TIME_LIMIT)))
	var deadline := Time.get_ticks_msec() + limit * 1000
	while not _done and Time.get_ticks_msec() < deadline:
		await get_tree().process_frame
	if not _done:
		case.fail("still running after %d s" % limit)
	remove_child(case)
	for child in case.get_children():
		child.free()
	await get_tree().process_frame  # what was put off until now may report errors too
	case.judge(_listener.take())
	_finish(test.name, case.summary(), case.skipped)
	case.free()


func _call(case: Node, function: String) -> void:
	if case.has_method("before"):
		await case.call("before")
	await case.call(function)
	if case.has_method("after"):
		await case.call("after")
	_done = true


func _finish(test_name: String, failure: String, skipped: String) -> void:
	if failure:
		_failed += 1
		_report("fail", "%s: %s" % [test_name, failure])
	elif skipped:
		_skipped += 1
		_report("skip", "%s: %s" % [test_name, skipped])
	else:
		_passed += 1
		_report("pass", test_name)


func _report(what: String, text: String) -> void:
	print("GRASS-TEST %s %s" % [what, text])

# SPDX-License-Identifier: MIT
## Runs the code blocks of the documentation: those in the list that tools/pages/snippets.py wrote into the folder GRASS_SNIPPETS.
##
## What a block must do stands in guides.gd (pages) or classes.gd (class reference), in a function named as the block's key.
extends "res://tests/runner.gd"

const CHECKS: Array[String] = ["res://tests/docs/guides.gd", "res://tests/docs/classes.gd"]

var _blocks := {}  # by key


func _plan(layer: String, only: String) -> Array:
	var plan := []
	var listed: Array = JSON.parse_string(FileAccess.get_file_as_string(OS.get_environment("GRASS_SNIPPETS").path_join("blocks.json")))
	for block: Dictionary in listed:
		_blocks[block.key] = block
		var test_name := "%s/%s" % [layer, block.name]
		if not only or test_name.contains(only):
			plan.append({name = test_name, path = _checks_of(block.key), function = block.key})
	return plan


func _checks_of(key: String) -> String:
	for path in CHECKS:
		var script := load(path) as GDScript
		if script and script.get_script_method_list().any(func(method: Dictionary) -> bool: return method.name == key):
			return path
	return ""


func _run(test: Dictionary) -> void:
	if test.path:
		await super(test)
		return
	_report("run", test.name)
	_finish(test.name, "no function %s() in guides.gd or classes.gd says what this block must do" % test.function, "")


func _call(case: Node, function: String) -> void:
	case.block = _blocks[function]
	var script: GDScript = case.block_script()
	if script and script.can_instantiate():
		super(case, function)
		return
	case.fail("the block does not parse")  # where, the engine said
	_done = true

# SPDX-License-Identifier: MIT
## Runs the test cases of tests/binding/runtime; ends with 1 if one of them failed.
extends SceneTree


func _initialize() -> void:
	var tests: RefCounted = ClassDB.instantiate("BindingTests")
	quit(tests.call("run") if tests else 1)

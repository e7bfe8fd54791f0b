# SPDX-License-Identifier: MIT
## The driver refuses the pass that chooses what is drawn, before any field is made. The passes that it has compiled by then are freed all
## the same: the runner counts leaks at exit, so this script has no other test, whose field might free them.
extends "res://tests/drivers/refused_case.gd"

const LONGER_THAN_COMPILING := 0.5  # s of the clock; the first pass takes a fifth of this on software Vulkan


func test_passes_of_no_field_are_freed() -> void:
	expect_refusal(["cull"])
	var field := GrassField.new()
	viewport.add_child(field)
	field.free()  # before the frame that would make it
	var begin := Time.get_ticks_msec()
	await wait_until(func() -> bool: return Time.get_ticks_msec() - begin > 1000.0 * LONGER_THAN_COMPILING, "the pass is refused")
	field = GrassField.new()
	field.size = Vector2(4, 4)
	field.process_mode = Node.PROCESS_MODE_DISABLED  # a tick would make the field before the refusal is looked up
	viewport.add_child(field)
	await wait_until(func() -> bool: return said.count == 1, "the field knows of the refusal")
	assert_eq(field.get_statistics().backend, "CPU")
	field.free()

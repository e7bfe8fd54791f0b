# SPDX-License-Identifier: MIT
## The driver refuses, from the start, the pass that reads blades back. A game must not get places where the blades are not.
extends "res://tests/drivers/refused_case.gd"


func test_questions_are_answered() -> void:
	expect_refusal(["gather"])
	var field := add_seen_field({soil_enabled = false})
	await assert_lives(field, "CPU")  # asks for knots
	assert_eq(said.warnings, 1)
	assert_eq(said.count, 1)

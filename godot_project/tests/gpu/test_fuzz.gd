# SPDX-License-Identifier: MIT
extends "res://tests/fuzz_case.gd"


func test_any_property_in_any_order() -> void:
	await fuzz(17, 25)

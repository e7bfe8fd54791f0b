# SPDX-License-Identifier: MIT
## Wheels press grass on the GPU as they do on the CPU.
extends "res://tests/headless/test_vehicles.gd"


func after() -> void:
	for field: GrassField in find_children("*", "GrassField", true, false):
		assert_eq(field.get_statistics().backend, "GPU")

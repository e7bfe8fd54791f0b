# SPDX-License-Identifier: MIT
## What wheels do to grass on the CPU they do on the GPU.
extends "res://tests/headless/test_vehicles.gd"


func after() -> void:
	for field: GrassField in find_children("*", "GrassField", true, false):
		assert_eq(field.get_statistics().backend, "GPU")

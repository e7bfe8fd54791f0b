# SPDX-License-Identifier: MIT
## Bones bend grass on the GPU as they do on the CPU.
extends "res://tests/headless/test_bones.gd"


func after() -> void:
	for field: GrassField in find_children("*", "GrassField", true, false):
		assert_eq(field.get_statistics().backend, "GPU")

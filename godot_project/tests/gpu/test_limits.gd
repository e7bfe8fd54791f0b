# SPDX-License-Identifier: MIT
## A pool larger than the device's largest storage buffer gets as many tiles as fit, and a warning.
extends "res://tests/view_case.gd"

const HELD := 6241  # slots of 21,504 bytes in 128 MiB, which Vulkan promises
const LARGER := ["NVIDIA", "AMD", "Intel"]  # whose devices hold more, see extension/gpu/obstacles.cpp


func test_a_pool_keeps_to_the_device_s_limit() -> void:
	if RenderingServer.get_rendering_device().get_device_vendor_name() in LARGER:
		skip("this device's storage buffers are larger")
		return
	expect_error("`pool_tiles` is %d, but the graphics device has room for %d" % [HELD + 1, HELD])
	var field := add_seen_field({pool_tiles = HELD})
	await drawn()
	assert_eq(field.get_counters().pool_tiles, HELD)
	assert_eq(field.get_statistics().backend, "GPU")
	field.pool_tiles = HELD + 1
	await drawn()
	assert_eq(field.get_counters().pool_tiles, HELD)
	field.backend = GrassField.BACKEND_CPU
	await drawn()
	assert_eq(field.get_counters().pool_tiles, HELD + 1, "memory of the CPU has no such limit")

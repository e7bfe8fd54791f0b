# SPDX-License-Identifier: MIT
## What the driver takes to make and free buffers and textures of several sizes: the call, and the frames in which and after which it was
## done, against a frame in which nothing was.
extends Node3D

const Scenery := preload("res://bench/scenery.gd")
const Measure := preload("res://bench/measure.gd")
const SIZES: Array[int] = [1, 4, 16, 32, 64, 96]  # MB
const ROUNDS := 3
const KINDS := ["buffer", "buffer, cleared", "texture"]
const IDLE := 20  # frames

var _device: RenderingDevice


func run(_software: bool) -> Array[PackedStringArray]:
	_device = RenderingServer.get_rendering_device()
	var camera := Scenery.add_camera(self)
	var rows: Array[PackedStringArray] = [
		["what", "mb", "round", "idle_ms", "make_ms", "clear_ms", "frame_ms", "next_ms", "third_ms", "free_worst_ms"]
	]
	await _frames(60)
	for kind: String in KINDS:
		for size in SIZES:
			for turn in ROUNDS:
				rows.append(await _measure(kind, size, turn))
				print(", ".join(rows[-1]))
	camera.queue_free()
	return rows


func _measure(p_kind: String, p_size: int, p_turn: int) -> PackedStringArray:
	var idle := Measure.median(await _frames(IDLE))
	var begin := Time.get_ticks_usec()
	var made := _make_texture(p_size) if p_kind == "texture" else _device.storage_buffer_create(p_size << 20)
	var made_at := Time.get_ticks_usec()
	if p_kind == "buffer, cleared":
		_device.buffer_clear(made, 0, p_size << 20)
	elif p_kind == "buffer":
		_device.buffer_clear(made, 0, 16)  # it is used
	else:
		_device.texture_clear(made, Color(), 0, 1, 0, 1)
	var cleared_at := Time.get_ticks_usec()
	var after := await _frames(3)
	after[0] += (cleared_at - begin) * 1e-3
	await _frames(10)
	_device.free_rid(made)
	var free := await _frames(6)
	var row := PackedStringArray([p_kind, str(p_size), str(p_turn)])
	for ms: float in [idle, (made_at - begin) * 1e-3, (cleared_at - made_at) * 1e-3, after[0], after[1], after[2], free.max()]:
		row.append("%.3f" % ms)
	return row


func _make_texture(p_size: int) -> RID:
	var format := RDTextureFormat.new()
	format.format = RenderingDevice.DATA_FORMAT_R16G16B16A16_SFLOAT
	format.width = 1024
	format.height = 128 * p_size
	format.usage_bits = RenderingDevice.TEXTURE_USAGE_STORAGE_BIT | RenderingDevice.TEXTURE_USAGE_SAMPLING_BIT
	format.usage_bits |= RenderingDevice.TEXTURE_USAGE_CAN_COPY_FROM_BIT | RenderingDevice.TEXTURE_USAGE_CAN_COPY_TO_BIT
	return _device.texture_create(format, RDTextureView.new())


## Returns milliseconds of each of p_count frames.
func _frames(p_count: int) -> Array[float]:
	var times: Array[float] = []
	var before := Time.get_ticks_usec()
	for i in p_count:
		await RenderingServer.frame_post_draw
		var now := Time.get_ticks_usec()
		times.append((now - before) * 1e-3)
		before = now
	return times

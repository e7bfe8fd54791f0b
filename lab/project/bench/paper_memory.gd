# SPDX-License-Identifier: MIT
## Memory of the pool and of the patch: as the field counts it, and by how much the engine's own count of textures grows with the first
## field. Bytes, not times: the same on any GPU.
extends Node3D

const Table := preload("res://bench/table.gd")

const POOL := 4096  # tiles, as in the paper

var _textures := 0  # bytes that the engine counts while the last field stood


func run(r_table: Table, _p_software: bool) -> void:
	r_table.columns(["what", "bytes", "outcome"])
	for i in 4:  # the viewport's own textures come with its first frames
		await RenderingServer.frame_post_draw
	var before := RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TEXTURE_MEM_USED)
	_textures = 0
	var least := await _memory(0.5, 0)
	r_table.add({what = "patch", bytes = _textures - before, outcome = "ok" if _textures > before else "the engine counts no textures"})
	r_table.add({what = "pool", bytes = await _memory(0.5, POOL) - least})
	for side: float in [64.0, 256.0]:
		r_table.add({what = "all of a field of %d blades" % (side * side * 256.0), bytes = await _memory(side, POOL)})


func _memory(p_side: float, p_pool: int) -> int:
	var field := GrassField.new()
	field.size = Vector2(p_side, p_side)
	field.simulated = p_pool > 0
	field.pool_tiles = p_pool
	add_child(field)
	await get_tree().process_frame
	await get_tree().process_frame
	var bytes := field.get_memory_usage()
	_textures = RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TEXTURE_MEM_USED)
	field.queue_free()
	await get_tree().process_frame
	return bytes

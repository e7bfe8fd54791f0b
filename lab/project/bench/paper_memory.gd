# SPDX-License-Identifier: MIT
## Memory of the pool and of the patch: as the field counts it, and by how much the engine's own count of textures grows with the first
## field. Bytes, not times: the same on any GPU.
extends Node3D

const Table := preload("res://bench/table.gd")

const POOL := 4096  # tiles, as in the paper
const TICKS := 600  # at most, until a tile is awake: passes are compiled first

var _textures := 0  # bytes that the engine counts while the last field stood


func run(r_table: Table, _p_software: bool) -> void:
	r_table.columns(["what", "bytes", "outcome"])
	for i in 4:  # the viewport's own textures come with its first frames
		await RenderingServer.frame_post_draw
	var before := RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TEXTURE_MEM_USED)
	_textures = 0
	await _memory(0.5)
	r_table.add({what = "patch", bytes = _textures - before, outcome = "ok" if _textures > before else "the engine counts no textures"})
	r_table.add({what = "pool", bytes = await _slot_bytes() * POOL})
	for side: float in [64.0, 256.0]:
		r_table.add({what = "all of a field of %d blades" % (side * side * 256.0), bytes = await _memory(side)})


## Returns what a field at rest holds.
func _memory(p_side: float) -> int:
	var field := GrassField.new()
	field.size = Vector2(p_side, p_side)
	field.pool_tiles = POOL
	add_child(field)
	await get_tree().process_frame
	await get_tree().process_frame
	var bytes := field.get_memory_usage()
	_textures = RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TEXTURE_MEM_USED)
	field.queue_free()
	await get_tree().process_frame
	return bytes


## Returns the bytes of an awake tile's slot: a pool is as large as the most tiles that were awake.
func _slot_bytes() -> int:
	var field := GrassField.new()
	field.size = Vector2(8.0, 8.0)
	field.simulation_detail = GrassField.SIMULATION_WHOLE
	add_child(field)
	var ball := SphereShape3D.new()
	ball.radius = 2.0
	var mover := Node3D.new()
	add_child(mover)
	field.register_collider(mover, ball)
	var counters := {}
	for tick in TICKS:
		mover.position.x += 0.02
		await get_tree().physics_frame
		counters = field.get_counters()
		if counters.pool_slots > 0:
			break
	field.queue_free()
	mover.queue_free()
	return counters.pool_bytes / maxi(counters.pool_slots, 1)

# SPDX-License-Identifier: MIT
## The paper's table 1: frame time against tiles and blades a tile, with and without level of detail. A tile of ours always
## has 64 blades: tiles of 128, 256 and 512 become 2, 4 and 8 of ours on the same ground. 4x MSAA as in the paper.
extends Node3D

const FrameTimer := preload("res://bench/frame_timer.gd")
const Scenery := preload("res://bench/scenery.gd")
const Table := preload("res://bench/table.gd")

const TILES: Dictionary[String, Vector2i] = {"2K": Vector2i(64, 32), "4K": Vector2i(64, 64), "8K": Vector2i(128, 64)}
const TILE := 0.5  # metres
const SECONDS := 0.6  # of drawing, at most, for a row
const BLADES: Array[int] = [64, 128, 256, 512]  # a tile
## none: every blade with 15 segments. blades: fewer far away, as in the paper. all: fewer where they
## are thin, and fewer segments, too; the default.
const LODS: Dictionary[String, Dictionary] = {
	"none": {lod_far = 10000.0, lod_error = 0.0, pixels_min = 0.0},
	"blades": {lod_error = 0.0, pixels_min = 0.0},
	"all": {},
}


func run(r_table: Table, p_software: bool) -> void:
	var timer := FrameTimer.new(get_viewport(), p_software)
	timer.seconds = SECONDS
	var camera := Scenery.add_camera(self)
	Scenery.add_sun(self, false)
	get_viewport().msaa_3d = Viewport.MSAA_4X
	r_table.columns(
		["tiles", "blades_a_tile", "blades", "view", "lod", "gpu_ms", "wall_ms", "cull_ms", "drawn_blades", "drawn_triangles", "outcome"]
	)
	for tiles: String in ["2K"] if p_software else TILES.keys():
		for blades: int in [64, 128] if p_software else BLADES:
			for view: String in ["above"] if p_software else ["above", "eye"]:
				for lod in LODS:
					r_table.add(await _measure(timer, camera, tiles, blades, view, lod, 8 if p_software else 1))
	get_viewport().msaa_3d = Viewport.MSAA_DISABLED


## p_divisor: of the field's sides, for software.
func _measure(
	p_timer: FrameTimer, p_camera: Camera3D, p_tiles: String, p_blades: int, p_view: String, p_lod: String, p_divisor: int
) -> Dictionary:
	var field := GrassField.new()
	field.simulated = false
	field.measure_time = true
	field.size = Vector2(TILES[p_tiles]) * TILE / p_divisor
	field.density = p_blades / (TILE * TILE)
	for property: String in LODS[p_lod]:
		field.set(property, LODS[p_lod][property])
	add_child(field)
	FrameTimer.look(p_camera, p_view, field.size.x)
	var times := await p_timer.measure(p_camera)
	var statistics := field.get_statistics()
	field.queue_free()
	await get_tree().process_frame
	var row := {
		tiles = p_tiles,
		blades_a_tile = p_blades,
		blades = statistics.blades,
		view = p_view,
		lod = p_lod,
		gpu_ms = times.gpu_ms,
		wall_ms = times.wall_ms,
		cull_ms = statistics.cull_ms,
		drawn_blades = statistics.drawn_blades,
		drawn_triangles = statistics.drawn_triangles
	}
	if statistics.drawn_blades == 0:
		row.outcome = "nothing was drawn"
	return row

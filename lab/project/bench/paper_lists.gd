# SPDX-License-Identifier: MIT
## The saving by the list of objects of each tile (paper 4.1): the simulation pass alone, with the list, and with all objects of the scene
## in every tile. Balls lie at random; the tiles that they touch are awake.
extends Node

const SimulateData := preload("res://bench/simulate_data.gd")
const SimulatePass := preload("res://bench/simulate_pass.gd")
const Table := preload("res://bench/table.gd")

const OBJECTS: Array[int] = [512, 256, 128, 64, 32, 16, 8]  # the most first, so that the clock has risen
const TILES := 160  # along a side of the field
const TILE := 0.5  # metres
const LENGTH := 0.5  # of a blade, metres
const RADIUS := 0.3  # of a ball, metres
const STEPS := 20
const BATCHES := 3
const WARM_UP := 0.2  # seconds
const KNOTS := 16
const PATCH_BLADES := 16384
const PATCH_WIDTH := 1024
enum { DIRECT, PBD }

var _pass: SimulatePass
var _software := false


func run(p_spirv: String, r_table: Table, p_software: bool) -> void:
	_software = p_software
	r_table.columns(["method", "objects", "list", "awake_tiles", "entries_a_tile", "simulate_ms", "outcome"])
	var device := SimulatePass.make_device()
	_pass = SimulatePass.new()
	var error := "no RenderingDevice" if device == null else _pass.load_shader(device, p_spirv.path_join("simulate_%d.spv" % KNOTS))
	var patch := _patch_texels()
	for method: int in [DIRECT, PBD]:
		for objects: int in [16, 8] if p_software else OBJECTS:
			for is_listed: bool in [true, false]:
				var row := {method = "DIRECT" if method == DIRECT else "PBD", objects = objects, list = "tile" if is_listed else "scene"}
				if error:
					row.outcome = error
				else:
					row.merge(_measure(method, objects, is_listed, patch))
				r_table.add(row)
				await get_tree().process_frame
	if device != null:
		_pass.free_all()
		device.free()


func _measure(p_method: int, p_objects: int, p_is_listed: bool, p_patch: PackedByteArray) -> Dictionary:
	var random := RandomNumberGenerator.new()
	random.seed = 11
	var touched: Dictionary[Vector2i, PackedInt32Array] = {}
	var colliders := PackedByteArray()
	for i in p_objects:
		var place := Vector2(random.randf(), random.randf()) * (TILES * TILE - 4.0) + Vector2(2.0, 2.0)
		var way := Vector2.from_angle(random.randf() * TAU) * 0.02  # metres in the step
		colliders.append_array(_collider(place, way))
		var half := Vector2.ONE * (RADIUS + LENGTH)
		var first := Vector2i(((place - half) / TILE).floor())
		var last := Vector2i(((place + half) / TILE).floor())
		for z in range(first.y, last.y + 1):
			for x in range(first.x, last.x + 1):
				if not touched.has(Vector2i(x, z)):
					touched[Vector2i(x, z)] = PackedInt32Array()
				touched[Vector2i(x, z)].append(i)
	var list := PackedInt32Array() if p_is_listed else PackedInt32Array(range(p_objects))
	var words := PackedInt32Array()
	var entries := 0
	var slot := 0
	for tile in touched:
		var own := touched[tile] if p_is_listed else list
		entries += own.size()
		words.append_array(
			SimulateData.slot_words(
				tile.x,
				tile.y,
				slot,
				slot * 8 % (PATCH_BLADES - SimulatePass.BLADES),
				list.size() if p_is_listed else 0,
				own.size(),
				SimulatePass.FRESH
			)
		)
		if p_is_listed:
			list.append_array(own)
		slot += 1
	var tiles := touched.size()
	if not _pass.set_up(
		tiles, KNOTS, p_patch, RenderingDevice.DATA_FORMAT_R16G16B16A16_SFLOAT, PATCH_WIDTH, words.to_byte_array(), colliders, list
	):
		return {awake_tiles = tiles, outcome = "no room on the device"}
	var push := SimulateData.push(p_method, KNOTS, TILE, TILES, Vector3.ZERO)
	_pass.step(push, tiles)
	_pass.pause()
	for tile in tiles:  # no longer fresh
		words[tile * SimulatePass.SLOT_WORDS + 7] = 0
	_pass.device.buffer_update(_pass.slots, 0, words.size() * 4, words.to_byte_array())
	var start := Time.get_ticks_msec()
	while Time.get_ticks_msec() - start < WARM_UP * 1e3 and not _software:
		_pass.time(push, tiles, STEPS)
	var best := INF
	for batch in 1 if _software else BATCHES:
		best = minf(best, _pass.time(push, tiles, 2 if _software else STEPS))
	return {awake_tiles = tiles, entries_a_tile = float(entries) / tiles, simulate_ms = best}


## Relative to the field's first tile, whose centre is half a tile from the field's corner.
func _collider(p_place: Vector2, p_way: Vector2) -> PackedByteArray:
	var now := p_place - Vector2.ONE * 0.5 * TILE
	var before := now - p_way
	return (
		PackedFloat32Array([0, 0, 0, 0, now.x, 0.25, now.y, 0.5, 0, 0, 0, 1, before.x, 0.25, before.y, 0, 0, 0, 0, 1, RADIUS, 0, 0, 0])
		. to_byte_array()
	)


func _patch_texels() -> PackedByteArray:
	return SimulateData.patch_texels(PATCH_WIDTH, PATCH_BLADES, KNOTS, LENGTH)

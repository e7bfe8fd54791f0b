# SPDX-License-Identifier: MIT
## A field on a terrain that is asked by the names of its methods (docs/guide/terrain.md), for the tests of terrains.
extends "res://tests/fill_case.gd"

const PlainTerrain := preload("res://tests/terrains/plain_terrain.gd")
const BulkTerrain := preload("res://tests/terrains/bulk_terrain.gd")
const Terrain3DLike := preload("res://tests/terrains/terrain_3d_like.gd")
const HTerrainLike := preload("res://tests/terrains/h_terrain_like.gd")
const Hills := preload("res://tests/terrains/hills.gd")


func add_terrain(terrain: Node) -> Node:
	terrain.name = "Terrain"
	add_child(terrain)
	return terrain


func hills_of(terrain: Node) -> Hills:
	return terrain.data.hills if terrain is Terrain3DLike else terrain.hills


func all_kinds() -> Array[Node]:
	return [PlainTerrain.new(), Terrain3DLike.new(), HTerrainLike.new(), HTerrainLike.new(true)]


func field_on(properties := {}) -> GrassField:
	var field := add_field({size = Vector2(40, 24), density = 10.0, terrain = NodePath("../Terrain")}.merged(properties, true))
	await read(field)
	return field


func counter(field: GrassField, key: String) -> int:
	return field.get_counters()[key]


## Frames until nothing of the terrain waits and the rule has followed.
func read(field: GrassField) -> void:
	await frames(1)
	await wait_until(
		func() -> bool:
			var now := field.get_statistics().merged(field.get_counters())
			return now.terrain_waiting == 0 and now.fill_waiting == 0 and now.map_waiting == 0 and not now.waiting,
		"the terrain is read"
	)


## Returns how far the roots of some blades are from the hills, metres.
func off_the_hills(field: GrassField, hills: Hills, place := Vector3.ZERO) -> float:
	var most := 0.0
	var count := field.get_grid_size()
	for x: int in [0, count.x / 3, count.x - 1]:
		for z: int in [0, count.y / 2, count.y - 1]:
			var root := field.get_knots(Vector2i(x, z), 20)[0] - place
			most = maxf(most, absf(root.y - hills.height(root.x, root.z)))
	return most


func remove(nodes: Array) -> void:
	for node: Node in nodes:
		node.free()

# SPDX-License-Identifier: MIT
## A field survives anything that a terrain's script does while the field calls it, in every method of docs/guide/terrain.md.
extends "res://tests/scripts_case.gd"


## A terrain with all methods of docs/guide/terrain.md; `told` hears the name of each that is called.
class Terrain:
	extends Node3D

	signal terrain_changed(area: AABB)

	var told: Callable

	func get_height(_at: Vector3) -> float:
		told.call("get_height")
		return 0.5

	func is_hole(_at: Vector3) -> bool:
		told.call("is_hole")
		return false

	func get_normal(_at: Vector3) -> Vector3:
		told.call("get_normal")
		return Vector3.UP

	func get_texture_id(_at: Vector3) -> int:
		told.call("get_texture_id")
		return 1

	func get_color(_at: Vector3) -> Color:
		told.call("get_color")
		return Color.RED


class BulkTerrain:
	extends Node3D

	var told: Callable

	func get_heights(at: PackedVector3Array) -> PackedFloat32Array:
		told.call("get_heights")
		var heights := PackedFloat32Array()
		heights.resize(at.size())
		return heights


## As Terrain3D and HTerrain: asks another object, which dies with it.
class DataTerrain:
	extends Node3D

	class Data:
		extends RefCounted

		signal region_changed(x: int, z: int, width: int, depth: int, channel: int)

		var told: Callable

		func get_resolution() -> int:
			told.call("get_resolution")
			return 129

		func get_interpolated_height_at(_at: Vector3) -> float:
			told.call("get_interpolated_height_at")
			return 0.5

		func get_map_count(_type: int) -> int:
			told.call("get_map_count")
			return 0

		func get_image(_type: int, _index := 0) -> Image:
			told.call("get_image")
			return null

	var told: Callable:
		set(value):
			told = value
			data.told = value
	var data := Data.new()

	func get_data() -> Data:
		var found := data  # a deed may free this
		told.call("get_data")
		return found

	func get_internal_transform() -> Transform3D:
		told.call("get_internal_transform")
		return Transform3D(Basis(), Vector3(-64, 0, -64))


func add_terrain(terrain: Node3D, method: String) -> void:
	terrain.name = "Terrain"
	terrain.set("told", hear_of.bind(method))
	level.ground.add_child(terrain)


func test_a_terrain_is_asked() -> void:
	allow_error(EMITTING)
	for method: String in ["get_height", "is_hole", "get_normal", "get_texture_id", "get_color"]:
		await try_terrain(Terrain, method)
	await try_terrain(BulkTerrain, "get_heights")
	for method: String in [
		"get_data", "get_internal_transform", "get_resolution", "get_map_count", "get_image", "get_interpolated_height_at"
	]:
		await try_terrain(DataTerrain, method)
	await try_deeds(
		func() -> void:
			var map := full_map()
			map.chunks_changed.connect(hear.unbind(2))
			var field := add_level({map = map})
			add_terrain(Terrain.new(), "")
			field.terrain = field.get_path_to(level.ground.get_child(0))
			await until_heard(),
		"chunks_changed by a terrain"
	)


## Data of a terrain that reports a change while it is read, and then puts the field elsewhere: nothing is read within a reading.
func test_a_terrain_that_changes_while_it_is_read() -> void:
	var depth := [0, 0]  # of readings: now, and at most
	var changes := [0]
	var field := add_level()
	await ticks(2)
	var terrain := DataTerrain.new()
	add_terrain(terrain, "")
	terrain.data.told = func(method: String) -> void:
		if method != "get_interpolated_height_at":
			return
		depth[0] += 1
		depth[1] = maxi(depth[0], depth[1])
		if depth[0] < 3 and changes[0] < 3:
			changes[0] += 1
			terrain.data.region_changed.emit(0, 0, 4, 4, 0)
			remove_and_add(field)
			field.get_density_at(Vector3.ZERO)
		depth[0] -= 1
	field.terrain = field.get_path_to(terrain)
	await wait_until(func() -> bool: return changes[0] == 3, "the terrain is asked")
	assert_eq(depth[1], 1)
	clean_up()


## In a frame of a field that stands, and where the field is made.
func try_terrain(type: Script, method: String) -> void:
	await try_deeds(
		func() -> void:
			var field := add_level()
			await ticks(2)
			add_terrain(type.new(), method)
			field.terrain = field.get_path_to(level.ground.get_child(0))
			await until_heard(),
		method
	)
	await try_deeds(
		func() -> void:
			var field := add_level()
			level.remove_child(field)
			add_terrain(type.new(), method)
			field.terrain = NodePath("../%s/Terrain" % level.ground.name)
			level.add_child(field)
			field.get_density_at(Vector3.ZERO)
			await until_heard(),
		method + " of a field that is made"
	)

# SPDX-License-Identifier: MIT
## Whatever calls a script survives what the script does: every occasion on which a field or a world calls one, times everything that
## it may do meanwhile. `./grass test sanitize` tries all pairs under the address sanitizer; the headless layer frees the level on every
## occasion, and tries a third of the other pairs.
extends "res://tests/world_case.gd"

const LOCKED := "locked"  # the engine's own word to whoever frees what just calls him
const EMITTING := "while a signal is being emitted"  # and of an emitter whose parent was freed


## What deeds do away with: a field on a terrain of its own.
class Level:
	extends Node3D

	var field: GrassField
	var ground := Node3D.new()  # holds the terrain

	func _init() -> void:
		add_child(ground)

	func stands() -> bool:
		return is_instance_valid(field) and field.is_inside_tree()


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


class PlantMesh:
	extends PrimitiveMesh

	var told: Callable

	func _create_mesh_array() -> Array:
		told.call("_create_mesh_array")
		var arrays := []
		arrays.resize(ARRAY_MAX)
		arrays[ARRAY_VERTEX] = PackedVector3Array([Vector3.ZERO, Vector3(0.1, 0.3, 0), Vector3(0, 0.3, 0.1)])
		return arrays


var level: Level
var placed: GrassField  # in it, at first
var heard := 0  # how often the occasion came
var deed := Callable()  # what to do, once


## Calls the script of the occasion that is tried.
func hear() -> void:
	heard += 1
	if deed.is_valid():
		var now := deed
		deed = Callable()
		now.call()


func hear_of(method: String, wanted: String) -> void:
	if method == wanted:
		hear()


func add_level(properties := {}) -> GrassField:
	level = Level.new()
	add_child(level)
	var field := add_field(properties)
	remove_child(field)
	level.add_child(field)
	level.field = field
	placed = field
	return field


func add_terrain(terrain: Node3D, method: String) -> void:
	terrain.name = "Terrain"
	terrain.set("told", hear_of.bind(method))
	level.ground.add_child(terrain)


func other_species() -> Array[GrassSpecies]:
	return [GrassSpecies.new(), GrassSpecies.new()]


## What a script may do, by name.
func deeds() -> Dictionary[String, Callable]:
	return {
		"nothing": func() -> void: pass,
		"free the level": func() -> void: level.free(),
		"free the field": func() -> void: level.field.free(),
		"free the ground": func() -> void: level.ground.free(),
		"free the level later": func() -> void: level.queue_free(),
		"remove the field": func() -> void: level.remove_child(level.field),
		"remove the level": func() -> void: remove_child(level),
		"remove and add the field": func() -> void: remove_and_add(level.field),
		"move the field": func() -> void: level.field.position = Vector3(1e4, 0, 0),
		"no map": func() -> void: level.field.map = null,
		"another map": func() -> void: level.field.map = full_map(),
		"clear the map": clear_map,
		"no terrain": func() -> void: level.field.terrain = NodePath(),
		"another terrain": func() -> void: level.field.terrain = NodePath("../Nobody"),
		"another size": func() -> void: level.field.size = Vector2(3, 5),
		"other species": func() -> void: level.field.species = other_species(),
		"no rule": func() -> void: level.field.fill_rule = null,
		"another rule": func() -> void: level.field.fill_rule = GrassFillRule.new(),
		"not simulated": func() -> void: level.field.simulated = false,
		"ask and cut": ask_and_cut,
	}


func remove_and_add(node: Node) -> void:
	level.remove_child(node)
	level.add_child(node)


func clear_map() -> void:
	if level.field.map:
		level.field.map.clear()


func ask_and_cut() -> void:
	if level.stands():
		level.field.density_at(Vector3.ZERO)
		level.field.cut(ball(0.5), Transform3D())
		level.field.trample(Vector3.ZERO, 0.5, 0.5)


## Runs `occasion`, which calls hear(), with each deed; `but`: deeds that the engine itself does not survive there.
func try_deeds(occasion: Callable, what: String, but: Array[String] = []) -> void:
	var all := deeds()
	var is_full := OS.has_environment("ASAN_OPTIONS")
	var number := what.hash()
	for name_: String in all:
		number += 1
		if name_ in but or not is_full and name_ != "free the level" and number % 3 != 0:
			continue
		heard = 0
		deed = all[name_]
		await occasion.call()
		await ticks(3)
		await frames(3)
		var words := "%s: %s" % [what, name_]
		assert_greater(heard, 0, words + ": the script is called")
		if name_ == "free the level":
			assert_false(is_instance_valid(level), words)
		elif is_instance_valid(level) and level.stands():
			assert_true(is_finite(level.field.density_at(Vector3.ZERO)), words)
		clean_up()
		await ticks(1)


func clean_up() -> void:
	deed = Callable()
	if is_instance_valid(placed) and not placed.get_parent():
		placed.free()
	if is_instance_valid(level):
		level.free()
	for child in get_children():
		if child is PhysicsBody3D:
			child.free()


## Frames until hear() was called, a hundred at most.
func until_heard() -> void:
	for i in 100:
		if heard > 0 or not is_instance_valid(level):
			return
		await ticks(1)
		await frames(1)


func add_bodies() -> Array[AnimatableBody3D]:
	var bodies: Array[AnimatableBody3D] = []
	for i in 4:
		bodies.append(add_held_body(ball(0.2), Vector3(0.8 * i - 1.2, 0.2, 0)))
	return bodies


func test_bodies_enter_and_leave() -> void:
	allow_error(LOCKED)
	allow_error(EMITTING)
	await try_deeds(
		func() -> void:
			add_level().body_entered_grass.connect(hear.unbind(1))
			add_bodies()
			await until_heard(),
		"body_entered_grass"
	)
	await try_deeds(
		func() -> void:
			var field := add_level()
			var bodies := add_bodies()
			await ticks(5)
			field.body_exited_grass.connect(hear.unbind(1))
			for body in bodies:
				body.position.y = 5.0
			await until_heard(),
		"body_exited_grass"
	)
	await try_deeds(
		func() -> void:
			var field := add_level()
			add_bodies()
			await ticks(5)
			field.body_exited_grass.connect(hear.unbind(1))
			field.simulated = false,
		"body_exited_grass without simulation"
	)
	var not_while_leaving: Array[String] = [
		"free the level", "free the field", "free the ground", "remove the field", "remove the level", "remove and add the field"  # the engine takes nothing from a node that is just losing a child
	]
	await try_deeds(
		func() -> void:
			var field := add_level()
			add_bodies()
			await ticks(5)
			field.body_exited_grass.connect(hear.unbind(1))
			level.remove_child(field),
		"body_exited_grass of a field that leaves",
		not_while_leaving
	)


func change_map(field: GrassField, how: String) -> void:
	match how:
		"cut":
			field.cut(ball(0.5), Transform3D())
		"paint":
			field.paint(brush(GrassBrush.TOOL_ERASE, 1.0), Vector3.ZERO, Vector3.ONE)
		"trample":
			field.trample(Vector3.ZERO, 1.0, 0.5)
		"regrow":
			field.regrow(0.1)
		"fill":
			var rule := GrassFillRule.new()
			rule.density = 0.5
			field.fill(rule)
		"bake_ground":
			var slab := HeightMapShape3D.new()
			slab.map_data = [1.0, 1.0, 1.0, 1.0]
			field.bake_ground_from(slab, Transform3D(Basis.from_scale(Vector3(9, 1, 9)), Vector3.ZERO))


func test_the_map_changes() -> void:
	allow_error(EMITTING)
	for change: String in ["cut", "paint", "trample", "regrow", "fill", "bake_ground"]:
		await try_deeds(
			func() -> void:
				var field := add_level({map = full_map()})
				await ticks(2)
				if change == "regrow":
					field.cut(ball(0.5), Transform3D())
				field.map.chunks_changed.connect(hear.unbind(2))
				change_map(field, change),
			"chunks_changed by " + change
		)
	await try_deeds(
		func() -> void:
			var field := add_level({map = full_map()})
			await ticks(2)
			field.map.changed.connect(hear)
			field.cut(ball(0.5), Transform3D()),
		"changed of a map"
	)
	await try_deeds(
		func() -> void:
			var species := GrassSpecies.new()
			species.wear_recovery = 1.0
			var field := add_level({map = full_map(), species = [species] as Array[GrassSpecies]})
			await ticks(2)
			field.trample(Vector3.ZERO, 1.0, 1.0)
			field.map.chunks_changed.connect(hear.unbind(2))
			await until_heard(),
		"chunks_changed by recovery"
	)


func test_a_rule_fills() -> void:
	allow_error(LOCKED)
	allow_error(EMITTING)
	var rule := GrassFillRule.new()
	rule.density = 0.5
	await try_deeds(
		func() -> void:
			var field := add_level({map = full_map(), fill_rule = rule})
			field.fill_finished.connect(hear)
			await until_heard(),
		"fill_finished"
	)
	await try_deeds(
		func() -> void:
			var map := full_map()
			map.chunks_changed.connect(hear.unbind(2))
			add_level({map = map, fill_rule = rule})
			await until_heard(),
		"chunks_changed by a rule"
	)
	await try_deeds(
		func() -> void:
			var field := add_level({map = full_map(), fill_rule = rule})
			await ticks(2)
			await frames(2)
			field.map.chunks_changed.connect(hear.unbind(2))
			field.fill_rule = null,
		"chunks_changed by a rule that goes"
	)
	await try_deeds(
		func() -> void:
			var field := add_level({map = full_map()})
			await ticks(2)
			field.property_list_changed.connect(hear)
			field.fill_rule = rule,
		"property_list_changed"
	)


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
			field.density_at(Vector3.ZERO)
			await until_heard(),
		method + " of a field that is made"
	)


func test_species_are_scripts() -> void:
	await try_deeds(
		func() -> void:
			var species := GrassSpecies.new()
			add_level({species = [species] as Array[GrassSpecies]})
			await ticks(2)
			species.changed.connect(hear)
			species.natural_frequency = 3.0,
		"changed of a species"
	)
	await try_deeds(
		func() -> void:
			var mesh := PlantMesh.new()
			mesh.told = hear_of.bind("_create_mesh_array")
			var species := GrassSpecies.new()
			species.plant_mesh = mesh
			add_level({species = [species] as Array[GrassSpecies]})
			await until_heard(),
		"a mesh of a species"
	)


func add_streamed(deed_name: String, properties := {}) -> GrassWorld:
	level = Level.new()
	level.name = deed_name.to_pascal_case()
	add_child(level)
	var world := add_world(properties)
	remove_child(world)
	level.add_child(world)
	return world


## Frames until grass stands where the camera is, if the world is still there.
func settle(world: Variant, words: String) -> void:
	var held := [world]  # a lambda may hold no freed object
	await wait_until(
		func() -> bool:
			if not is_instance_valid(held[0]) or not held[0].is_inside_tree():
				return true
			var now: Dictionary = held[0].get_statistics()
			return now.plots > 0 and now.waiting == 0 and held[0].get_field_at(eye.global_position) != null,
		"the plots come, " + words
	)


func test_a_world_tells_of_plots() -> void:
	allow_error(EMITTING)
	allow_error(LOCKED)
	var world_deeds: Dictionary[String, Callable] = {
		"nothing": func(_world: GrassWorld, _field: GrassField) -> void: pass,
		"free the level": func(_world: GrassWorld, _field: GrassField) -> void: level.free(),
		"free the world": func(world: GrassWorld, _field: GrassField) -> void: world.free(),
		"free the plot": func(_world: GrassWorld, field: GrassField) -> void: field.free(),
		"remove the world": func(world: GrassWorld, _field: GrassField) -> void: level.remove_child(world),
		"remove and add the world": func(world: GrassWorld, _field: GrassField) -> void: remove_and_add(world),
		"another plot size": func(world: GrassWorld, _field: GrassField) -> void: world.plot_size = 192,
		"another scene": func(world: GrassWorld, _field: GrassField) -> void: world.plot_scene = null,
		"another folder": func(world: GrassWorld, _field: GrassField) -> void: world.folder = "",
		"cut": func(world: GrassWorld, _field: GrassField) -> void: world.cut(ball(1.0), Transform3D()),
		"no map": func(_world: GrassWorld, field: GrassField) -> void: field.map = null,
	}
	for signal_: String in ["plot_loaded", "plot_leaving"]:
		for name_: String in world_deeds:
			heard = 0
			var world := add_streamed(name_, {radius = 100.0})
			var on_signal := func(_plot: Vector2i, field: GrassField) -> void:
				heard += 1
				if heard == 1:
					world_deeds[name_].call(world, field)
			eye.global_position = Vector3(64, 2, 64)
			if signal_ == "plot_leaving":
				await settle(world, "before %s" % name_)
				world.connect(signal_, on_signal)
				eye.global_position = Vector3(900, 2, 900)
			else:
				world.connect(signal_, on_signal)
			await wait_until(func() -> bool: return heard > 0, "%s: %s" % [signal_, name_])
			await frames(5)
			if name_ in ["free the level"]:
				assert_false(is_instance_valid(level), "%s: %s" % [signal_, name_])
			else:
				await settle(world, "%s: %s" % [signal_, name_])
			if is_instance_valid(world) and not world.get_parent():
				world.free()
			if is_instance_valid(level):
				level.free()

# SPDX-License-Identifier: MIT
## Tries an occasion on which a field or a world calls a script with everything that the script may do meanwhile.
## `./grass test sanitize` tries all pairs under the address sanitizer; the headless layer frees the level on every occasion, and tries a
## third of the other pairs.
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


func other_species() -> Array[GrassSpecies]:
	return [GrassSpecies.new(), GrassSpecies.new()]


## Returns what a script may do, by name.
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
		level.field.get_density_at(Vector3.ZERO)
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
			assert_true(is_finite(level.field.get_density_at(Vector3.ZERO)), words)
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

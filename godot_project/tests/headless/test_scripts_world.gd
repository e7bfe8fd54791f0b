# SPDX-License-Identifier: MIT
## A world survives anything that scripts do in its signals about plots that load and unload.
extends "res://tests/scripts_case.gd"


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
			var world := add_streamed(name_, {camera_radius = 100.0})
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

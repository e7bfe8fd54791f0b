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


## Species whose blades take a thread some frames, so that the world waits with its first field.
func new_species(seed_: int) -> Array[GrassSpecies]:
	var species := GrassSpecies.new()
	species.patch = GrassPatch.new()
	species.patch.seed = seed_
	return [species]


## Returns a scene whose root has a script, in which `count` counts its fields. add_streamed() starts a world twice, with a field each.
func scripted_pattern(code: String, properties := {}) -> PackedScene:
	var script := GDScript.new()
	script.source_code = "extends GrassField\nstatic var count := 0\n" + code
	script.reload()
	var field: GrassField = pattern(properties).instantiate()
	field.set_script(script)
	script.set("count", 0)
	var scene := PackedScene.new()
	scene.pack(field)
	field.free()
	script.set("count", 0)
	return scene


func test_a_field_of_the_scene_frees_itself() -> void:
	for code: String in [
		"func _init() -> void:\n\tcount += 1\n\tif count <= 2:\n\t\tqueue_free()\n",
		"func _init() -> void:\n\tcount += 1\n\tif count <= 2:\n\t\tfree.call_deferred()\n",
	]:
		var scene := scripted_pattern(code, {species = new_species(code.hash())})
		var world := add_streamed("frees itself", {plot_scene = scene, camera_radius = 100.0})
		eye.position = Vector3(64, 2, 64)
		await settle(world, code)
		assert_true(world.get_field_at(eye.position) != null, code)
		level.free()


## A world goes on without a plot whose field a script of its scene takes away, and says so once.
func test_fields_of_the_scene_go_away_before_they_are_shown() -> void:
	for code: String in [
		"func _init() -> void:\n\tqueue_free()\n",
		"func _ready() -> void:\n\tqueue_free()\n",
		"func _ready() -> void:\n\tget_parent().remove_child.call_deferred(self)\n\tfree.call_deferred()\n",
	]:
		expect_error("`plot_scene`")
		var world := add_streamed("goes away", {plot_scene = scripted_pattern(code), camera_radius = 100.0})
		eye.position = Vector3(64, 2, 64)
		await wait_until(
			func() -> bool: return world.get_statistics().fields_made > 3 and world.get_statistics().waiting == 0, "all have been made"
		)
		var made: int = world.get_statistics().fields_made
		await frames(30)
		assert_eq(world.get_statistics().fields_made, made, "no more are made: " + code)
		assert_eq(world.get_statistics().waiting, 0, code)
		level.free()


func test_a_listener_frees_a_plot_that_leaves_in_the_same_frame() -> void:
	var world := add_streamed("frees", {camera_radius = 160.0})
	var freed := []
	var left := []
	world.plot_loaded.connect(
		func(plot: Vector2i, field: GrassField) -> void:
			eye.position.x += 700.0  # so that plots leave, this one among them
			freed.append(plot)
			field.free()
	)
	world.plot_leaving.connect(func(plot: Vector2i, field: GrassField) -> void: left.append([plot, field]))
	eye.position = Vector3(64, 2, 64)
	await wait_until(func() -> bool: return freed.size() > 5, "plots come")
	assert_greater(freed.size(), 5)
	for entry: Array in left:
		assert_true(entry[1] != null, "no plot leaves without its field")
	level.free()


## Processing a field is not needed to bring it, nor to bring others.
func test_fields_that_do_not_process_keep_nothing_up() -> void:
	for code: String in [
		"func _init() -> void:\n\tprocess_mode = PROCESS_MODE_DISABLED\n",
		"func _ready() -> void:\n\tset_process_internal(false)\n\tset_physics_process_internal(false)\n",
		(
			"func _process(_delta: float) -> void:\n\tif get_viewport().get_camera_3d().position.distance_to(position) > 120.0:\n"
			+ "\t\tprocess_mode = PROCESS_MODE_DISABLED\n"
		),
	]:
		var world := add_streamed("no process", {plot_scene = scripted_pattern(code), camera_radius = 100.0})
		for x: float in [64.0, 1064.0, 2064.0, 64.0]:
			eye.position = Vector3(x, 2, 64)
			await settle(world, "%s, at %d m" % [code, x])
			assert_greater(world.get_field_at(eye.position).get_blade_count(), 0)
		level.free()


func test_the_game_disables_or_takes_the_field_of_one_plot() -> void:
	for how: String in ["disable", "remove", "reparent"]:
		var world := add_streamed(how, {camera_radius = 100.0})
		eye.position = Vector3(64, 2, 64)
		await settle(world, how)
		var field := world.get_field(Vector2i(0, 0))
		world.cut(ball(4.0), Transform3D(Basis(), Vector3(64, 4.05, 64)))
		match how:
			"disable":
				field.process_mode = PROCESS_MODE_DISABLED
			"remove":
				expect_error("the field of plot (0, 0) is no longer in the tree")
				world.remove_child(field)
			"reparent":
				field.reparent(level)
		for x: float in [1064.0, 2064.0, 3064.0]:
			eye.position = Vector3(x, 2, 64)
			await settle(world, "%s, at %d m" % [how, x])
		assert_true(is_instance_valid(field), how)
		eye.position = Vector3(64, 2, 64)
		await settle(world, how + ", back")
		var now := world.get_field(Vector2i(0, 0))
		var height := now.get_height_at(Vector3(100, 0, 64))
		assert_less(now.get_height_at(Vector3(64, 0, 64)), 0.5 * height, how + ": what was mown there is kept")
		if how == "remove":
			assert_ne(now, field, how)
			assert_true(field.get_parent() == null, "it is the game's")
			field.free()
		level.free()

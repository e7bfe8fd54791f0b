# SPDX-License-Identifier: MIT
## What the code blocks of README.md and docs/ must do. A function is named after the page and the heading of its block.
extends "res://tests/docs/snippet_case.gd"


func readme_install() -> void:
	var node := Node3D.new()
	node.set_script(block_script())
	add_child(node)
	await seen()
	var meadow := node.get_child(0) as GrassField
	assert_near(meadow.get_blade_count(), 400.0 * 400.0, 0.02 * 160000.0, "blades on 20 m x 20 m")
	assert_greater(meadow.get_density_at(Vector3.ZERO), 0.9)
	assert_eq(meadow.get_statistics().backend, "CPU")


func performance_one_switch_for_the_options_menu() -> void:
	var field := add_field({pool_tiles = 400})
	var menu := OptionButton.new()
	menu.set_script(block_script())
	var file: String = block_script().get_script_constant_map()["FILE"]
	DirAccess.remove_absolute(file)
	add_child(menu)
	assert_eq(menu.selected, GrassQuality.LEVEL_HIGH)
	for level in menu.item_count:
		menu.item_selected.emit(level)
		await ticks(2)
		assert_eq(GrassQuality.get_level(), level)
		assert_eq(field.get_counters().pool_tiles, [100, 200, 400, 800][level])
	GrassQuality.set_level(GrassQuality.LEVEL_LOW)
	assert_eq(menu.selected, GrassQuality.LEVEL_LOW, "another menu changed it")
	menu.free()
	GrassQuality.reset_level()
	menu = OptionButton.new()
	menu.set_script(block_script())
	add_child(menu)
	assert_eq(menu.selected, GrassQuality.LEVEL_ULTRA, "the last choice is remembered")
	menu.free()
	DirAccess.remove_absolute(file)
	GrassQuality.reset_level()


func levels_floors_above_one_another() -> void:
	var bridge := GrassField.new()
	bridge.name = "Bridge"
	bridge.size = Vector2(4, 4)
	bridge.position.y = 4.0
	bridge.ground_low = -0.5
	add_child(bridge)
	var stage := await ran(
		func(made: Stage) -> void:
			made.get_node("GrassField").ground_high = 2.0
			made.player.position = Vector3(0.25, 4.0, 0.25)
	)
	assert_eq(stage.locals.why.reason, GrassField.REASON_LEVEL)
	assert_eq(stage.locals.why.node, bridge)


func performance_a_budget() -> void:
	var stage := await ran()
	assert_near(stage.field.simulation_budget, 1.5, 1e-6)


func vr_holding_the_frame_rate() -> void:
	var node := Node.new()
	node.set_script(block_script())
	add_child(node)
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_LOW)
	await wait_until(func() -> bool: return GrassQuality.get_level() == GrassQuality.LEVEL_MEDIUM, "frames take no time here")
	node.set_process(false)
	node.call("choose", 5.0)
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_HIGH)
	node.call("choose", 8.0)
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_HIGH, "neither room nor late")
	node.call("choose", 10.5)
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_MEDIUM)
	node.call("choose", 5.0)
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_MEDIUM, "high was too slow")
	GrassQuality.reset_level()


func game_a_mower() -> void:
	var field := add_field({map = full_map()})
	var mower := CharacterBody3D.new()
	mower.set_script(block_script())
	var deck := add_shape(mower, BoxShape3D.new(), Transform3D(Basis(), Vector3(0, 0.6, 0)))
	deck.name = "Deck"
	var bar := ProgressBar.new()
	bar.name = "Progress"
	mower.add_child(bar)
	bar.owner = mower
	bar.unique_name_in_owner = true
	mower.set("field", field)
	add_child(mower)
	await ticks(61)
	assert_greater(mower.get("hay"), 0.01, "m³")
	assert_greater(bar.value, 1.0, "percent")


func game_footsteps_paths_and_hiding() -> void:
	var stage := await staged(
		func(made: Stage) -> void:
			made.player.position = Vector3(0.25, 0.3, 0.25)
			assert_true(made.get_node("GrassField").species.is_empty(), "the field that a scene has at first")
	)
	assert_near(stage.field.species[0].wear_recovery, 0.02, 1e-6)
	await seen()
	assert_true(stage.get_node("Rustle").playing, "the player has entered grass")
	stage.player.position.y = 0.0
	stage.enemy.position = Vector3(-6, 0, 0.25)
	assert_true(stage.call("is_player_hidden", stage.enemy), "crouching in a meadow of the default patch")
	stage.player.is_crouching = false
	assert_false(stage.call("is_player_hidden", stage.enemy), "standing")
	stage.player.is_crouching = true
	for step in 400:
		stage.foot.position = Vector3(-0.02 * step, 0, 0.25)
		stage.call("_on_footstep", stage.foot)
		stage.call("_on_footstep", stage.foot)
	assert_false(stage.call("is_player_hidden", stage.enemy), "along a trodden path")
	await press(stage, Vector3(4.25, 0, 4.25))
	stage.enemy.position = Vector3(4.25, 0, 4.25)
	await ticks(60)
	assert_true(stage.call("sees_trail", stage.enemy), "where something lies in the grass")
	stage.enemy.position = Vector3(-6, 0, -6)
	assert_false(stage.call("sees_trail", stage.enemy), "where nobody was")


func game_footsteps_paths_and_hiding_2() -> void:
	var field := add_field({size = Vector2(12, 12), map = full_map()})
	var sheep := CharacterBody3D.new()
	sheep.set_script(block_script())
	add_shape(sheep, ball(0.3))
	sheep.position = Vector3(-2, 0.3, 0.25)
	sheep.motion_mode = CharacterBody3D.MOTION_MODE_FLOATING
	sheep.set("field", field)
	add_child(sheep)
	sheep.velocity = Vector3(2, 0, 0)
	await ticks(60)
	assert_near(field.map.sample(GrassMap.CHANNEL_WEAR, Vector2(-0.6, 0.25)), 0.03, 0.02, "a step, and not one in each tick")
	sheep.velocity = Vector3.ZERO
	await ticks(120)
	assert_less(field.map.sample(GrassMap.CHANNEL_WEAR, Vector2(0.0, 0.25)), 0.07, "a sheep that stands treads nothing")


func game_dew_fireflies_and_rustling() -> void:
	var stage := await staged(func(made: Stage) -> void: made.player.position = Vector3(0.25, 0.3, 0.25))
	await ticks(20)
	var blades: PackedInt64Array = stage.get("blades")
	assert_greater(blades.size(), 100)
	assert_eq(stage.get_node("Firefly").global_position, stage.field.wait_for_knots(blades)[15])
	var rustle: AudioStreamPlayer3D = stage.get_node("Rustle")
	assert_near(rustle.volume_linear, 0.0, 1e-4, "the player stands")
	for step in 10:
		stage.player.position.x += 0.02
		await ticks(1)
	assert_greater(rustle.volume_linear, 0.1, "it walks")


func game_saving() -> void:
	var cut_at := Vector3(0, 0, 0)
	var before: Array[GrassMap] = []
	var stage := await ran(
		func(made: Stage) -> void:
			var field: GrassField = made.get_node("GrassField")
			field.map.stroke(brush(GrassBrush.TOOL_ERASE, 2.0), Vector2(-1, 0), Vector2(1, 0))
			before.append(field.map)
	)
	assert_ne(stage.field.map, before[0], "it is the map that was read")
	assert_eq(stage.field.get_density_at(cut_at), 0.0, "what was erased is saved")
	assert_eq(stage.field.map.data, before[0].data)
	DirAccess.remove_absolute("user://save1.grassmap")


func worlds_set_it_up() -> void:
	var world := GrassWorld.new()
	world.name = "GrassWorld"
	world.plot_size = 64.0
	world.camera_radius = 20.0
	world.save_folder = "user://docs_world"
	var deck := box(Vector3(4, 0.6, 4))
	var eye := Camera3D.new()
	add_child(eye)
	eye.position = Vector3(0, 2, 0)
	eye.make_current()
	var stage := await staged(
		func(made: Stage) -> void:
			made.add_child(world)
			made.set("deck", deck)
	)
	await wait_until(func() -> bool: return world.get_fields().size() == 4, "four plots meet here")
	assert_true(stage.call("is_hidden", Vector3(1, 0, 1)))
	stage.call("mow", Vector3(0, 0.3, 0))
	for x: float in [-1.0, 1.0]:
		assert_false(stage.call("is_hidden", Vector3(x, 0, 1)), "mown on both sides of the border")
	assert_false(stage.call("is_hidden", Vector3(5000, 0, 0)), "not in memory")
	stage.call("save_game")
	world.wait_for_files()
	assert_eq(world.get_statistics().files_written, 4)
	for file in DirAccess.get_files_at(world.save_folder):
		DirAccess.remove_absolute(world.save_folder.path_join(file))


func together_sending_lasting_changes() -> void:
	var stage := await staged()
	var map: GrassMap = stage.field.map
	var client := GrassMap.new()
	client.data = map.data
	map.stroke(brush(GrassBrush.TOOL_CUT, 1.0), Vector2.ZERO, Vector2(1, 0))
	var changes: PackedByteArray = stage.call("take_changes")
	assert_greater(changes.size(), 0)
	assert_true((stage.call("take_changes") as PackedByteArray).is_empty(), "told already")
	assert_true(client.apply_changes(changes))
	assert_eq(client.data, map.data)
	assert_true(stage.call("take_over", changes), "the server has it")


func filling_once_or_live() -> void:
	var stage := await ran(func(made: Stage) -> void: made.get_node("GrassField").map.base_density = 0.0)
	assert_eq(stage.field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(1, 1)), 0.0, "undone")
	var cover := stage.field.fill(stage.locals.rule) / 256.0
	assert_greater(cover, 0.3, "share of the field that the rule fills")
	assert_less(cover, 1.0)


func terrain_grass_on_a_terrain() -> void:
	expect_error("Choose another node, or add the method to it")
	var stage := await staged()
	stage.call("grow_on_hills")
	assert_near(stage.field.map.sample(GrassMap.CHANNEL_GROUND, Vector2.ZERO), 1.0, 0.01, "metres")
	stage.call("grow_on_terrain")
	assert_eq(stage.field.get_node_or_null(stage.field.terrain), stage.get_node("Terrain"), "here a body without heights")
	await frames(3)


func terrain_the_interface() -> void:
	var terrain := Node3D.new()
	terrain.set_script(block_script())
	terrain.name = "Terrain"
	add_child(terrain)
	var field := add_field({size = Vector2(16, 16), terrain = NodePath("../Terrain")})
	await frames(5)
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(4.5, 0.5)), 3.0 * sin(0.05 * 4.5), 0.01)
	terrain.call("explode", Vector3(4.5, 1, 0.5))
	await frames(5)
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(4.5, 0.5)), 3.0 * sin(0.05 * 4.5) - 2.0, 0.01, "a crater")


func terrain_grass_by_texture() -> void:
	var stage := await ran()
	assert_eq(stage.field.fill_rule.texture_ids, PackedInt32Array([0, 3]))


func painting_why_is_there_no_grass_here() -> void:
	var stage := await staged()
	var yard := GrassExclusion3D.new()
	yard.shape = BoxShape3D.new()
	stage.player.add_child(yard)
	stage.field.fill_rule = GrassFillRule.new()
	await frames(30)
	stage.call("run")
	assert_eq(stage.locals.answer.node, yard)


func painting_from_a_script() -> void:
	var stage := await ran()
	assert_less(stage.field.get_height_at(Vector3(0, 0, 0)), 0.2, "cut, from one end to the other")
	assert_greater(stage.field.get_height_at(Vector3(0, 0, 6)), 0.4, "uncut beside it")


func shared_maps_from_a_script() -> void:
	var stage := await ran()
	assert_near(stage.map.sample(GrassMap.CHANNEL_HEIGHT, Vector2(0, -4)), 0.5, 0.01, "grey")
	assert_eq(stage.map.sample(GrassMap.CHANNEL_HEIGHT, Vector2(0, 4)), 1.0)
	DirAccess.remove_absolute("user://density.png")


func recording_record() -> void:
	var stage := await staged()
	for action in ["ui_home", "ui_end"]:
		var pressed := InputEventAction.new()
		pressed.action = action
		pressed.pressed = true
		Input.parse_input_event(pressed)
		await ticks(10)
	assert_eq(stage.field.get_record_state().message, "was stopped")
	assert_greater(stage.field.get_record_state().ticks, 3)
	DirAccess.remove_absolute("user://grass.grassrecord")


func first_meadow_from_a_script() -> void:
	var node := Node3D.new()
	node.set_script(block_script())
	add_child(node)
	await seen()
	assert_eq((node.get_child(0) as GrassField).size, Vector2(20, 20))
	assert_greater((node.get_child(0) as GrassField).get_awake_tile_count(), 0, "the ball bends the grass")


func presets_presets() -> void:
	var node := Node3D.new()
	node.set_script(block_script())
	add_child(node)
	await ticks(3)
	var field := node.get_child(0) as GrassField
	assert_true(field.species[0].card is Texture2D, "wheat has ears")
	assert_greater(field.get_blade_count(), 100000)


func surface_hooks_surface_hooks() -> void:
	var stage := await staged()
	stage.call("let_it_snow")
	await ticks(60)
	assert_greater(stage.field.snow, 0.02)
	assert_near(stage.field.get_hook_parameter("snow_depth"), 0.1, 1e-6)


func surface_hooks_one_of_your_own() -> void:
	var stage := await staged()
	stage.call("show_height_lines")
	await ticks(1)
	assert_eq(stage.field.get_hook_parameter("line_color"), Color.CYAN)


func surface_hooks_the_wind_over_time() -> void:
	var stage := await staged()
	stage.call("bring_a_storm")
	await ticks(120)
	assert_greater(stage.field.wind_speed, 3.0)


func look_taller_or_shorter() -> void:
	var stage := await staged()
	var before := stage.field.get_height_at(Vector3.ZERO)
	stage.call("grow_to_the_hip")
	await wait_until(func() -> bool: return not stage.field.get_statistics().waiting, "the field has grown")
	assert_greater(stage.field.get_height_at(Vector3.ZERO), 1.4 * before, "metres")


func look_another_colour() -> void:
	var stage := await staged()
	stage.call("turn_to_autumn")
	await wait_until(func() -> bool: return not stage.field.get_statistics().waiting, "the field has changed")
	assert_eq(stage.field.species[0].tip_color, Color(0.72, 0.52, 0.2))
	assert_eq(stage.field.soil_color, Color(0.25, 0.18, 0.1))


func look_less_even() -> void:
	var stage := await staged()
	stage.call("let_it_grow_wild")
	await wait_until(func() -> bool: return not stage.field.get_statistics().waiting, "the field has changed")
	assert_near(stage.field.species[0].tussock_share, 0.5, 1e-6)
	assert_near(stage.field.sparse_height, 0.4, 1e-6)


func look_the_ground() -> void:
	var stage := await staged()
	var clay := StandardMaterial3D.new()
	clay.albedo_texture = GradientTexture2D.new()
	stage.call("grow_on", clay)
	assert_eq(stage.field.soil_albedo, clay.albedo_texture)
	assert_true(stage.field.soil_normal == null)
	assert_near(stage.field.soil_scale, 1.5, 1e-6)


func plants_several_kinds_of_plants() -> void:
	var stage := await staged()
	stage.call("mix_a_meadow")
	await wait_until(func() -> bool: return not stage.field.get_statistics().waiting, "the field grows both")
	assert_eq(stage.field.species.size(), 2)
	assert_true(stage.field.species[1].card is Texture2D, "daisies have flowers")
	assert_near(stage.field.species[0].share, 0.9, 1e-6)


func plants_plants_with_a_mesh() -> void:
	var node := Node3D.new()
	node.set_script(block_script())
	add_child(node)
	await ticks(3)
	var field := node.get_child(0) as GrassField
	assert_true(field.species[0].plant_mesh is ArrayMesh)
	var knots := [field.get_knots(Vector2i.ZERO, 0), field.get_knots(Vector2i.ZERO, 7)]
	assert_eq(knots[0][0], knots[1][0], "eight fronds to a root")


func plants_plants_with_a_scene() -> void:
	var field := GrassField.new()
	field.name = "GrassField"
	field.size = Vector2(16, 16)
	var nodes: Array[Node3D] = []
	field.plant_node_appeared.connect(func(node: Node3D, _species: int, _blade: int) -> void: nodes.append(node))
	var player := CharacterBody3D.new()
	add_body(player, ball(0.3), Vector3(0, 0.3, 0))
	var game := Node3D.new()
	game.set_script(block_script())
	game.add_child(field)
	add_child(game)
	await wait_until(func() -> bool: return field.get_counters().plant_nodes == 50, "the nearest shrubs have nodes")
	player.position = nodes[0].global_position
	await wait_until(func() -> bool: return game.get("rustling") > 0, "the player stands in a shrub")
	assert_greater(nodes.size(), 49)


func forces_forces_and_wind() -> void:
	var stage := await staged()
	var place := Vector3(1, 0, 1)
	stage.call("_on_grenade_exploded", place)
	await ticks(15)
	var bend := stage.field.get_bend_at(place + Vector3(1.5, 0, 0))
	assert_greater(bend.x, 0.2, "away from the grenade")
	await ticks(120)
	stage.call("_on_door_slammed", place)
	await ticks(5)
	assert_eq(stage.field.get_counters().forces, 1)


func forces_forces_and_wind_2() -> void:
	var stage := await staged()
	var helicopter := Node3D.new()
	helicopter.position = Vector3(0, 3, 0)
	add_child(helicopter)
	stage.call("add_rotor", helicopter)
	await ticks(60)
	assert_greater(stage.field.get_bend_at(Vector3(3, 0, 0)).x, 0.1, "out of the ring")
	assert_less(stage.field.get_bend_at(Vector3(-3, 0, 0)).x, -0.1)


func troubleshooting_troubleshooting() -> void:
	var stage := await staged()
	stage.call("report", stage.field, stage.player.global_position)  # a name that is missing is an error of the script
	assert_true(stage.field.explain(stage.player.global_position).text.begins_with("Grass of"))


func troubleshooting_grass_comes_late() -> void:
	var stage := await staged()
	await stage.call("wait_for_grass", stage.field)
	assert_eq(stage.field.get_statistics().waiting, false)
	assert_eq(stage.field.get_statistics().compiling, 0)

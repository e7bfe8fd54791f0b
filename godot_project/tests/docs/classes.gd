# SPDX-License-Identifier: MIT
## What the code blocks of the class reference must do. A function is named after the class and the member of its block.
extends "res://tests/docs/snippet_case.gd"

const MAP := "res://meadow.grassmap"
const RULE := "res://steppe.tres"
const HERE := Vector3.ZERO


func grass_brush() -> void:
	var stage := await ran()
	assert_near(stage.map.sample(GrassMap.CHANNEL_CUT, Vector2.ZERO), 0.04, 0.006, "metres")


func grass_quality() -> void:
	await ran()
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_LOW)
	GrassQuality.reset_level()


func grass_quality_2() -> void:
	await ran()
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_CUSTOM)
	assert_eq(GrassQuality.get_custom().shadow_distance, 0.0)
	assert_eq(GrassQuality.get_custom().lod_far, GrassQuality.from_level(GrassQuality.LEVEL_MEDIUM).lod_far)
	GrassQuality.reset_level()


func grass_bone_colliders3d() -> void:
	var stage := await staged()
	var leg: Skeleton3D = stage.get_node("Skeleton3D")
	var first := leg.get_bone_count()
	for i in 2:
		leg.add_bone("Bone%d" % i)
		leg.set_bone_rest(first + i, Transform3D(Basis(), Vector3(0, 0.1 + 0.2 * i, 0)))
	leg.set_bone_parent(first + 1, first)
	leg.reset_bone_poses()
	leg.position = Vector3(3, 0, 3)
	stage.call("run")
	await seen()
	assert_true(stage.field.is_tile_awake(stage.field.get_tile_at(leg.position)))


func grass_exclusion3d() -> void:
	var stage := await ran()
	await frames(30)
	assert_eq(stage.field.get_density_at(HERE), 0.0, "in the clearing")
	assert_greater(stage.field.get_density_at(Vector3(7, 0, 7)), 0.5, "outside of it")


func grass_path3d() -> void:
	var stage := await ran()
	await frames(30)
	assert_eq(stage.field.get_density_at(Vector3(0, 0, 2)), 0.0, "on the trail")
	assert_greater(stage.field.get_density_at(Vector3(0, 0, 5)), 0.5, "beside it")


func grass_fill_rule() -> void:
	var tree := Node3D.new()
	tree.add_to_group("trees")
	add_child(tree)
	var stage := await ran(func(made: Stage) -> void: made.get_node("GrassField").map.base_density = 0.0)
	await frames(20)
	assert_eq(stage.field.get_density_at(HERE), 0.0, "around the tree")
	var covered := 0
	for x in range(-7, 8):
		covered += int(stage.field.get_density_at(Vector3(x, 0, 4)) > 0.5)
	assert_greater(covered, 4, "of 15 places")


func grass_map() -> void:
	assert_false(FileAccess.file_exists(MAP))
	await ran()
	var saved := ResourceLoader.load(MAP, "", ResourceLoader.CACHE_MODE_IGNORE) as GrassMap
	DirAccess.remove_absolute(MAP)
	assert_greater(saved.sample(GrassMap.CHANNEL_DENSITY, Vector2.ZERO), 0.0, "what was painted is in the file")


func grass_map_get_changes_since() -> void:
	var stage := await ran(func(made: Stage) -> void: made.get_node("GrassField").map.base_density = 0.0)
	var client := GrassMap.new()
	assert_true(client.apply_changes(stage.locals.changes))
	assert_greater(client.sample(GrassMap.CHANNEL_DENSITY, Vector2.ZERO), 0.0)


func grass_map_set_ground() -> void:
	var stage := await ran()
	var highest := 0.0
	for x in range(-7, 8):
		highest = maxf(highest, stage.map.sample(GrassMap.CHANNEL_GROUND, Vector2(x, 0)))
	assert_greater(highest, 0.1, "metres")
	assert_less(highest, 1.01)


func grass_species() -> void:
	var stage := await ran()
	stage.remove_child(stage.field)  # a field that enters the tree has all its grass at once
	stage.add_child(stage.field)
	await seen()
	var kinds := {}
	for blade in BLADES:
		kinds[stage.field.get_blade_species(stage.field.get_tile_at(Vector3(0, 0, 3)), blade)] = true
	assert_eq(stage.field.species.size(), 2)
	assert_eq(kinds.keys(), [1], "sorrel alone along the ditch")


func grass_field_bake_ground() -> void:
	var stage := await staged()
	add_body(StaticBody3D.new(), BoxShape3D.new(), Vector3(2, 0, 2))
	await ticks(2)
	stage.call("_on_crater_made", Vector3(2, 0, 2))
	assert_near(stage.field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(2, 2)), 0.5, 0.02, "metres")


func grass_field_bake_ground_from() -> void:
	var stage := await ran()
	assert_near(stage.field.map.sample(GrassMap.CHANNEL_GROUND, Vector2.ZERO), 1.0, 0.01, "metres")


func grass_field_get_bend_at() -> void:
	var stage := await staged()
	stage.call("run")
	assert_eq(stage.looked_along, Vector3.ZERO, "nothing is there")
	await press(stage, Vector3(0.3, 0, 0))
	await ticks(60)
	stage.enemy.position = Vector3(0.2, 0, 0)
	stage.call("run")
	assert_ne(stage.looked_along, Vector3.ZERO, "something lies in the grass there")


func grass_field_blast() -> void:
	var stage := await staged()
	stage.call("_on_exploded")
	await ticks(15)
	assert_greater(stage.field.get_bend_at(stage.get("global_position") + Vector3(1.5, 0, 0)).x, 0.2, "away from it")


func grass_field_push() -> void:
	var stage := await staged(func(made: Stage) -> void: made.player.position = Vector3(5, 0, 5))  # grass below a body lies
	stage.call("_on_door_slammed")
	await ticks(10)
	assert_greater(stage.field.get_bend_at(stage.get("global_position")).x, 0.05)


func grass_force3d() -> void:
	var stage := await ran()
	await ticks(30)
	assert_greater(stage.field.get_awake_tile_count(), 50, "the rotor blows")


func grass_force3d_fire() -> void:
	var stage := await ran()
	assert_true(stage.locals.grenade.is_blowing())
	await ticks(10)
	assert_greater(stage.field.get_awake_tile_count(), 20)


func grass_world() -> void:
	var stage := await ran()
	assert_true(stage.locals.world.is_inside_tree())
	assert_eq(stage.locals.world.get_plot_path(Vector2i(0, -1)), "user://grass/plot_0_-1.grassmap")


func grass_field_record() -> void:
	var stage := await staged()
	await ticks(10)
	assert_eq(stage.field.get_record_state().mode, "recording")
	stage.field.stop_record()
	DirAccess.remove_absolute("user://grass.grassrecord")


func grass_field_cut() -> void:
	var stage := await staged()
	assert_greater(stage.hay, 0.01, "m³")
	assert_less(stage.field.get_height_at(HERE), 0.15, "metres")


func grass_field_get_density_at() -> void:
	var stage := await ran()
	assert_near(stage.locals.speed, 3.0, 1e-6, "in full grass")
	stage.field.paint(brush(GrassBrush.TOOL_ERASE, 2.0), HERE, HERE)
	stage.call("run")
	assert_near(stage.locals.speed, 5.0, 1e-6, "in a clearing")


func grass_field_explain() -> void:
	var stage := await ran()
	assert_eq(stage.locals.why.reason, GrassField.REASON_NONE)
	assert_true(stage.locals.why.text.contains("grows here"))


func grass_field_fill() -> void:
	var rule := GrassFillRule.new()
	rule.density = 0.25
	ResourceSaver.save(rule, RULE)
	var stage := await ran()
	DirAccess.remove_absolute(RULE)
	assert_eq(stage.field.get_density_at(HERE), 1.0, "undone")


func grass_field_get_blade_knots() -> void:
	var stage := await staged()
	await frames(2)
	var blades: PackedInt64Array = stage.get("blades")
	for i in stage.drops.size():
		assert_eq(stage.drops[i].global_position, stage.field.wait_for_knots([blades[i]])[15])


func grass_field_get_mown_share() -> void:
	var stage := await ran()
	assert_eq(stage.get_node("Label").text, "0 % mown")
	var box := stage.get_node("Lawn") as CollisionShape3D
	stage.field.cut(box.shape, Transform3D(Basis(), Vector3(0, 2.1, 0)))
	stage.call("run")
	assert_ne(stage.get_node("Label").text, "0 % mown")


func grass_field_get_cover() -> void:
	var stage := await staged(func(made: Stage) -> void: made.player.position = Vector3(4, 0, 0.25))
	stage.enemy.position = Vector3(-4, 0, 0.25)
	assert_false(stage.call("sees", stage.enemy), "8 m of meadow between them")
	stage.enemy.position = Vector3(3.5, 0, 0.25)
	assert_true(stage.call("sees", stage.enemy), "from half a metre away")


func grass_field_get_rustle() -> void:
	var stage := await staged(func(made: Stage) -> void: made.player.position = Vector3(0.25, 0.3, 0.25))
	var rustle: AudioStreamPlayer3D = stage.get_node("Rustle")
	await ticks(2)
	assert_near(rustle.volume_linear, 0.0, 1e-4, "at rest")
	for step in 10:
		stage.player.position.x += 0.02
		await ticks(1)
	assert_greater(rustle.volume_linear, 0.1)


func grass_quality_get_current() -> void:
	await ran()
	var heard := GrassQuality.get_current().changed.get_connections().size()
	assert_greater(heard, 0)
	for connection in GrassQuality.get_current().changed.get_connections():
		GrassQuality.get_current().changed.disconnect(connection.callable)


func grass_field_get_height_at() -> void:
	var stage := await ran()
	assert_true(stage.locals.is_hidden, "crouching in a meadow of the default patch")
	stage.field.paint(brush(GrassBrush.TOOL_CUT, 2.0, {cut_height = 0.1}), HERE, HERE)
	stage.call("run")
	assert_false(stage.locals.is_hidden, "on a lawn")


func grass_field_is_grass_at() -> void:
	var stage := await staged()
	stage.field.paint(brush(GrassBrush.TOOL_ERASE, 2.0), HERE, HERE)
	stage.call("run")
	assert_false(stage.get_node("Rustle").playing, "in a clearing")
	stage.foot.position = Vector3(5, 0, 5)
	stage.call("run")
	assert_true(stage.get_node("Rustle").playing, "in grass")


func grass_field_paint() -> void:
	var stage := await ran()
	assert_less(stage.field.map.sample(GrassMap.CHANNEL_TINT, Vector2.ZERO), 0.5)


func grass_field_register_collider() -> void:
	var entered := []
	var stage := await ran(
		func(made: Stage) -> void:
			made.get_node("GrassField").body_entered_grass.connect(entered.append)
			made.player.position.y = 50.0
	)
	await seen()
	assert_eq(entered, [stage.get_node("Skeleton3D/LeftFoot")])


func grass_field_regrow() -> void:
	var stage := await staged(func(made: Stage) -> void: made.get_node("GrassField").map.stroke(full_cut(), Vector2.ZERO, Vector2.ZERO))
	var before := stage.field.get_height_at(HERE)
	stage.call("run")
	assert_near(stage.field.get_height_at(HERE) - before, 0.05, 0.011, "metres")


func grass_field_trample() -> void:
	var stage := await staged()
	for step in 60:
		stage.call("_on_footstep")
	assert_greater(stage.field.map.sample(GrassMap.CHANNEL_WEAR, Vector2.ZERO), 0.2)


func grass_field_body_entered_grass() -> void:
	var stage := await staged()
	var rustle := AudioStreamPlayer3D.new()
	rustle.name = "Rustle"
	rustle.stream = AudioStreamGenerator.new()
	stage.player.add_child(rustle)
	stage.player.position = Vector3(0, 30, 0)
	await ticks(3)
	stage.call("run")
	stage.player.position = Vector3(0, 0.3, 0)
	await seen()
	assert_true(rustle.playing)


func grass_field_ground_high() -> void:
	var stage := await ran()
	var bridge: GrassField = stage.locals.bridge
	assert_near(bridge.get_density_at(Vector3(0, 4, 0)), 1.0, 0.01)
	assert_eq(bridge.get_density_at(Vector3.ZERO), 0.0, "that is the meadow's level")
	assert_eq(stage.field.get_density_at(Vector3(0, 4, 0)), 0.0)


func grass_field_ground_mask() -> void:
	var stage := await staged()
	for layer: int in [0, 4]:
		var body := StaticBody3D.new()
		var shape := CollisionShape3D.new()
		shape.shape = BoxShape3D.new()
		body.add_child(shape)
		body.collision_layer = 1 << layer
		body.position.y = 2.0 - 0.25 * layer
		if layer == 4:
			body.add_to_group(&"ground")
		stage.add_child(body)
	await ticks(3)
	stage.call("run")
	assert_near(stage.field.map.sample(GrassMap.CHANNEL_GROUND, Vector2.ZERO), 1.5, 0.1, "the box on layer 5, below the other")


func grass_field_simulation_budget() -> void:
	var stage := await ran()
	assert_near(stage.field.simulation_budget, 1.5, 1e-6)


func grass_field_plant_node_appeared() -> void:
	var stage := await ran()
	var shrub := GrassSpecies.new()
	shrub.plant_scene = PackedScene.new()
	var root := Node3D.new()
	shrub.plant_scene.pack(root)
	root.free()
	var nodes: Array[Node3D] = []
	stage.field.plant_node_appeared.connect(func(node: Node3D, _species: int, _blade: int) -> void: nodes.append(node))
	stage.field.species = [shrub]
	await wait_until(func() -> bool: return nodes.size() > 10, "the plants around the player have nodes")
	assert_eq(stage.field.plant_node_appeared.get_connections().size(), 2)


func grass_species_plant_scene() -> void:
	var stage := await ran()
	await wait_until(func() -> bool: return stage.field.get_counters().plant_nodes > 5, "the shrubs around the player have bodies")
	assert_true(stage.field.species[1].plant_scene is PackedScene)


func full_cut() -> GrassBrush:
	return brush(GrassBrush.TOOL_CUT, 2.0, {cut_height = 0.1})

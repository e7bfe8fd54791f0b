# SPDX-License-Identifier: MIT
## Pictures, for docs/guide/painting.md, of what a level designer does besides painting. Each test also checks that it was done.
@tool
extends "res://tests/editor/editor_case.gd"

const DRAWN := ["test_heat_map_of_density", "test_handles_of_the_size", "test_grass_on_a_terrain", "test_a_path_that_a_rule_clears"]  # see runner.gd


func before() -> void:
	await super()
	field.density = density_of_picture(200.0)
	await shown()


func shown() -> void:
	await wait_until(
		func() -> bool:
			EditorInterface.get_base_control().queue_redraw()
			return not field.get_statistics().waiting and field.get_counters().map_waiting == 0,
		"the field is shown"
	)
	await frames(10)
	assert_eq(field.get_statistics().left_out_tiles, 0)


## Returns a mean colour of the view within some pixels of a point of the world.
func seen_at(point: Vector3, reach := 4) -> Color:
	var image := await seen()
	var middle := Vector2i(at(point))
	var sum := Color(0, 0, 0, 0)
	var count := 0
	for y in range(middle.y - reach, middle.y + reach + 1):
		for x in range(middle.x - reach, middle.x + reach + 1):
			sum += image.get_pixel(x, y)
			count += 1
	return sum / count


func test_heat_map_of_density() -> void:
	field.density = 200.0  # blades hide the ground, whose colour is no part of the map
	set_number("Strength", 1.0)
	await take("Density")
	set_number("Target", 0.3)
	await stroke([Vector3(-1.5, 0, 0.5), Vector3(1.5, 0, 0.5)])
	field.debug_view = GrassField.DEBUG_VIEW_DENSITY
	await shown()
	var thin := await seen_at(Vector3(0, 0.1, 0.5))
	var full := await seen_at(Vector3(0, 0.1, -1.5))
	assert_greater(full.r - full.b, thin.r - thin.b + 0.5, "red where all of it stands")  # 0.59 and -0.25
	add_landscape()
	await shoot("heat_map")


func test_handles_of_the_size() -> void:
	field.size = Vector2(4, 3)
	await select(field)
	await shown()
	add_landscape()
	await shoot("size_handles")


func test_grass_on_a_terrain() -> void:
	var terrain: Node3D = load("res://tests/editor/tool_terrain.gd").new()
	terrain.name = "Terrain"
	var root := EditorInterface.get_edited_scene_root()
	root.add_child(terrain)
	terrain.owner = root
	field.terrain = NodePath("../Terrain")
	await wait_until(func() -> bool: return field.get_counters().terrain_waiting == 0 and field.map != null, "the terrain is read")
	await shown()
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(0.5, 0.5)), terrain.get_height(Vector3(0.5, 0, 0.5)), 0.02)
	add_landscape()
	await shoot("terrain")


func test_a_path_that_a_rule_clears() -> void:
	var rule := GrassFillRule.new()
	field.fill_rule = rule
	var path := GrassPath3D.new()
	path.name = "Path"
	path.width = 1.0
	path.curve = Curve3D.new()
	for point: Vector3 in [Vector3(-2.5, 0, 1.5), Vector3(0, 0, 0.4), Vector3(2.5, 0, 1.2)]:
		path.curve.add_point(point, Vector3(-0.8, 0, 0), Vector3(0.8, 0, 0))
	var root := EditorInterface.get_edited_scene_root()
	root.add_child(path)
	path.owner = root
	await select(path)
	await wait_until(func() -> bool: return field.get_counters().fill_waiting == 0, "the rule has run")
	await shown()
	assert_less(density(0, 0.4), 0.1)
	assert_near(density(0, 2.5), 1.0, 0.01)
	add_landscape()
	await shoot("path")

# SPDX-License-Identifier: MIT
## A path in the editor: the grass follows a curve that is bent with Godot's own tools.
@tool
extends "res://tests/editor/editor_case.gd"

const ARROW := 140.0  # pixels from a point to the tip of its arrow


## Adds a path of three points, in a row before the camera, selected.
func add_path(properties: Dictionary) -> GrassPath3D:
	var path := GrassPath3D.new()
	path.curve = Curve3D.new()
	for x: float in [-3, 0, 3]:
		path.curve.add_point(Vector3(x, 0, 0))
	path.width = 1.0
	path.fade = 0.0
	for property: String in properties:
		path.set(property, properties[property])
	EditorInterface.get_edited_scene_root().add_child(path)
	path.owner = EditorInterface.get_edited_scene_root()
	await select(path)
	await worked()
	return path


## Drags the first point by its arrow, and returns where it is then.
func drag_a_point(path: GrassPath3D) -> Vector3:
	var point := at(Vector3(-3, 0, 0))
	await move(point)
	await button(MOUSE_BUTTON_LEFT, true, point)  # the arrows go to the point
	await button(MOUSE_BUTTON_LEFT, false, point)
	var way := (at(Vector3(-3, 0, 0.1)) - point).normalized()
	var arrow := point + ARROW * way
	await move(arrow)
	await button(MOUSE_BUTTON_LEFT, true, arrow)
	for step in 4:
		await move(arrow + 40.0 * (step + 1) * way, MOUSE_BUTTON_MASK_LEFT)
	await button(MOUSE_BUTTON_LEFT, false, arrow + 160.0 * way)
	await worked()
	var bent := path.curve.get_point_position(0)
	assert_greater((bent - Vector3(-3, 0, 0)).length(), 0.8, "the point was dragged")
	return bent


func test_the_grass_follows_a_point_of_the_curve_that_is_dragged() -> void:
	field.fill_rule = GrassFillRule.new()
	var path := await add_path({})
	assert_near(density(-2.75, 0.25), 0.0, 0.0, "straight")
	var bent := await drag_a_point(path)
	assert_near(density(-2.75, 0.25), 1.0, 0.0, "where it was")
	assert_near(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(bent.x, bent.z)), 0.0, 0.3, "where it is")
	await undo()
	await worked()
	assert_near(density(-2.75, 0.25), 0.0, 0.0, "undone")
	await select(field)
	path.free()
	await worked()
	assert_near(density(-2.75, 0.25), 1.0, 0.0, "gone")


func test_a_hedge_grows_its_species_along_the_path() -> void:
	var hedge := GrassField.new()
	hedge.size = field.size
	hedge.density = 16.0
	hedge.species = [load("res://addons/grass_field/presets/small_shrub.tres")]
	hedge.add_to_group("hedges")
	hedge.fill_rule = GrassFillRule.new()
	hedge.fill_rule.density = 0.0
	EditorInterface.get_edited_scene_root().add_child(hedge)
	hedge.owner = field.owner
	var path := await add_path({mode = GrassPath3D.MODE_PLANT, field_group = &"hedges"})
	var here := Vector2(-2.75, 0.25)
	assert_near(hedge.map.sample(GrassMap.CHANNEL_DENSITY, here), 1.0, 0.0, "along the path")
	assert_near(hedge.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(-2.75, 3)), 0.0, 0.0, "nowhere else")
	assert_true(field.map == null, "in no field but its own")
	var bent := await drag_a_point(path)
	assert_near(hedge.map.sample(GrassMap.CHANNEL_DENSITY, here), 0.0, 0.0, "where it was")
	assert_near(hedge.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(bent.x, bent.z)), 1.0, 0.3, "where it is")
	await undo()
	await worked()
	assert_near(hedge.map.sample(GrassMap.CHANNEL_DENSITY, here), 1.0, 0.0, "undone")
	await select(field)

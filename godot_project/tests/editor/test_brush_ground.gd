# SPDX-License-Identifier: MIT
## The brush in the editor on uneven ground: where strokes land, what is baked, and which limits apply.
@tool
extends "res://tests/editor/editor_case.gd"

const DRAWN := ["test_the_button_bakes_the_whole_field"]  # see runner.gd


func test_strokes_land_on_the_ground_under_the_cursor() -> void:
	var grounds := {
		"hill, seen through a ball": Vector3(-4, 1.2, -7),
		"csg": Vector3(1.5, 1.0, -4),
		"tilted floor": Vector3(-5.05, 1.287, -1),
		"plane": Vector3(0, 0, 0),
	}
	await take("Erase")
	var eye := camera_transform().origin
	for ground: String in grounds:
		var point: Vector3 = grounds[ground]
		await stroke([point, point])
		if not assert_true(field.map != null, "a stroke on the " + ground):
			continue
		assert_less(density(point.x, point.z), 0.9, ground)
		if point.y > 0.0:
			var behind := eye + (point - eye) * eye.y / (eye.y - point.y)  # on the plane
			assert_greater(Vector2(behind.x - point.x, behind.z - point.z).length(), 2.0)
			assert_near(density(behind.x, behind.z), 1.0, 0.0, "not on the plane behind the " + ground)


func test_painting_bakes_the_ground_under_the_brush() -> void:
	var place := Vector3(-5.05, 1.287, -1)  # on the tilted floor
	field.size = Vector2(300, 300)  # too large to be baked at once
	await frames(2)
	await take("Erase")
	await stroke([place, place])
	if not assert_true(field.map != null):
		return
	assert_near(ground(place.x, place.z), 1.287, 0.08, "where the brush was")
	assert_near(ground(-4, -7), 0.0, 0.0, "on the hill beside it")
	var rays: int = plugin.get_statistics().rays
	assert_true(rays > 0 and rays < 12000, "%d rays" % rays)
	await undo()
	await redo()
	assert_near(ground(place.x, place.z), 1.287, 0.08)
	(toolbar.get_node("Menu") as MenuButton).get_popup().id_pressed.emit(3)
	await stroke([Vector3(-4, 1.2, -7), Vector3(-4, 1.2, -7)])
	assert_less(density(-4, -7), 0.9)
	assert_near(ground(-4, -7), 0.0, 0.0, "told not to")
	(toolbar.get_node("Menu") as MenuButton).get_popup().id_pressed.emit(3)


func test_the_button_bakes_the_whole_field() -> void:
	await click(toolbar.get_node("Bake"))
	if not assert_true(field.map != null):
		return
	assert_near(ground(-4, -7), 1.2, 0.15, "hill")
	assert_near(ground(1.5, -4), 1.0, 0.1, "csg")
	assert_near(field.map.base_density, 1.0, 0.0, "grass stands everywhere")
	var stands := func() -> bool:
		var root := field.get_knots(field.get_tile_at(Vector3(-4, 0, -7)), 20)[0]
		return absf(root.y - ground(root.x, root.z)) < 0.1
	await wait_until(stands, "blades stand on it")
	await undo()
	assert_true(field.map == null)
	await redo()
	assert_near(ground(-4, -7), 1.2, 0.15)
	for child: String in ["Hill", "TiltedFloor", "Csg"]:
		field.get_node("../" + child).free()
	await settled()  # grass that stood on them comes down
	var before := heights()
	await click(toolbar.get_node("Bake"))
	var after := heights()
	for i in before.size():
		assert_near(after[i], before[i], 0.005, "no ground: heights only move from the hill's vertices into their texels")


func test_a_stroke_that_only_bakes_is_a_step_of_the_history() -> void:
	(toolbar.get_node("Menu") as MenuButton).get_popup().id_pressed.emit(1)
	var place := Vector3(-5.05, 1.287, -1)
	assert_near(ground(place.x, place.z), 1.287, 0.08)
	(field.get_node("../TiltedFloor") as Node3D).position.y += 0.5
	await frames(3)
	await take("Paint")  # where all is painted already
	await stroke([place + Vector3(0, 0.5, 0), place + Vector3(0, 0.5, 0)])
	assert_near(ground(place.x, place.z), 1.787, 0.08)
	await undo()
	assert_near(ground(place.x, place.z), 1.287, 0.08)
	(toolbar.get_node("Menu") as MenuButton).get_popup().id_pressed.emit(2)
	assert_near(ground(place.x, place.z), 1.287, 0.08, "what is painted is cleared, the ground is not")


func test_strokes_keep_to_slopes_and_heights() -> void:
	var level := Vector3(0, 0, 0)
	var tilted := Vector3(-5.05, 1.287, -1)
	await take("Erase")
	set_limit("SlopeMax", 15.0)
	await stroke([level, level])
	await stroke([tilted, tilted])
	assert_less(density(level.x, level.z), 0.9, "level ground")
	assert_near(density(tilted.x, tilted.z), 1.0, 0.0, "30 degrees are too steep")
	set_limit("SlopeMax", 90.0)
	set_limit("HeightMin", 0.5)
	await stroke([Vector3(1, 0, -1), Vector3(1, 0, -1)])
	await stroke([tilted, tilted])
	assert_near(density(1, -1), 1.0, 0.0, "too low")
	assert_less(density(tilted.x, tilted.z), 0.9, "high enough")


func ground(x: float, z: float) -> float:
	return field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(x, z))

# SPDX-License-Identifier: MIT
## Pictures of the guide: a field and its properties; toolbar, ring and strokes on a meadow that rises; the preview of the brush; the answer
## to why there is no grass. They are saved beside the test's copy of the project as editor.png, painting.png, preview.png and why.png. The
## test checks what numbers can check.
@tool
extends "res://tests/editor/editor_case.gd"

const DRAWN := [
	"test_a_field_and_its_properties",
	"test_toolbar_ring_and_strokes",
	"test_the_grass_before_the_stroke",
	"test_the_answer_beside_the_cursor"
]  # see runner.gd


func before() -> void:
	ResourceSaver.save(meadow(), SAVED)
	await open(SAVED)
	reset_brush()


static func height(x: float, z: float) -> float:
	return 1.6 * smoothstep(1.0, -8.0, z) + 0.25 * sin(0.7 * x) * smoothstep(1.0, -4.0, z)


func meadow() -> PackedScene:
	var root := Node3D.new()
	root.name = "Meadow"
	var heights := PackedFloat32Array()
	for z in SIDE + 1:
		for x in SIDE + 1:
			heights.append(height(x - 0.5 * SIDE, z - 0.5 * SIDE))
	var terrain := soil(SIDE, height)
	terrain.name = "Terrain"
	root.add_child(terrain)
	var body := StaticBody3D.new()
	body.name = "Ground"
	body.visible = false  # its lines would cross the picture
	root.add_child(body)
	var shape := HeightMapShape3D.new()
	shape.map_width = SIDE + 1
	shape.map_depth = SIDE + 1
	shape.map_data = heights
	var node := CollisionShape3D.new()
	node.shape = shape
	body.add_child(node)
	var field := GrassField.new()
	field.name = "Field"
	field.size = Vector2(16, 16)
	field.density = 16.0  # while it is painted
	field.position = Vector3(0, 0, -4)
	root.add_child(field)
	var world := WorldEnvironment.new()
	world.name = "World"
	world.environment = load("res://demo/day.tres")
	if not is_for_pages():
		world.environment = world.environment.duplicate(true)
		world.environment.sky.radiance_size = Sky.RADIANCE_SIZE_32  # it has no details
	root.add_child(world)
	var sun := DirectionalLight3D.new()
	sun.name = "Sun"
	sun.rotation_degrees = Vector3(-40, -50, 0)
	root.add_child(sun)
	for child: Node in [terrain, body, node, field, world, sun]:
		child.owner = root
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	return scene


func on(x: float, z: float) -> Vector3:
	return Vector3(x, height(x, z), z)


func test_a_field_and_its_properties() -> void:
	await click(toolbar.get_node("Bake"))
	await move(at(on(0, 0)))
	var sections := EditorInterface.get_inspector().find_children("*", "EditorInspectorSection", true, false)
	assert_greater(sections.size(), 1)
	sections[0].unfold()
	field.density = density_of_picture(256.0)
	await worked()
	await shoot("editor")
	sections[0].fold()


func test_toolbar_ring_and_strokes() -> void:
	await click(toolbar.get_node("Bake"))
	await move(at(on(0, 0)))
	await key(KEY_V)  # the mode without arrows at the node
	await take("Erase")
	for number: Array in [["Radius", 0.5], ["Strength", 0.6], ["Hardness", 0.6]]:
		(toolbar.find_child(number[0], true, false) as Range).value = number[1]
	await stroke([on(1.4, 0.4), on(0.9, -0.8), on(1.2, -2), on(2, -3.5), on(2.2, -5), on(1.4, -6.5)])
	await take("Tint")
	(toolbar.get_node("Radius") as Range).value = 0.9
	(toolbar.get_node("Color") as ColorPickerButton).color = Color(0.95, 0.7, 0.25)
	(toolbar.get_node("Color") as ColorPickerButton).color_changed.emit(Color(0.95, 0.7, 0.25))
	await stroke([on(-3, -4), on(-1.6, -3.6), on(-0.9, -2.6)])
	assert_near(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(1.2, 2)), 0.0, 0.1, "the path")
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(0.5, -3.5)), height(0.5, -7.5), 0.05, "the hill")
	await move(at(on(-0.9, -2.2)))
	assert_true(plugin.get_statistics().ring)
	field.density = density_of_picture(144.0)
	await shoot("painting")


func test_the_grass_before_the_stroke() -> void:
	await click(toolbar.get_node("Bake"))
	await move(at(on(0, 0)))
	await key(KEY_V)
	await take("Cut")
	for number: Array in [["Radius", 1.4], ["Strength", 1.0], ["Hardness", 0.4], ["CutHeight", 0.05]]:
		(toolbar.find_child(number[0], true, false) as Range).value = number[1]
	field.density = density_of_picture(144.0)
	await worked()
	var painted := field.map.data
	await move(at(on(0.8, -1.5)))
	await frames(5)
	assert_eq(plugin.get_statistics().preview, 1)
	assert_eq(field.map.data, painted, "nothing is cut")
	await shoot("preview")


func test_the_answer_beside_the_cursor() -> void:
	await click(toolbar.get_node("Bake"))
	var rule := GrassFillRule.new()
	rule.slope_max = 12.0
	rule.slope_fade = 3.0
	field.fill_rule = rule
	var path := GrassPath3D.new()
	path.name = "Trail"
	path.curve = Curve3D.new()
	for point: Array in [[3.5, 2.5, -0.8], [1.5, 0, -1.5], [2.5, -3.2, 0.5], [1.0, -7, -1.5]]:
		var way := Vector3(point[2], 0, -1.2)
		path.curve.add_point(on(point[0], point[1]) + 0.03 * Vector3.UP, -way, way)
	path.width = 1.0
	path.fade = 0.3
	EditorInterface.get_edited_scene_root().add_child(path)
	path.owner = EditorInterface.get_edited_scene_root()
	await worked()
	await move(at(on(0, 0)))
	await key(KEY_V)
	await take("Why")
	field.density = density_of_picture(144.0)
	await worked()
	await move(at(on(1.5, 0)))
	var panel: Control = get_tree().root.find_child("GrassAnswer", true, false)
	assert_true(panel.get_child(0).text.contains("'Trail'"), panel.get_child(0).text)
	await shoot("why")
	await move(at(on(-2.4, -4)))
	assert_true(panel.get_child(0).text.contains("slope"), panel.get_child(0).text)

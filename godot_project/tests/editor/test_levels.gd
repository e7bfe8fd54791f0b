# SPDX-License-Identifier: MIT
## The brush and the question mark on fields above one another: they mean the field that the cursor points at.
@tool
extends "res://tests/editor/editor_case.gd"

const ON_DECK := Vector3(0.8, 0.8, -0.5)  # in view, as all places here
const BESIDE := Vector3(-0.8, 0, 0.5)  # on the meadow

var bridge: GrassField  # 2 x 2 m, 0.8 m above the meadow


func before() -> void:
	await super()
	var root := EditorInterface.get_edited_scene_root()
	var deck := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	(shape.shape as BoxShape3D).size = Vector3(2, 0.2, 2)
	deck.add_child(shape)
	deck.name = "Deck"
	deck.position = ON_DECK - Vector3(0, 0.1, 0)
	root.add_child(deck)
	bridge = GrassField.new()
	bridge.name = "Bridge"
	bridge.size = Vector2(2, 2)
	bridge.density = 64.0
	bridge.position = ON_DECK
	root.add_child(bridge)
	for node: Node in [deck, shape, bridge]:
		node.owner = root
	await frames(3)


func set_bands() -> void:
	field.ground_low = -1.0
	field.ground_high = 0.5
	bridge.ground_low = -0.3
	bridge.ground_high = 1.0
	await frames(3)


## Returns the height of the meadow's map, metres.
func ground(x: float, z: float) -> float:
	return field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(x, z)) if field.map else NAN


func of_bridge(place: Vector3) -> float:
	return bridge.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(place.x - ON_DECK.x, place.z - ON_DECK.z)) if bridge.map else 1.0


## Returns where the line of sight through a place of the deck meets the plane of the meadow.
func below(place: Vector3) -> Vector3:
	var eye := camera_transform().origin
	return eye + (place - eye) * eye.y / (eye.y - place.y)


func test_the_brush_paints_the_level_that_it_points_at() -> void:
	await set_bands()
	await take("Erase")
	await stroke([ON_DECK, ON_DECK + Vector3(0.2, 0, 0)])
	assert_less(of_bridge(ON_DECK), 0.9, "the bridge, though the meadow is selected")
	assert_true(field.map == null, "and nothing below it")
	var before := bridge.map.data
	await stroke([BESIDE, BESIDE + Vector3(0.2, 0, 0)])
	assert_less(density(BESIDE.x, BESIDE.z), 0.9, "the meadow")
	assert_eq(bridge.map.data, before)
	await select(bridge)
	await take("Erase")
	var meadow := field.map.data
	await stroke([ON_DECK + Vector3(-0.5, 0, 0), ON_DECK + Vector3(-0.3, 0, 0)])
	assert_ne(bridge.map.data, before)
	assert_eq(field.map.data, meadow, "whichever is selected")


func test_what_is_beyond_all_bands_does_not_stop_the_brush() -> void:
	await set_bands()
	bridge.free()
	await take("Erase")
	var place := below(ON_DECK)
	await stroke([ON_DECK, ON_DECK])
	assert_less(density(place.x, place.z), 0.9, "the ground is painted through the deck")
	assert_near(ground(place.x, place.z), 0.0, 0.02, "and stays below it")


func test_without_bands_the_selected_field_is_painted() -> void:
	await take("Erase")
	await stroke([ON_DECK, ON_DECK])
	assert_true(bridge.map == null, "its middle is over the selected one")
	assert_less(density(ON_DECK.x, ON_DECK.z), 0.9)


func test_baking_reads_the_own_level() -> void:
	await set_bands()
	await click(toolbar.get_node("Bake"))
	assert_near(ground(ON_DECK.x, ON_DECK.z), 0.0, 0.02, "below the deck")
	field.ground_high = 1024.0
	await click(toolbar.get_node("Bake"))
	assert_near(ground(ON_DECK.x, ON_DECK.z), ON_DECK.y, 0.05, "without a band it climbs onto it")


func test_the_question_mark_names_the_level() -> void:
	await set_bands()
	await take("Why")
	await move(at(ON_DECK))
	var panel: Control = get_tree().root.find_child("GrassAnswer", true, false)
	var text: String = panel.get_child(0).text
	assert_true(text.begins_with("Bridge: ") and text.contains("grows here"), text)
	await move(at(BESIDE))
	text = panel.get_child(0).text
	assert_true(not text.contains("Bridge") and text.contains("grows here"), text)


func test_a_wall_beside_the_floor_is_painted_when_it_is_selected() -> void:
	bridge.position = Vector3(-4, 1, -3)  # stands on its side, behind
	bridge.rotation_degrees.x = 90.0
	await frames(3)
	var place := Vector3(-4, 1, -3)
	await take("Erase")
	await stroke([Vector3(-4, 0, -2.8), Vector3(-3.5, 0, -2.8)])
	assert_true(bridge.map == null, "the floor's brush leaves it")
	await select(bridge)
	await take("Erase")
	await stroke([place, place + Vector3(0.5, 0.3, 0)])
	if assert_true(bridge.map != null, "the wall's own"):
		assert_less(bridge.map.sample(GrassMap.CHANNEL_DENSITY, Vector2.ZERO), 0.9)

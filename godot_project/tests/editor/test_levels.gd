# SPDX-License-Identifier: MIT
## Fields above one another and on walls, in the editor.
@tool
extends "res://tests/editor/editor_case.gd"

const ON_DECK := Vector3(4, 2, 0)

var bridge: GrassField  # 6 x 4 m, 2 m above the right of the field


func before() -> void:
	await super()
	var root := EditorInterface.get_edited_scene_root()
	var deck := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	(shape.shape as BoxShape3D).size = Vector3(6, 0.2, 4)
	deck.add_child(shape)
	deck.name = "Deck"
	deck.position = Vector3(4, 1.9, 0)
	root.add_child(deck)
	bridge = GrassField.new()
	bridge.name = "Bridge"
	bridge.size = Vector2(6, 4)
	bridge.density = 4.0
	bridge.position = ON_DECK
	root.add_child(bridge)
	for node: Node in [deck, shape, bridge]:
		node.owner = root
	await frames(3)


func set_bands() -> void:
	field.ground_low = -1.0
	field.ground_high = 1.5
	bridge.ground_low = -0.5
	bridge.ground_high = 1.0
	await frames(3)


func ground(x: float, z: float) -> float:
	return field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(x, z)) if field.map else -1.0


func test_baking_reads_the_own_level() -> void:
	await set_bands()
	await click(toolbar.get_node("Bake"))
	assert_near(ground(4, 0), 0.0, 0.02, "below the deck")
	field.ground_high = 1024.0
	await click(toolbar.get_node("Bake"))
	assert_near(ground(4, 0), 2.0, 0.05, "without a band it climbs onto it")


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

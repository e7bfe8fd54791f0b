# SPDX-License-Identifier: MIT
## Copy and paste of what is painted, under the brush and of whole fields, and of species between fields.
@tool
extends "res://tests/editor/owned_case.gd"

enum Menu { UNIQUE = 7, COPY, PASTE, COPY_SPECIES, PASTE_SPECIES }

const WHEAT := "res://addons/grass_field/presets/wheat.tres"
const CLOVER := "res://addons/grass_field/presets/clover.tres"

var right: GrassField  # 4 m to the right of the field


func before() -> void:
	await super()
	field.size = Vector2(4, 4)
	right = GrassField.new()
	right.name = "Right"
	right.size = Vector2(4, 4)
	right.density = 4.0
	right.position = Vector3(4, 0, 0)
	EditorInterface.get_edited_scene_root().add_child(right)
	right.owner = EditorInterface.get_edited_scene_root()
	await frames(3)
	menu_of(4)  # no neighbours
	set_number("Strength", 1.0)
	set_number("Hardness", 1.0)


func after() -> void:
	menu_of(4)
	await super()


func menu_of(item: int) -> void:
	(toolbar.get_node("Menu") as MenuButton).get_popup().id_pressed.emit(item)


func of(map: GrassMap, channel_of: GrassMap.Channel, place: Vector2) -> float:
	return map.sample(channel_of, place) if map else -1.0


## Erases around a place of the field, and mows beside it.
func paint_field() -> void:
	set_number("Radius", 0.5)
	await take("Erase")
	await stroke([Vector3(-1, 0, 0), Vector3(-1, 0, 0)])
	await take("Cut")
	await stroke([Vector3(0, 0, 0), Vector3(0, 0, 0)])


func test_what_is_under_the_brush_is_pasted_under_the_brush() -> void:
	await paint_field()
	var painted := field.map.data
	set_number("Radius", 1.6)
	await move(at(Vector3(-0.5, 0, 0)))
	await key(KEY_C, KEY_MASK_CTRL)
	assert_eq(field.map.data, painted, "copying changes nothing")
	assert_eq(EditorInterface.get_edited_scene_root().find_children("*", "GrassField").size(), 2)
	await select(right)
	await take("Cut")
	await move(at(Vector3(3.5, 0, 0)))
	await key(KEY_V, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	assert_true(right.map == null, "with Shift the keys are for nodes")
	await key(KEY_V, KEY_MASK_CTRL)
	if not assert_true(right.map != null, "pasted"):
		return
	assert_near(of(right.map, GrassMap.CHANNEL_DENSITY, Vector2(-1, 0)), of(field.map, GrassMap.CHANNEL_DENSITY, Vector2(-1, 0)), 0.01)
	assert_near(of(right.map, GrassMap.CHANNEL_CUT, Vector2(0, 0)), of(field.map, GrassMap.CHANNEL_CUT, Vector2(0, 0)), 0.01)
	assert_less(of(right.map, GrassMap.CHANNEL_DENSITY, Vector2(-1, 0)), 0.3)
	assert_near(of(right.map, GrassMap.CHANNEL_DENSITY, Vector2(1.5, 1.5)), 1.0, 0.01, "beside it")
	assert_eq(EditorInterface.get_edited_scene_root().find_children("*", "GrassField").size(), 2, "no node is pasted")
	var pasted := right.map.data
	await undo()
	assert_true(right.map == null, "one step")
	await redo()
	assert_eq(right.map.data, pasted)


func test_without_a_tool_the_keys_are_for_nodes() -> void:
	await paint_field()
	await key(KEY_ESCAPE)
	await move(at(Vector3(-0.5, 0, 0)))
	var painted := field.map.data
	await key(KEY_C, KEY_MASK_CTRL)
	await key(KEY_V, KEY_MASK_CTRL)
	await frames(3)
	assert_eq(field.map.data, painted)


func test_the_menu_copies_a_whole_field() -> void:
	await paint_field()
	menu_of(Menu.COPY)
	await select(right)
	menu_of(Menu.PASTE)
	await frames(2)
	if not assert_true(right.map != null and right.map != field.map, "a map of its own"):
		return
	for place: Vector2 in [Vector2(-1, 0), Vector2(0, 0), Vector2(1.5, 1.5)]:
		for channel_of: GrassMap.Channel in [GrassMap.CHANNEL_DENSITY, GrassMap.CHANNEL_CUT]:
			assert_near(of(right.map, channel_of, place), of(field.map, channel_of, place), 0.01, "%s %s" % [channel_of, place])
	await undo()
	assert_true(right.map == null)


func test_a_field_that_is_too_large_is_not_copied() -> void:
	field.size = Vector2(300, 300)
	await frames(2)
	menu_of(Menu.COPY)
	assert_true(is_told("square metres can be copied"))


func test_species_go_from_field_to_field_beside_its_own() -> void:
	var own := GrassSpecies.new()
	field.species = [load(CLOVER), load(WHEAT)]
	right.species = [own, load(WHEAT)]
	await select(field)
	menu_of(Menu.COPY_SPECIES)
	await select(right)
	menu_of(Menu.PASTE_SPECIES)
	await frames(2)
	assert_eq(right.species, [own, load(WHEAT), load(CLOVER)] as Array[GrassSpecies])
	await undo()
	assert_eq(right.species.size(), 2)


func test_another_scene_gets_copies_of_species_that_are_no_files() -> void:
	var own := GrassSpecies.new()
	own.share = 0.25
	field.species = [own, load(WHEAT)]
	menu_of(Menu.COPY_SPECIES)
	menu_of(Menu.COPY)
	var painted := field.map
	write_base(false)
	await open(base)
	assert_true(painted == null)
	menu_of(Menu.PASTE_SPECIES)
	await frames(2)
	if assert_eq(field.species.size(), 3, "beside the default grass"):
		assert_true(field.species[1] != own)
		assert_near(field.species[1].share, 0.25, 1e-6)
		assert_eq(field.species[2], load(WHEAT))
	menu_of(Menu.PASTE)
	await frames(2)
	assert_near(of(field.map, GrassMap.CHANNEL_CUT, Vector2.ZERO), 2.55, 0.01, "grass that is nowhere cut, over the cut of the base")


func test_painted_species_are_pasted_by_what_they_are() -> void:
	field.species = [GrassSpecies.new(), load(WHEAT), load(CLOVER)]
	right.species = [load(WHEAT), GrassSpecies.new()]
	await frames(3)
	field.map = GrassMap.new()
	field.map.base_density = 1.0
	for species: int in [2, 3]:
		var brush := GrassBrush.new()
		brush.tool = GrassBrush.TOOL_SPECIES
		brush.species = species
		brush.radius = 0.6
		brush.strength = 1.0
		brush.hardness = 1.0
		field.map.stroke(brush, Vector2(species - 3.5, 0.5), Vector2(species - 3.5, 0.5))
	menu_of(Menu.COPY)
	await select(right)
	menu_of(Menu.PASTE)
	await frames(2)
	assert_eq(of(right.map, GrassMap.CHANNEL_SPECIES, Vector2(-1.5, 0.5)), 1.0, "wheat, the first one here")
	assert_eq(of(right.map, GrassMap.CHANNEL_SPECIES, Vector2(-0.5, 0.5)), 0.0, "clover does not grow here")
	assert_true(is_told("1 species"), "and the editor says so")

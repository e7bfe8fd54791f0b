# SPDX-License-Identifier: MIT
## A stroke over several fields paints each on its own map, and is one step of the undo history.
@tool
extends "res://tests/editor/editor_case.gd"

const ACROSS: Array = [Vector3(1, 0, 0), Vector3(2, 0, 0), Vector3(3, 0, 0), Vector3(4, 0, 0)]
const BESIDE := Vector3(3.75, 0, -1.5)  # on the neighbour alone

var right: GrassField  # turned by a quarter, begins 2.5 m to the right of the middle


func before() -> void:
	await super()
	field.size = Vector2(5, 5)
	right = add_field("Right", Vector3(5, 0, 0))
	right.rotation_degrees.y = 90.0
	await frames(3)


func after() -> void:
	var menu := popup()
	if not menu.is_item_checked(menu.get_item_index(4)):
		menu.id_pressed.emit(4)
	await super()


func popup() -> PopupMenu:
	return (toolbar.get_node("Menu") as MenuButton).get_popup()


func add_field(named: String, place: Vector3) -> GrassField:
	var root := EditorInterface.get_edited_scene_root()
	var added := GrassField.new()
	added.name = named
	added.size = Vector2(5, 5)
	added.density = 4.0
	added.position = place
	root.add_child(added)
	added.owner = root
	return added


## Returns what a field's map holds at a place of the world.
func at_world(of: GrassField, channel_of: GrassMap.Channel, place: Vector3) -> float:
	var local := of.to_local(place)
	return of.map.sample(channel_of, Vector2(local.x, local.z)) if of.map else -1.0


func test_a_stroke_across_the_border_paints_both_in_one_step() -> void:
	await take("Erase")
	await stroke(ACROSS)
	for x: float in [1.25, 2.25]:
		assert_less(at_world(field, GrassMap.CHANNEL_DENSITY, Vector3(x, 0, 0)), 0.3, "the chosen field at %s" % x)
	for x: float in [2.75, 3.75]:
		assert_less(at_world(right, GrassMap.CHANNEL_DENSITY, Vector3(x, 0, 0)), 0.3, "its neighbour at %s" % x)
	assert_near(at_world(right, GrassMap.CHANNEL_DENSITY, Vector3(5, 0, 2)), 1.0, 0.01, "the neighbour, beside the stroke")
	if not assert_true(field.map != right.map and right.map != null, "each has a map of its own"):
		return
	var first := right.map.data
	var chosen := field.map.data
	set_number("Radius", 0.5)
	await stroke([Vector3(3.2, 0, -1.5), Vector3(3.5, 0, -1.5)])
	assert_eq(field.map.data, chosen)
	assert_ne(right.map.data, first, "a stroke on the neighbour alone")
	var both := [field.map.data, right.map.data]
	await undo()
	assert_eq(right.map.data, first)
	await undo()
	assert_true(field.map == null and right.map == null, "one step back, for both")
	await redo()
	await redo()
	assert_eq([field.map.data, right.map.data], both)
	EditorInterface.save_scene()
	await open(SAVED)
	right = field.get_node("../Right")
	assert_eq([field.map.data, right.map.data], both, "saved, both")


func test_escape_takes_back_all_of_it() -> void:
	await take("Erase")
	await move(at(ACROSS[0]))
	await button(MOUSE_BUTTON_LEFT, true, at(ACROSS[0]))
	for place: Vector3 in ACROSS:
		await move(at(place), MOUSE_BUTTON_MASK_LEFT)
	assert_true(right.map != null)
	await key(KEY_ESCAPE)
	assert_true(field.map == null and right.map == null)
	await button(MOUSE_BUTTON_LEFT, false, at(ACROSS[3]))


func test_locked_hidden_and_stacked_fields_are_left_alone() -> void:
	var over := add_field("Over", Vector3(0.5, 0, 0.5))  # its middle lies on the chosen one
	await take("Erase")
	right.set_meta("_edit_lock_", true)
	await stroke(ACROSS)
	assert_true(right.map == null, "locked")
	assert_true(over.map == null, "lies on the chosen one")
	right.remove_meta("_edit_lock_")
	right.visible = false
	await stroke(ACROSS)
	assert_true(right.map == null, "hidden")
	right.visible = true
	right.rotation_degrees.x = 50.0
	await stroke(ACROSS)
	assert_true(right.map == null, "faces another way")
	right.rotation_degrees.x = 0.0
	popup().id_pressed.emit(4)
	await stroke(ACROSS)
	assert_true(right.map == null, "told not to")


func test_a_shared_map_is_painted_in_one_of_its_places() -> void:
	field.map = GrassMap.new()
	field.map.base_density = 1.0
	right.map = field.map
	await frames(3)
	await take("Erase")
	await stroke(ACROSS)
	assert_less(at_world(field, GrassMap.CHANNEL_DENSITY, Vector3(1.25, 0, 0)), 0.3)
	assert_near(at_world(right, GrassMap.CHANNEL_DENSITY, Vector3(3.75, 0, 0)), 1.0, 0.0)
	await stroke(ACROSS)
	await wait_until(func() -> bool: return times_told("have the same map") > 0, "the editor says that it is shared")
	await frames(10)
	assert_eq(times_told("have the same map"), 1, "once for a selected field")


## Returns how often the editor has shown a message with this in it, which it counts behind the message.
func times_told(part: String) -> int:
	for label: Label in EditorInterface.get_editor_toaster().find_children("*", "Label", true, false):
		if label.text.contains(part):
			var count: Label = label.get_parent().get_child(label.get_index() + 1)
			return maxi(1, count.text.to_int())
	return 0


func test_species_are_found_by_what_they_are() -> void:
	var wheat: GrassSpecies = load("res://addons/grass_field/presets/wheat.tres")
	var named: GrassSpecies = load("res://addons/grass_field/presets/clover.tres").duplicate()
	named.resource_name = "Wheat"
	var own: GrassSpecies = wheat.duplicate()
	own.resource_name = "Wheat"
	var far := add_field("Far", Vector3(5, 0, -5))  # grows no wheat
	far.species = [GrassSpecies.new()]
	field.species = [GrassSpecies.new(), wheat]
	right.species = [wheat, GrassSpecies.new(), GrassSpecies.new()]
	await frames(3)
	await take("Species")
	await move(at(ACROSS[0]))
	await key(KEY_BRACKETRIGHT, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	set_number("Hardness", 1.0)
	set_number("Strength", 1.0)
	await stroke(ACROSS)
	assert_near(at_world(field, GrassMap.CHANNEL_SPECIES, Vector3(1.75, 0, 0.25)), 2.0, 0.0, "its second")
	assert_near(at_world(right, GrassMap.CHANNEL_SPECIES, Vector3(3.25, 0, 0.25)), 1.0, 0.0, "the neighbour's first, the same resource")
	assert_eq(plugin.get_statistics().left_out, PackedStringArray())
	await stroke([Vector3(3.5, 0, -4.5), Vector3(3.8, 0, -4.5)])
	assert_true(far.map == null, "where it does not grow, nothing is planted")
	assert_eq(plugin.get_statistics().left_out, PackedStringArray(["Far"]), "and the editor says so")
	field.species = [GrassSpecies.new(), own]
	right.species = [GrassSpecies.new(), GrassSpecies.new(), named]
	await frames(3)
	await stroke([Vector3(3.25, 0, -1.5), Vector3(3.5, 0, -1.5)])
	assert_near(at_world(right, GrassMap.CHANNEL_SPECIES, Vector3(3.75, 0, -1.25)), 3.0, 0.0, "another resource of the same name")
	field.species = []  # the choice of a species goes with them
	await frames(3)


func test_a_neighbour_may_go_while_it_is_painted() -> void:
	await take("Erase")
	await move(at(ACROSS[0]))
	await button(MOUSE_BUTTON_LEFT, true, at(ACROSS[0]))
	await move(at(ACROSS[2]), MOUSE_BUTTON_MASK_LEFT)
	assert_true(right.map != null)
	right.free()
	await move(at(ACROSS[3]), MOUSE_BUTTON_MASK_LEFT)
	await button(MOUSE_BUTTON_LEFT, false, at(ACROSS[1]))
	assert_false(plugin.get_statistics().active)
	assert_less(density(1.25, 0), 0.3)
	await undo()
	assert_true(field.map == null)
	await redo()
	assert_less(density(1.25, 0), 0.3)


func test_a_neighbour_that_goes_with_its_new_map_leaves_no_step() -> void:
	await take("Erase")
	var before_it := count_steps()
	await move(at(BESIDE))
	await button(MOUSE_BUTTON_LEFT, true, at(BESIDE))
	assert_true(right.map != null and field.map == null)
	right.free()
	await button(MOUSE_BUTTON_LEFT, false, at(BESIDE))
	assert_false(plugin.get_statistics().active)
	assert_eq(count_steps(), before_it)


func test_the_scene_keeps_the_step_though_the_chosen_field_has_gone() -> void:
	const FILE := "res://tests/editor/right.grassmap"
	var map := GrassMap.new()
	map.base_density = 1.0
	ResourceSaver.save(map, FILE)
	right.map = load(FILE)
	await take("Erase")
	var before_it := count_steps()
	await move(at(BESIDE))
	await button(MOUSE_BUTTON_LEFT, true, at(BESIDE))
	field.free()
	await button(MOUSE_BUTTON_LEFT, false, at(BESIDE))
	assert_less(at_world(right, GrassMap.CHANNEL_DENSITY, BESIDE), 0.6)
	assert_eq(count_steps(), before_it + 1)

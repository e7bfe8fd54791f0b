# SPDX-License-Identifier: MIT
## The brush in the editor: mouse, keys, ring, undo history, and interruptions of a stroke.
@tool
extends "res://tests/editor/editor_case.gd"

const DRAWN := ["test_grass_comes_and_goes_under_the_brush", "test_what_a_script_paints_is_drawn_in_an_idle_editor"]  # see runner.gd
const OTHER := "res://tests/editor/other.tscn"


func test_toolbar_comes_and_goes_with_the_field() -> void:
	assert_true(toolbar.is_visible_in_tree(), "a field is selected")
	await take("Erase")
	await move(at(Vector3.ZERO))
	assert_true(plugin.get_statistics().ring)
	await select(EditorInterface.get_edited_scene_root().get_node("Hill"))
	assert_false(toolbar.is_visible_in_tree(), "something else is selected")
	assert_false(plugin.get_statistics().ring)
	await select(null)
	assert_false(toolbar.is_visible_in_tree(), "nothing is selected")


func test_a_stroke_is_painted_undone_redone_saved_and_loaded() -> void:
	await take("Erase")
	await stroke([Vector3(-1, 0, -0.5), Vector3(0, 0, -0.5), Vector3(1, 0, -1)])
	if not assert_true(field.map != null, "the first stroke makes a map"):
		return
	var map := field.map
	var painted := map.data
	assert_near(map.base_density, 1.0, 0.0, "what grew goes on growing")
	assert_less(density(0, -0.5), 0.2, "on the stroke")
	assert_near(density(0, -3), 1.0, 0.01, "beside it")
	assert_greater(plugin.get_statistics().steps, 4)
	assert_less(plugin.get_statistics().chunks, 4 * plugin.get_statistics().steps + 1, "a brush of 1 m touches at most 4 chunks")
	await stroke([Vector3(-2, 0, -2), Vector3(-1, 0, -2)])
	var twice := map.data
	assert_ne(twice, painted)

	await undo()
	assert_eq(field.map.data, painted, "the second stroke is undone, not the first")
	await undo()
	assert_true(field.map == null, "as before the first stroke")
	await redo()
	assert_eq(field.map, map)
	assert_eq(map.data, painted)
	await redo()
	assert_eq(map.data, twice)

	assert_true(EditorInterface.get_edited_scene_root().scene_file_path in EditorInterface.get_open_scenes())
	assert_eq(EditorInterface.save_scene(), OK)
	await open(SAVED)
	if assert_true(field.map != null, "saved with the scene"):
		assert_eq(field.map.data, twice)
	var on_disk: Node = (ResourceLoader.load(SAVED, "", ResourceLoader.CACHE_MODE_IGNORE_DEEP) as PackedScene).instantiate()
	assert_eq(on_disk.get_node("Field").map.data, twice, "read from the file itself")
	on_disk.free()


func test_the_toolbar_leaves_the_docks_their_place() -> void:
	for tool_name: String in ["Erase", "Tint", "Smooth", "Cut"]:
		await take(tool_name)
		await frames(2)
		assert_less(toolbar.get_global_rect().end.x, view().get_global_rect().end.x + 1.0, tool_name)
		var window := get_tree().root.size
		assert_less(toolbar.size.x, window.x - 500.0, tool_name)
		for control: Control in toolbar.get_children():
			assert_true(not control.visible or toolbar.get_rect().size.x >= control.get_rect().end.x, control.name)


func test_grass_comes_and_goes_under_the_brush() -> void:
	(toolbar.get_node("Menu") as MenuButton).get_popup().id_pressed.emit(0)
	var all: int = field.get_grid_size().x * field.get_grid_size().y
	await wait_until(func() -> bool: return field.get_counters().bare_tiles == all, "the field is bare")
	await take("Paint")
	await press_and_move()
	var bare: int = field.get_counters().bare_tiles
	assert_less(bare, all, "while the button is still down")
	await key(KEY_ESCAPE)
	await frames(1)
	assert_eq(field.get_counters().bare_tiles, all)


func test_what_a_script_paints_is_drawn_in_an_idle_editor() -> void:
	(toolbar.get_node("Menu") as MenuButton).get_popup().id_pressed.emit(0)
	field.wind_speed = 0.0
	await idle()
	var bare: int = field.get_counters().bare_tiles
	var brush := GrassBrush.new()
	for i in 8:
		field.map.stroke(brush, Vector2(-1, 0), Vector2(1, 0))
	await frames(2)
	assert_less(field.get_counters().bare_tiles, bare)
	await idle()
	field.wind_speed = 3.0
	await frames(5)
	var drawn := Engine.get_frames_drawn()
	await frames(30)
	assert_greater(Engine.get_frames_drawn() - drawn, 20, "wind moves it")


func test_keys_and_wheel_change_the_brush() -> void:
	await take("Height")
	var middle := at(Vector3.ZERO)
	await move(middle)
	var cases := [
		["Radius", KEY_BRACKETRIGHT, 0, 1],
		["Radius", KEY_BRACKETLEFT, 0, -1],
		["Hardness", KEY_BRACKETRIGHT, KEY_MASK_SHIFT, 1],
		["Hardness", KEY_BRACKETLEFT, KEY_MASK_SHIFT, -1],
		["Strength", KEY_BRACKETRIGHT, KEY_MASK_CTRL, 1],
		["Strength", KEY_BRACKETLEFT, KEY_MASK_CTRL, -1],
		["Target", KEY_BRACKETLEFT, KEY_MASK_CTRL | KEY_MASK_SHIFT, -1],
		["Target", KEY_BRACKETRIGHT, KEY_MASK_CTRL | KEY_MASK_SHIFT, 1],
	]
	for case: Array in cases:
		var before := number(case[0])
		await key(case[1], case[2])
		assert_eq(int(signf(number(case[0]) - before)), case[3], "%s by key" % case[0])
	for code: Key in [KEY_BRACKETRIGHT, KEY_BRACKETLEFT]:
		var radius := number("Radius")
		await press({keycode = KEY_9, physical_keycode = code})  # a layout on which a bracket needs AltGr
		assert_eq(int(signf(number("Radius") - radius)), 1 if code == KEY_BRACKETRIGHT else -1, "by the key's place")
	cases = [["Radius", KEY_MASK_CTRL], ["Hardness", KEY_MASK_SHIFT], ["Strength", KEY_MASK_CTRL | KEY_MASK_SHIFT]]
	var eye := camera_transform()
	for case: Array in cases:
		for wheel: Array in [
			[MOUSE_BUTTON_WHEEL_UP, 1], [MOUSE_BUTTON_WHEEL_DOWN, -1], [MOUSE_BUTTON_WHEEL_RIGHT, 1], [MOUSE_BUTTON_WHEEL_LEFT, -1]
		]:
			var before := number(case[0])
			await button(wheel[0], true, middle, case[1])
			await button(wheel[0], false, middle, case[1])
			assert_eq(int(signf(number(case[0]) - before)), wheel[1], "%s by wheel" % case[0])
	await frames(10)
	assert_near(camera_transform().origin, eye.origin, 1e-3, "the view stays")
	var kept := number("Radius")
	for index: MouseButton in [MOUSE_BUTTON_WHEEL_UP, MOUSE_BUTTON_WHEEL_DOWN]:
		await button(index, true, middle, KEY_MASK_CTRL | KEY_MASK_ALT)
		await button(index, false, middle, KEY_MASK_CTRL | KEY_MASK_ALT)
		assert_eq(number("Radius"), kept, "with Alt the wheel is the view's")


func press(properties: Dictionary) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventKey.new()
		event.pressed = pressed
		for property: String in properties:
			event.set(property, properties[property])
		await send(event)


func test_a_pen_paints_as_hard_as_it_presses() -> void:
	await take("Erase")
	var left: Array[float] = []
	for pressure: float in [0.2, 1.0]:
		await move(at(Vector3(-1, 0, 0)))
		await button(MOUSE_BUTTON_LEFT, true, at(Vector3(-1, 0, 0)))
		var event := InputEventMouseMotion.new()
		event.position = at(Vector3(1.25, 0, 0.25))
		event.global_position = event.position
		event.button_mask = MOUSE_BUTTON_MASK_LEFT
		event.pressure = pressure
		await send(event)
		await button(MOUSE_BUTTON_LEFT, false, event.position)
		left.append(density(1.25, 0.25))
		await undo()
	assert_less(left[1] + 0.1, left[0], "%s" % [left])


func test_a_view_at_half_resolution_is_painted_where_the_cursor_is() -> void:
	await take("Erase")
	var place := at(Vector3(1, 0, -1))
	var container: SubViewportContainer = view()
	container.stretch_shrink = 2
	await frames(2)
	await move(place)
	await button(MOUSE_BUTTON_LEFT, true, place)
	await button(MOUSE_BUTTON_LEFT, false, place)
	container.stretch_shrink = 1
	assert_less(density(1, -1), 0.9)


func test_held_keys_change_the_tool() -> void:
	await take("Paint")
	var place := Vector3(-0.5, 0, 0.25)
	await stroke([place, place + Vector3(1, 0, 0)], KEY_MASK_CTRL)
	var erased := density(0, 0.25)
	assert_less(erased, 0.3, "Ctrl erases")
	await stroke([place, place + Vector3(1, 0, 0)], KEY_MASK_SHIFT)
	assert_greater(density(0, 0.25), erased, "Shift smooths: grass comes in from the sides")
	await stroke([place, place + Vector3(1, 0, 0)])
	assert_greater(density(0, 0.25), 0.9, "without, it paints")


func test_every_tool_changes_its_channel() -> void:
	var channels := {
		"Density": GrassMap.CHANNEL_DENSITY,
		"Height": GrassMap.CHANNEL_HEIGHT,
		"Species": GrassMap.CHANNEL_SPECIES,
		"Tint": GrassMap.CHANNEL_TINT,
		"Comb": GrassMap.CHANNEL_LEAN,
		"Cut": GrassMap.CHANNEL_CUT,
		"Flatten": GrassMap.CHANNEL_WEAR,
	}
	field.species = [GrassSpecies.new(), GrassSpecies.new()]
	await frames(3)
	for tool_name: String in channels:
		await take(tool_name)
		if tool_name == "Density" or tool_name == "Height":
			set_number("Target", 0.5)
		if tool_name == "Flatten" or tool_name == "Comb":
			set_number("Target", 1.0)
		var before := channel(channels[tool_name])
		await stroke([Vector3(-1, 0, 0), Vector3(0, 0, 0), Vector3(1, 0, 0)])
		assert_ne(channel(channels[tool_name]), before, tool_name)
		await undo()
		assert_eq(channel(channels[tool_name]), before, tool_name + " undone")
		if tool_name == "Density":
			await redo()  # the map stays


func test_escape_takes_the_stroke_back_then_puts_the_brush_down() -> void:
	await take("Erase")
	var from := at(Vector3(-1, 0, 0))
	await move(from)
	await button(MOUSE_BUTTON_LEFT, true, from)
	await move(at(Vector3(1, 0, 0)), MOUSE_BUTTON_MASK_LEFT)
	assert_true(plugin.get_statistics().active)
	assert_less(density(0, 0), 0.5)
	await key(KEY_ESCAPE)
	assert_false(plugin.get_statistics().active)
	assert_true(field.map == null, "as if nothing had been")
	await button(MOUSE_BUTTON_LEFT, false, at(Vector3(1, 0, 0)))
	await key(KEY_ESCAPE)
	assert_false((toolbar.get_node("Erase") as Button).button_pressed)
	assert_false(plugin.get_statistics().ring)


func test_a_lost_release_and_a_lost_focus_end_the_stroke() -> void:
	await take("Erase")
	await press_and_move()
	await move(at(Vector3(1, 0, -2)))  # no button is held any more
	assert_false(plugin.get_statistics().active)
	assert_near(density(1, -2), 1.0, 0.01, "not painted on the way")
	await undo()
	assert_true(field.map == null, "one step")
	await press_and_move()
	get_tree().root.propagate_notification(NOTIFICATION_APPLICATION_FOCUS_OUT)
	assert_false(plugin.get_statistics().active)
	get_tree().root.propagate_notification(NOTIFICATION_APPLICATION_FOCUS_IN)
	await undo()
	assert_true(field.map == null, "one step")


func test_a_field_may_go_while_it_is_painted() -> void:
	await take("Erase")
	await press_and_move()
	field.free()
	await move(at(Vector3(1, 0, -2)), MOUSE_BUTTON_MASK_LEFT)
	await button(MOUSE_BUTTON_LEFT, false, at(Vector3(1, 0, -2)))
	assert_false(plugin.get_statistics().active)
	await undo()
	await open(SAVED)
	assert_true(field != null)


func test_undo_after_the_field_is_gone() -> void:
	await take("Erase")
	await stroke([Vector3(-1, 0, 0), Vector3(1, 0, 0)])
	await stroke([Vector3(-1, 0, -1), Vector3(1, 0, -1)])
	field.free()
	await undo()
	await undo()
	await redo()
	await redo()
	assert_true(EditorInterface.get_edited_scene_root() != null)
	await open(SAVED)


func test_another_scene_may_come_while_it_is_painted() -> void:
	await take("Erase")
	await press_and_move()
	DirAccess.copy_absolute(SCENE, OTHER)
	EditorInterface.open_scene_from_path(OTHER)
	await frames(5)
	assert_false(plugin.get_statistics().active)
	await move(view().get_global_rect().get_center(), MOUSE_BUTTON_MASK_LEFT)
	EditorInterface.close_scene()
	await frames(3)
	await open(SAVED)


func test_the_whole_field_bare_and_full() -> void:
	await take("Erase")
	await stroke([Vector3(-1, 0, 0), Vector3(1, 0, 0)])
	var painted := field.map.data
	var menu: PopupMenu = (toolbar.get_node("Menu") as MenuButton).get_popup()
	menu.id_pressed.emit(0)
	assert_near(density(-5, -5), 0.0, 0.0, "bare")
	menu.id_pressed.emit(1)
	assert_near(density(0, 0), 1.0, 0.0, "full")
	await undo()
	await undo()
	assert_eq(field.map.data, painted)


func test_a_map_of_its_own_file_is_saved_with_the_scene() -> void:
	var path := "res://tests/editor/painted.grassmap"
	field.map = GrassMap.new()
	field.map.base_density = 1.0
	assert_eq(ResourceSaver.save(field.map, path), OK)
	field.map.take_over_path(path)
	await take("Erase")
	await stroke([Vector3(-1, 0, 0), Vector3(1, 0, 0)])
	var painted := field.map.data
	await undo()
	assert_near(density(0, 0), 1.0, 0.01, "the scene's history has it")
	await redo()
	EditorInterface.save_scene()
	await frames(3)
	var saved: GrassMap = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	assert_eq(saved.data, painted)


## What a step costs on a large, painted map; printed, not judged.
func test_a_step_touches_few_chunks_of_a_large_map() -> void:
	field.size = Vector2(1024, 1024)
	field.density = 1.0
	field.map = GrassMap.new()
	var flood := GrassBrush.new()
	flood.radius = 60.0
	for x in range(-480, 481, 60):
		field.map.stroke(flood, Vector2(x, -480), Vector2(x, 480))
	await worked()
	await take("Erase")
	set_number("Radius", 5.0)
	var worst := 0.0
	var slowest := 0.0
	for i in 8:
		await stroke([Vector3(-2, 0, 0), Vector3(0, 0, -1), Vector3(1, 0, -0.5 * i)])
		var costs: Dictionary = plugin.get_statistics()
		worst = maxf(worst, costs.worst_us)
		slowest = maxf(slowest, costs.event_us)
		assert_greater(costs.steps, 0, "steps")
		assert_greater(costs.chunks, 0, "chunks")
		assert_less(costs.chunks, 4 * costs.steps + 1)
	print("a 5 m brush on a map of 1 km^2: longest step %.0f us, longest event with ring and steps %.0f us" % [worst, slowest])

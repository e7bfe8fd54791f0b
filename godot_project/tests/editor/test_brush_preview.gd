# SPDX-License-Identifier: MIT
## The preview of the brush changes the picture and nothing else.
@tool
extends "res://tests/editor/editor_case.gd"

const DRAWN := [
	"test_the_grass_is_drawn_as_a_touch_would_leave_it",
	"test_it_goes_with_the_tool",
	"test_held_keys_show_what_they_would_do",
	"test_a_stroke_takes_its_place",
	"test_the_veil_is_strongest_where_the_brush_is"
]  # see runner.gd
const NEAR := Vector3(0, 0, 0)
const FAR := Vector3(-1, 0, -7)

var all: PackedByteArray  # the map's data: grass everywhere


func before() -> void:
	await super()
	(toolbar.get_node("Menu") as MenuButton).get_popup().id_pressed.emit(1)
	all = field.map.data
	await take("Erase")
	set_number("Radius", 7.0)  # some tiles of 4 m lie in it completely
	set_number("Strength", 1.0)
	set_number("Hardness", 1.0)
	await frames(3)


func hover(place: Vector3) -> void:
	await move(at(place))
	await frames(3)


func bare() -> int:
	return field.get_counters().bare_tiles


func hold(code: Key, pressed: bool) -> void:
	var event := InputEventKey.new()
	event.keycode = code
	event.physical_keycode = code
	event.pressed = pressed
	await send(event)
	await frames(3)


func test_the_grass_is_drawn_as_a_touch_would_leave_it() -> void:
	assert_eq(bare(), 0)
	var there := field.get_density_at(NEAR)
	await hover(NEAR)
	assert_greater(bare(), 0, "drawn")
	assert_eq(plugin.get_statistics().preview, 1)
	assert_eq(field.map.data, all, "and not in the map")
	assert_near(field.get_density_at(NEAR), there, 0.0, "nor in what scripts read")
	await hover(FAR)
	assert_greater(bare(), 0, "goes with the cursor")
	set_number("Strength", 0.3)
	await hover(NEAR)
	assert_eq(bare(), 0, "no more than one touch at this strength")
	set_number("Strength", 1.0)
	await hover(NEAR)
	assert_greater(bare(), 0)
	EditorInterface.save_scene()
	var on_disk: Node = (ResourceLoader.load(SAVED, "", ResourceLoader.CACHE_MODE_IGNORE_DEEP) as PackedScene).instantiate()
	assert_eq(on_disk.get_node("Field").map.data, all, "nor in the file")
	on_disk.free()


func test_it_goes_with_the_tool() -> void:
	await hover(NEAR)
	assert_greater(bare(), 0)
	await key(KEY_ESCAPE)
	await frames(3)
	assert_eq(bare(), 0, "the tool is put down")
	assert_eq(plugin.get_statistics().preview, 0)
	await take("Erase")
	await hover(NEAR)
	assert_greater(bare(), 0)
	await select(EditorInterface.get_edited_scene_root().get_node("Hill"))
	assert_eq(bare(), 0, "another node is selected")
	await select(field)
	await hover(NEAR)
	assert_greater(bare(), 0)
	await click(toolbar.get_node("Why"))
	await frames(3)
	assert_eq(bare(), 0, "another tool")


func test_held_keys_show_what_they_would_do() -> void:
	await hover(NEAR)
	assert_greater(bare(), 0)
	await hold(KEY_CTRL, true)
	assert_eq(bare(), 0, "Ctrl plants: nothing to be seen where all is full")
	await hold(KEY_CTRL, false)
	assert_greater(bare(), 0)
	await key(KEY_BRACKETLEFT)
	for i in 12:
		await key(KEY_BRACKETLEFT)
	await frames(3)
	assert_eq(bare(), 0, "a smaller brush")


func test_a_stroke_takes_its_place() -> void:
	await hover(NEAR)
	await button(MOUSE_BUTTON_LEFT, true, at(NEAR))
	assert_eq(plugin.get_statistics().preview, 0)
	await frames(3)
	assert_greater(bare(), 0, "painted")
	await button(MOUSE_BUTTON_LEFT, false, at(NEAR))
	assert_ne(field.map.data, all)
	await hover(FAR)
	assert_eq(plugin.get_statistics().preview, 1)
	await undo()
	await frames(3)
	assert_eq(field.map.data, all)
	assert_eq(plugin.get_statistics().preview, 0, "the map is another; the next movement shows it again")
	assert_eq(bare(), 0)


func test_neighbours_show_it_too() -> void:
	field.size = Vector2(8, 8)
	var right := GrassField.new()
	right.size = Vector2(8, 8)
	right.density = 4.0
	right.position = Vector3(8, 0, 0)
	right.map = GrassMap.new()
	right.map.base_density = 1.0
	EditorInterface.get_edited_scene_root().add_child(right)
	right.owner = field.owner
	await worked()
	await worked(right)
	await hover(Vector3(3, 0, -1))
	assert_eq(plugin.get_statistics().preview, 2)
	right.free()
	await hover(Vector3(2.5, 0, -1))
	assert_eq(plugin.get_statistics().preview, 1, "a field may go")


func test_a_field_without_a_map_keeps_none() -> void:
	field.map = null
	await worked()
	await hover(NEAR)
	assert_true(plugin.get_statistics().ring)
	assert_eq(plugin.get_statistics().preview, 0)
	assert_true(field.map == null)


## Colours of the picture at a place before and while a brush would act there: the veil shows how strongly.
func test_the_veil_is_strongest_where_the_brush_is() -> void:
	await select(EditorInterface.get_edited_scene_root().get_node("Hill"))
	field.visible = false
	await select(field)
	set_number("Hardness", 0.2)
	set_number("Radius", 2.0)
	set_number("Strength", 1.0)
	draw_finely(true)
	await hover(FAR)
	var without := await colors_of([NEAR, Vector3(1.2, 0, 0), Vector3(3, 0, 0)])
	await hover(NEAR)
	var with := await colors_of([NEAR, Vector3(1.2, 0, 0), Vector3(3, 0, 0)])
	var changes: Array[float] = []
	for i in without.size():
		changes.append(absf(with[i].r - without[i].r) + absf(with[i].g - without[i].g) + absf(with[i].b - without[i].b))
	assert_greater(changes[0], changes[1] + 0.02, "in the middle")
	assert_greater(changes[1], changes[2] + 0.02, "on the soft border")
	assert_near(changes[2], 0.0, 0.02, "outside")
	field.visible = true
	draw_finely(false)


func colors_of(places: Array) -> Array[Color]:
	await frames(3)
	RenderingServer.force_draw(false)  # an editor at rest draws nothing
	var picture := get_tree().root.get_texture().get_image()
	var colors: Array[Color] = []
	for place: Vector3 in places:
		colors.append(picture.get_pixelv(Vector2i(at(place) + Vector2(5, 3))))  # beside the node's own arrows
	return colors

# SPDX-License-Identifier: MIT
## A test that paints in the editor as a person does: with the mouse and the keys.
@tool
extends "res://tests/case.gd"

const SCENE := "res://tests/editor/hills.tscn"
const SIDE := 24  # metres, of SCENE
const SAVED := "res://tests/editor/painted.tscn"  # the copy that tests paint on

var field: GrassField
var toolbar: Control
var plugin: Node


func _init() -> void:
	if DisplayServer.get_name() == "headless":
		allow_error('Parameter "t" is null')  # the engine, of the picture of a scene that it saves


func before() -> void:
	DirAccess.copy_absolute(SCENE, SAVED)
	await open(SAVED)
	if DisplayServer.get_name() != "headless":  # the first field of all waits for its shaders
		await wait_until(func() -> bool: return not field.get_statistics().waiting, "the field is shown")
	reset_brush()


## Returns whether the editor has shown a message with this in it.
func is_told(part: String) -> bool:
	var labels := EditorInterface.get_editor_toaster().find_children("*", "Label", true, false)
	return labels.any(func(label: Label) -> bool: return label.text.contains(part))


func close_messages() -> void:
	for button: Button in EditorInterface.get_editor_toaster().find_children("*", "Button", true, false):
		button.pressed.emit()


## Returns how many steps the history of the edited scene has.
func count_steps() -> int:
	var histories: EditorUndoRedoManager = plugin.get_undo_redo()
	var id := histories.get_object_history_id(EditorInterface.get_edited_scene_root())
	return histories.get_history_undo_redo(id).get_history_count()


## Restores the state in which every test begins, whatever others did.
func reset_brush() -> void:
	var in_hand: BaseButton = toolbar.get_node("Why").button_group.get_pressed_button()
	if in_hand:
		in_hand.button_pressed = false
	set_number("Radius", 1.0)
	set_number("Strength", 0.5)
	set_number("Hardness", 0.5)
	set_number("Target", 1.0)
	set_limit("SlopeMax", 90.0)
	set_limit("HeightMin", -16384.0)


func after() -> void:
	close_messages()  # one would catch the next test's clicks
	EditorInterface.save_scene()  # nothing must ask whether to save when the next test opens its scene
	await select(null)  # what is selected when the editor closes, it looks for once more where there is no tree any longer


## Opens a scene in the 3D view and selects its field.
func open(path: String) -> void:
	EditorInterface.set_main_screen_editor("3D")
	if EditorInterface.get_edited_scene_root() and EditorInterface.get_edited_scene_root().scene_file_path == path:
		EditorInterface.reload_scene_from_path(path)
	else:
		EditorInterface.open_scene_from_path(path)
	await frames(4)
	plugin = get_tree().root.find_children("*", "GrassEditorPlugin", true, false)[0]
	toolbar = get_tree().root.find_child("GrassBrushToolbar", true, false)
	field = EditorInterface.get_edited_scene_root().get_node("Field")
	await select(field)


func select(node: Node) -> void:
	EditorInterface.get_selection().clear()
	if node:
		EditorInterface.edit_node(node)
		EditorInterface.get_selection().add_node(node)
	await frames(3)


## Waits until threads and frames have done all work of a field: it is made, filled, laid out, and its ground is read. Without a window
## the editor draws no frame once it is idle, and a map is laid out right before one.
func worked(of := field) -> void:
	await frames(3)  # what a change asks for, it asks for in the next frames
	var is_done := func() -> bool:
		var now := of.get_statistics().merged(of.get_counters())
		var is_laid_out: bool = now.map_waiting == 0 or DisplayServer.get_name() == "headless"
		return not now.waiting and now.fill_waiting == 0 and is_laid_out and plugin.get_statistics().watch_waiting == 0
	await wait_until(is_done, "the field's work is done")


## Waits until the bodies were checked twice; then the ground is read.
func settled() -> void:
	await frames(50)
	await worked()


## Waits until the editor has nothing left to draw.
func idle() -> void:
	var drawn := -1
	while drawn != Engine.get_frames_drawn():
		drawn = Engine.get_frames_drawn()
		await frames(10)


func view() -> Control:
	return EditorInterface.get_editor_viewport_3d(0).get_parent()


## Returns the place of a point of the world on the screen.
func at(point: Vector3) -> Vector2:
	return view().get_global_transform() * EditorInterface.get_editor_viewport_3d(0).get_camera_3d().unproject_position(point)


func send(event: InputEvent) -> void:
	get_tree().root.push_input(event, true)
	await frames(1)


func move(to: Vector2, held := 0, modifiers := 0) -> void:
	var event := InputEventMouseMotion.new()
	event.position = to
	event.global_position = to
	event.button_mask = held
	_hold(event, modifiers)
	await send(event)


func button(index: MouseButton, pressed: bool, where: Vector2, modifiers := 0) -> void:
	var event := InputEventMouseButton.new()
	event.button_index = index
	event.pressed = pressed
	event.position = where
	event.global_position = where
	event.button_mask = MOUSE_BUTTON_MASK_LEFT if index == MOUSE_BUTTON_LEFT and pressed else 0
	_hold(event, modifiers)
	await send(event)


func key(code: Key, modifiers := 0) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventKey.new()
		event.keycode = code
		event.physical_keycode = code
		event.pressed = pressed
		_hold(event, modifiers)
		await send(event)


func click(control: Control) -> void:
	var middle := control.get_global_rect().get_center()
	await move(middle)
	await button(MOUSE_BUTTON_LEFT, true, middle)
	await button(MOUSE_BUTTON_LEFT, false, middle)


## Chooses a tool by its button.
func take(tool_name: String) -> void:
	var chosen: Button = toolbar.get_node(tool_name)
	if not chosen.button_pressed:
		await click(chosen)


## A stroke from one point of the world to another, and further, with the left button.
func stroke(points: Array, modifiers := 0) -> void:
	await move(at(points[0]))
	await button(MOUSE_BUTTON_LEFT, true, at(points[0]), modifiers)
	for i in range(1, points.size()):
		await move(at(points[i]), MOUSE_BUTTON_MASK_LEFT, modifiers)
	await button(MOUSE_BUTTON_LEFT, false, at(points[-1]), modifiers)


func press_and_move() -> void:
	var from := at(Vector3(-1, 0, 0))
	await move(from)
	await button(MOUSE_BUTTON_LEFT, true, from)
	await move(at(Vector3(0, 0, 0)), MOUSE_BUTTON_MASK_LEFT)
	assert_true(plugin.get_statistics().active)


## Lets go over a part of the toolbar of something dragged from the file dock.
func drop(dragged: Dictionary, on: String) -> void:
	await drop_at(dragged, (toolbar.get_node(on) as Control).get_global_rect().get_center())


func drop_at(dragged: Dictionary, target: Vector2) -> void:
	var from: Control = EditorInterface.get_base_control().find_children("*", "FileSystemDock", true, false)[0]
	var middle := from.get_global_rect().get_center()
	await move(middle)
	await button(MOUSE_BUTTON_LEFT, true, middle)
	get_tree().root.warp_mouse(target)  # the engine tells controls the pointer's own place, not the event's
	from.force_drag(dragged, Control.new())
	for step in 4:
		await move(middle.lerp(target, 0.25 * (step + 1)), MOUSE_BUTTON_MASK_LEFT)
	await button(MOUSE_BUTTON_LEFT, false, target)
	await frames(2)
	get_tree().root.warp_mouse(get_tree().root.size / 2)


## Sets a number of the brush by its slider.
func set_number(slider: String, value: float) -> void:
	(toolbar.find_child(slider, true, false) as Range).value = value
	assert_near(number(slider), value, 1e-6, slider)


func set_limit(slider: String, value: float) -> void:
	(toolbar.get_node("Limits").find_child(slider, true, false) as Range).value = value


func number(slider: String) -> float:
	return (toolbar.find_child(slider, true, false) as Range).value


func channel(of: GrassMap.Channel) -> float:
	return field.map.sample(of, Vector2(0, 0), 3 if of == GrassMap.CHANNEL_TINT else 0) if field.map else -1.0


func camera_transform() -> Transform3D:
	return EditorInterface.get_editor_viewport_3d(0).get_camera_3d().global_transform


func density(x: float, z: float) -> float:
	return field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(x, z)) if field.map else -1.0


func undo() -> void:
	await key(KEY_Z, KEY_MASK_CTRL)


func redo() -> void:
	await key(KEY_Z, KEY_MASK_CTRL | KEY_MASK_SHIFT)


## Returns whether pictures are for pages, or only drawn so that the engine says what is wrong with them (tools/test/testing.py).
func is_for_pages() -> bool:
	return ProjectSettings.get_setting("rendering/scaling_3d/scale") == 1.0


## Returns the density of the grass in a picture for pages, else a tenth of it: software draws that in a fraction of the time.
func density_of_picture(dense: float) -> float:
	return dense if is_for_pages() else 0.1 * dense


## Ground to look at: a square about the origin, `side` metres long. `height`: metres, by x and z.
static func soil(side: int, height: Callable) -> MeshInstance3D:
	var surface := SurfaceTool.new()
	surface.begin(Mesh.PRIMITIVE_TRIANGLES)
	for z in side + 1:
		for x in side + 1:
			var place := Vector3(x - 0.5 * side, 0, z - 0.5 * side)
			place.y = height.call(place.x, place.z)
			surface.add_vertex(place)
	for z in side:
		for x in side:
			for corner: int in [0, 1, side + 1, 1, side + 2, side + 1]:
				surface.add_index(z * (side + 1) + x + corner)
	surface.generate_normals()
	var earth := StandardMaterial3D.new()
	earth.albedo_color = Color(0.3, 0.26, 0.17)
	var ground := MeshInstance3D.new()
	ground.mesh = surface.commit()
	ground.material_override = earth
	return ground


## Gives SCENE a sky and soil in a picture for pages. They are not saved.
func add_landscape() -> void:
	if is_for_pages():
		var root := EditorInterface.get_edited_scene_root()
		(root.get_node("Plain") as WorldEnvironment).environment = load("res://demo/day.tres")
		root.add_child(soil(SIDE, _foot))


## Returns the lowest ground near a place, metres: soil hides no grass beside a ledge.
func _foot(x: float, z: float) -> float:
	var lowest := INF
	for i in 9 if field.map else 0:
		var near := Vector2(x, z) + Vector2(i % 3 - 1, i / 3 - 1)
		lowest = minf(lowest, field.map.sample(GrassMap.CHANNEL_GROUND, near))
	return lowest if field.map else 0.0


## Writes a picture of the editor, beside the test's copy of the project.
func shoot(picture: String) -> void:
	var image: Image = await seen() if is_for_pages() else await next_picture()
	image.save_png(ProjectSettings.globalize_path("res://").path_join("../%s.png" % picture))


## Whether the view is drawn in all of its pixels, as tests of single ones want, or as coarsely as the project says (tools/test/testing.py).
func draw_finely(finely: bool) -> void:
	var scale: float = 1.0 if finely else ProjectSettings.get_setting("rendering/scaling_3d/scale")
	EditorInterface.get_editor_viewport_3d(0).scaling_3d_scale = scale


## Hides the view's grid: software Vulkan draws grey squares around it.
func seen() -> Image:
	_show_grid(false)
	draw_finely(true)
	await frames(3)
	var image := await next_picture()
	draw_finely(false)
	_show_grid(true)
	return image


func next_picture() -> Image:
	EditorInterface.get_base_control().queue_redraw()  # an idle editor draws no frame
	await RenderingServer.frame_post_draw
	return get_tree().root.get_texture().get_image()


func _show_grid(shown: bool) -> void:
	for menu: MenuButton in get_tree().root.find_children("*", "MenuButton", true, false):
		var popup := menu.get_popup()
		for i in popup.item_count:
			if popup.get_item_text(i) == "View Grid" and popup.is_item_checked(i) != shown:
				popup.id_pressed.emit(popup.get_item_id(i))


func _hold(event: InputEventWithModifiers, modifiers: int) -> void:
	event.shift_pressed = modifiers & KEY_MASK_SHIFT
	event.ctrl_pressed = modifiers & KEY_MASK_CTRL
	event.alt_pressed = modifiers & KEY_MASK_ALT


## Returns heights of the ground, a metre apart. Which spots beside a ledge are bare depends on the piece of ground that was read last.
func heights() -> PackedFloat32Array:
	var all := PackedFloat32Array()
	for x in range(-12, 13):
		for z in range(-12, 13):
			all.append(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(x, z)))
	return all

# SPDX-License-Identifier: MIT
## A test that draws: a small viewport with a world of its own, a camera, a light, and fields in it.
extends "res://tests/field_case.gd"

const SAVED := "user://pictures/"

var viewport: SubViewport
var camera: Camera3D
var picture_size: Vector2i  # of the pictures that are compared


func before() -> void:
	open_view(Vector2i(64, 36))


## A view whose pictures have `size`. Each of their pixels is the mean of `finer` x `finer` that are drawn: blades are thinned by
## the pixels that are drawn, and of those that stay a coarse picture shows too little.
func open_view(size: Vector2i, finer := 1) -> void:
	picture_size = size
	viewport = SubViewport.new()
	viewport.size = size * finer
	viewport.own_world_3d = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(viewport)
	camera = Camera3D.new()
	camera.far = 100.0
	camera.position = Vector3(0, 1, 3)
	viewport.add_child(camera)


## Writes a picture that people may look at.
func save(image: Image, name: String) -> void:
	DirAccess.make_dir_recursive_absolute(SAVED)
	image.save_png(SAVED + "%s_%s.png" % [name, RenderingServer.get_current_rendering_method()])


## Adds a GrassField in the viewport; see add_field().
func add_seen_field(properties := {}) -> GrassField:
	var field := add_field(properties.merged({cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF}))
	remove_child(field)
	viewport.add_child(field)
	return field


func add_light() -> void:
	var light := DirectionalLight3D.new()
	light.rotation_degrees = Vector3(-50, 30, 0)
	viewport.add_child(light)
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color(0.3, 0.4, 0.9)
	world.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	world.environment.ambient_light_color = Color.WHITE
	world.environment.ambient_light_energy = 0.5
	viewport.add_child(world)


func look(from: Vector3, at: Vector3) -> void:
	camera.look_at_from_position(from, at, Vector3.UP if absf((at - from).normalized().y) < 0.99 else Vector3.FORWARD)


## Waits while the view is not drawn, since nobody looks at these frames; fields see its camera all the same. It is drawn as soon as
## something shows it, which nothing does. Tests of motion vectors need each frame: what moves is compared with the one before.
func unseen(wait: Callable) -> void:
	var view := viewport
	var is_drawn := view and view.render_target_update_mode == SubViewport.UPDATE_ALWAYS
	if is_drawn and not get_script().get_script_constant_map().has("MOTION_VECTORS"):
		view.render_target_update_mode = SubViewport.UPDATE_WHEN_VISIBLE
	await wait.call()
	if is_drawn and is_instance_valid(view):
		view.render_target_update_mode = SubViewport.UPDATE_ALWAYS


func ticks(count: int) -> void:
	await unseen(func() -> void: await super.ticks(count))


func wait_until(condition: Callable, what: String, by_ticks := false) -> bool:
	var there := [false]
	await unseen(func() -> void: there[0] = await super.wait_until(condition, what, by_ticks))
	return there[0]


## Frames until all fields are shown as they are wanted: worker threads make shaders that no test before needed.
func fields_shown() -> void:
	var fields := viewport.find_children("*", "GrassField", true, false)
	var waits := func(field: GrassField) -> bool: return field.get_statistics().waiting
	await wait_for_threads(func() -> bool: return not fields.any(waits), "all fields are shown")


## Frames until what was drawn is known: the GPU's counts come about two frames late. Who only wants a picture needs not wait for it.
func drawn() -> void:
	await unseen(func() -> void: await frames_shown(4))
	await frames(1)


func frames_shown(more: int) -> void:
	await frames(1)
	await fields_shown()
	await frames(more)


## Frames until the next picture shows everything as it is now.
func ready_for_picture() -> void:
	await unseen(func() -> void: await frames_shown(2))


## Returns the viewport's picture as it is now.
func picture() -> Image:
	await ready_for_picture()
	return await next_picture()


## Returns the picture of this very frame.
func next_picture() -> Image:
	await RenderingServer.frame_post_draw
	var image := viewport.get_texture().get_image()
	while image.get_width() > picture_size.x:
		image.shrink_x2()
	return image


## Share of the pixels that `is_counted` (a function of a Color) is true for.
func share_of(image: Image, is_counted: Callable) -> float:
	var count := 0
	for y in image.get_height():
		for x in image.get_width():
			count += int(is_counted.call(image.get_pixel(x, y)))
	return float(count) / (image.get_width() * image.get_height())


## Returns the greatest and the mean difference of two pictures, of all channels, 0..1.
func difference(a: Image, b: Image) -> Vector2:
	var most := 0.0
	var sum := 0.0
	for y in a.get_height():
		for x in a.get_width():
			var one := a.get_pixel(x, y)
			var other := b.get_pixel(x, y)
			var off := (absf(one.r - other.r) + absf(one.g - other.g) + absf(one.b - other.b)) / 3.0
			most = maxf(most, off)
			sum += off
	return Vector2(most, sum / (a.get_width() * a.get_height()))


func is_green(color: Color) -> bool:
	return color.g > color.r and color.g > color.b


func is_red(color: Color) -> bool:
	return color.r > 1.3 * color.g and color.r > 1.3 * color.b


## A ball comes down to the tips of the field and goes: the tiles that it woke are drawn as they were asleep.
func assert_waking_is_not_seen(field: GrassField) -> void:
	look(Vector3(0, 1.2, 3.2), Vector3(0, 0.2, 0))
	await drawn()
	var asleep := await next_picture()
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	add_shape(body, ball(0.05))
	body.position = Vector3(0, 1.2, 0.5)
	viewport.add_child(body)
	for i in 120:
		body.position.y -= 0.01
		await ticks(1)
		if field.get_awake_tile_count() > 0:
			break
	body.position.y = 5.0
	await ticks(3)
	if assert_greater(field.get_awake_tile_count(), 0):
		assert_less(difference(asleep, await picture()).y, 5e-4)


## Of all pixels.
func mean(image: Image) -> Color:
	var sum := Color(0, 0, 0, 0)
	for y in image.get_height():
		for x in image.get_width():
			sum += image.get_pixel(x, y)
	return sum / (image.get_width() * image.get_height())

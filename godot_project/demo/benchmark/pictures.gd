# SPDX-License-Identifier: MIT
## Three small pictures of still grass, and how far they are from what they should be: a driver that draws nonsense is found by that.
extends RefCounted

const SIZE := Vector2i(160, 90)
const GRID := Vector2i(8, 6)  # cells, whose colours are compared
const CELL := SIZE / GRID  # pixels
const ALIKE := 0.02  # difference of the worst cell's colour, of 1; an NVIDIA card differs from software by 0.005, a missing dent by 0.04
const TICKS := 60  # until the grass lies still
const EVEN := "even"  # grass without a hole, a dent or flowers
const Expected := preload("res://demo/benchmark/expected.gd")
const DAISY := preload("res://addons/grass_field/presets/ox_eye_daisy.tres")

## By name.
var images: Dictionary[String, Image] = {}

var _viewport := SubViewport.new()


## {NAME: {cells, difference, alike}}. `images` has a picture of even grass, too, if `with_even`.
func take(stage: Node, with_even := false) -> Dictionary:
	_open(stage)
	var made := {}
	var expected := Expected.cells()
	if with_even:
		await _draw(stage, EVEN)
	for name: String in expected:
		await _draw(stage, name)
		var cells := colors(images[name])
		var off := difference(cells, expected[name].hex_decode())
		made[name] = {cells = cells.hex_encode(), difference = snappedf(off, 0.0001), alike = off < ALIKE}
	_viewport.queue_free()
	return made


func _draw(stage: Node, name: String) -> void:
	var field := _field(name)
	_viewport.add_child(field)
	await _shown(stage, field)
	images[name] = _viewport.get_texture().get_image()
	field.free()


## Returns the mean colour of each cell of a picture: red, green and blue, 0 to 255.
static func colors(image: Image) -> PackedByteArray:
	var cells := PackedByteArray()
	for y in GRID.y:
		for x in GRID.x:
			var mean := _mean(image, Rect2i(CELL * Vector2i(x, y), CELL))
			cells.append_array([mean.r8, mean.g8, mean.b8])
	return cells


static func _mean(image: Image, cell: Rect2i) -> Color:
	var sum := Color(0.0, 0.0, 0.0, 0.0)
	for y in range(cell.position.y, cell.end.y):
		for x in range(cell.position.x, cell.end.x):
			sum += image.get_pixel(x, y)
	return sum / cell.get_area()


## Of the cell that differs most, of 1. Pictures that cannot be compared differ by all.
static func difference(cells: PackedByteArray, others: PackedByteArray) -> float:
	if cells.size() != others.size() or cells.is_empty():
		return 1.0
	var most := 0.0
	for cell in range(0, cells.size(), 3):
		var sum := 0.0
		for channel in 3:
			sum += absf(cells[cell + channel] - others[cell + channel])
		most = maxf(most, sum / (3.0 * 255.0))
	return most


func _open(stage: Node) -> void:
	_viewport.size = SIZE
	_viewport.own_world_3d = true
	_viewport.msaa_3d = Viewport.MSAA_4X
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color(0.55, 0.65, 0.8)
	world.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	world.environment.ambient_light_color = Color.WHITE
	world.environment.ambient_light_energy = 0.6
	_viewport.add_child(world)
	var sun := DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-50.0, 40.0, 0.0)
	_viewport.add_child(sun)
	var ground := MeshInstance3D.new()
	ground.mesh = PlaneMesh.new()
	ground.mesh.size = Vector2(20.0, 20.0)
	ground.mesh.material = StandardMaterial3D.new()
	ground.mesh.material.albedo_color = Color(0.9, 0.85, 0.8)
	_viewport.add_child(ground)
	var camera := Camera3D.new()
	camera.position = Vector3(0.0, 1.7, 1.5)
	camera.rotation_degrees = Vector3(-52.0, 0.0, 0.0)
	_viewport.add_child(camera)
	stage.add_child(_viewport)
	camera.make_current()


func _field(name: String) -> GrassField:
	var field := GrassField.new()
	field.size = Vector2(6.0, 6.0)
	field.wind_speed = 0.0
	match name:
		"bare_disc":
			field.map = GrassMap.new()
			field.map.base_density = 1.0
			var brush := GrassBrush.new()
			brush.tool = GrassBrush.TOOL_ERASE
			brush.radius = 1.0
			brush.strength = 1.0
			for i in 5:
				field.map.stroke(brush, Vector2(0.4, 0.0), Vector2(0.4, 0.0))
		"pressed":
			var body := AnimatableBody3D.new()
			var shape := CollisionShape3D.new()
			shape.shape = SphereShape3D.new()
			shape.shape.radius = 1.1
			body.add_child(shape)
			body.position = Vector3(-0.3, 1.05, 0.0)
			field.add_child(body)
		"daisies":
			field.density = 40.0
			field.species = [DAISY] as Array[GrassSpecies]
	return field


func _shown(stage: Node, field: GrassField) -> void:
	var start := Time.get_ticks_msec()
	_viewport.render_target_update_mode = SubViewport.UPDATE_WHEN_VISIBLE  # fields see its camera; it is drawn once, for its picture
	for i in TICKS:
		await stage.get_tree().physics_frame
	while (field.get_statistics().waiting or field.get_statistics().compiling > 0) and Time.get_ticks_msec() - start < 60000:
		await stage.get_tree().process_frame
	for i in 2:
		await RenderingServer.frame_post_draw
	_viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
	await RenderingServer.frame_post_draw

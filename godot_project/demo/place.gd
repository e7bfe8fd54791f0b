# SPDX-License-Identifier: MIT
## A place with grass in which something happens. Started with `-- --out DIR` (`./grass demo NAME`) it takes the picture of each of its
## cameras, in their order, at the second that follows "at_" in the camera's name, then ends. Otherwise it runs until it is closed, seen
## through the first camera; the keys 1 to 9 change the camera. `--size small` makes less of the landscape around it: for software
## rendering.
extends Node3D

const Landscape := preload("res://demo/landscape.gd")
const Options := preload("res://demo/options.gd")
const Shots := preload("res://demo/shots.gd")
const Trail := preload("res://demo/trail.gd")
const PATH_BEYOND := 150.0  # metres that a path goes on in the landscape

## large or small; empty: the one in the arguments, by default large.
@export var size := ""

var time := 0.0  # seconds, in physics ticks
var landscape := Landscape.new()

var _is_waiting := false

@onready var field: GrassField = $Field
@onready var cameras: Array[Node] = $Cameras.get_children()


func _ready() -> void:
	field.measure_time = true
	var options := Options.read({"out": "", "size": "large"})
	if has_node(^"Water"):
		landscape.hills.water = $Water.position.y
	add_child(landscape)
	landscape.surround(field, get_node_or_null(^"Terrain"), (size if size else options.size) == "small")
	if has_node(^"Path"):
		for trail: Trail in Trail.beyond(($Path as Path3D).curve, PATH_BEYOND):
			landscape.country.wear(trail)
	Landscape.open_sky($World, $Sun)
	if options.out:
		await record(options.out)
		get_tree().quit()


func _physics_process(delta: float) -> void:
	if not _is_waiting:
		time += delta
		happen(delta)


## Moves the place on by a tick of `_delta` seconds.
func happen(_delta: float) -> void:
	pass


## One line about the state of the place.
func tell() -> String:
	return ""


func record(folder: String) -> void:
	var software: bool = RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU
	if software:  # one cascade instead of four: a frame takes seconds
		$Sun.directional_shadow_mode = DirectionalLight3D.SHADOW_ORTHOGONAL
	var shots := Shots.new(get_viewport(), folder)
	_wait(true)
	await shots.warm_up()
	_wait(false)
	for camera: Camera3D in cameras:
		while time < camera.name.get_slice("at_", 1).to_float():
			await get_tree().physics_frame
		camera.make_current()
		await shots.take(camera.name.to_snake_case())
		print(
			(
				"%s: %d blades, %d tiles simulated, %d triangles drawn. %s"
				% [camera.name, field.get_blade_count(), field.get_awake_tile_count(), field.get_statistics().drawn_triangles, tell()]
			)
		)


## Lets nothing happen, however long the driver compiles.
func _wait(is_waiting: bool) -> void:
	_is_waiting = is_waiting
	PhysicsServer3D.set_active(not is_waiting)


func _unhandled_key_input(event: InputEvent) -> void:
	var index: int = event.keycode - KEY_1
	if event.is_pressed() and index >= 0 and index < cameras.size():
		cameras[index].make_current()

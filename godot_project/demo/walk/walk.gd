# SPDX-License-Identifier: MIT
## A meadow among hills to walk in: a jeep, a ball, a mower, blasts, weather, day and night. Started with `-- --out DIR` it takes
## pictures of all that (`./grass demo walk` without a screen does so), then ends; otherwise you play it. docs/guide/walk.md describes how.
##   --parts FILE   measures the time to draw each of its parts, then ends
##   --size SIZE    large (256 m of close grass in 1 km of hills, the default) small (64 m in 320 m), for software
##                  rendering, or tiny (64 m of fewer blades in 128 m), for tests
extends Node3D

const Country := preload("res://demo/walk/country.gd")
const Options := preload("res://demo/options.gd")
const Actions := preload("res://demo/walk/actions.gd")
const Parts := preload("res://demo/walk/parts.gd")
const Tour := preload("res://demo/walk/tour.gd")
## Metres, side of the near field and of the hills; blades a square metre of the near field: few, so that few tiles are simulated, in tests
## without a GPU.
const SIZES := {"large": [256, 1024, Country.NEAR_DENSITY], "small": [64, 320, Country.NEAR_DENSITY], "tiny": [64, 128, 32.0]}
const START := Vector3(0.0, 0.0, 9.0)
const BALL := Vector3(0.2, 0.0, 4.5)
const JEEP := Vector3(5.5, 0.0, 3.0)
const MOWER := Vector3(-4.0, 0.0, 5.0)
const THROW := 8.0  # metres ahead at which a blast goes off

## One of SIZES; empty: the one in the arguments, by default large.
@export var size := ""

var driving := false
var pushing := false
var lamp_flipped := false

var _msaa: Viewport.MSAA  # of the project

@onready var hills: Node3D = $Hills
@onready var country: Node3D = $Country
@onready var walker: CharacterBody3D = $Walker
@onready var jeep: VehicleBody3D = $Jeep
@onready var ball: RigidBody3D = $Ball
@onready var mower: AnimatableBody3D = $Mower
@onready var blast: GrassForce3D = $Blast
@onready var weather: Node3D = $Weather
@onready var day: Node = $Day
@onready var eye: Camera3D = $Eye
@onready var panel: CanvasLayer = $Panel


func _ready() -> void:
	Actions.register()
	_msaa = get_viewport().msaa_3d
	get_viewport().msaa_3d = Viewport.MSAA_2X
	var options := Options.read({"out": "", "parts": "", "size": "large"})
	var sides: Array = SIZES[size if size else options.size]
	hills.make(sides[1])
	country.make(sides[0], hills, sides[2])
	$Trees.make(hills, 0.25 * sides[0], 0.45 * sides[1])
	day.set_up($Sun, $World)
	eye.set_up(hills)
	mower.add_collision_exception_with(walker)
	reset()
	if options.parts:
		await Parts.new(self).measure(options.parts)
		get_tree().quit()
	elif options.out:
		await Tour.new(self).record(options.out)
		get_tree().quit()
	elif DisplayServer.get_name() != "headless":
		Input.mouse_mode = Input.MOUSE_MODE_CAPTURED


func _exit_tree() -> void:
	Input.mouse_mode = Input.MOUSE_MODE_VISIBLE
	get_viewport().msaa_3d = _msaa
	GrassQuality.reset_level()


func _physics_process(delta: float) -> void:
	_do_actions()
	eye.look(delta)
	if driving:
		jeep.drive(delta)
		walker.global_position = jeep.get_door()  # beside it, so that it does not meet the jeep where it gets out
	else:
		walker.walk(delta, eye, country)
	jeep.tread(delta, country)
	if pushing:
		mower.push(walker.global_position, eye.yaw, hills, country)
	weather.advance(delta, country, hills, eye.global_position)
	day.advance(delta, weather.now.clouds)
	eye.lamp.visible = not driving and day.is_dark() != lamp_flipped
	for lamp: SpotLight3D in jeep.lamps:
		lamp.visible = driving and day.is_dark() != lamp_flipped
	eye.follow(walker.get_head(), delta)
	tell(delta)


## Updates the panel, in case its text is older than it may be. delta: seconds since the last call.
func tell(delta: float) -> void:
	panel.tell(delta, country.field, day.hour, weather.kind, _hint())


## Puts everything where it was at the beginning. Mown and trodden grass grows again.
func reset() -> void:
	if driving:
		_leave()
	_let_go()
	country.grow_back()
	walker.global_position = hills.on_ground(START, 0.05)
	walker.velocity = Vector3.ZERO
	_put(ball, BALL, 0.6)
	_put(jeep, JEEP, 0.3)
	mower.park(MOWER, hills)
	eye.yaw = 0.0
	eye.pitch = -0.08
	eye.follow(walker.get_head(), 0.0)


func _do_actions() -> void:
	if Input.is_action_just_pressed("walk_use"):
		_use()
	if Input.is_action_just_pressed("walk_blast"):
		var bodies: Array[RigidBody3D] = [ball, jeep]
		blast.blow(hills.on_ground(walker.global_position + THROW * _ahead(), 0.3), bodies)
	if Input.is_action_just_pressed("walk_weather"):
		weather.change()
	if Input.is_action_just_pressed("walk_quality"):
		GrassQuality.set_level((GrassQuality.get_level() + 1) % GrassQuality.LEVEL_CUSTOM as GrassQuality.Level)
	if Input.is_action_just_pressed("walk_lamp"):
		lamp_flipped = not lamp_flipped
	if Input.is_action_just_pressed("walk_view"):
		eye.behind = not eye.behind
	if Input.is_action_just_pressed("walk_help"):
		panel.visible = not panel.visible
	if Input.is_action_just_pressed("walk_reset"):
		reset()
	if Input.is_action_just_pressed("walk_benchmark"):
		get_tree().change_scene_to_file("res://demo/benchmark.tscn")
	if Input.is_action_just_pressed("walk_quit"):
		if Input.mouse_mode == Input.MOUSE_MODE_CAPTURED:
			Input.mouse_mode = Input.MOUSE_MODE_VISIBLE
		else:
			get_tree().quit()


## Gets out of the jeep, lets go of the mower, gets into the jeep or takes the mower, whichever is possible.
func _use() -> void:
	if driving:
		_leave()
	elif pushing:
		_let_go()
	elif walker.global_position.distance_to(mower.global_position) < mower.REACH:
		pushing = true
		walker.is_pushing = true
	elif walker.global_position.distance_to(jeep.global_position) < jeep.REACH:
		driving = true
		walker.set_away(true)
		eye.chase(jeep)


func _leave() -> void:
	driving = false
	jeep.stay()
	walker.global_position = hills.on_ground(jeep.get_door(), 0.05)
	walker.set_away(false)
	var way := jeep.global_basis.z
	eye.chase(null)
	eye.yaw = atan2(-way.x, -way.z)


func _let_go() -> void:
	pushing = false
	walker.is_pushing = false


func _put(body: RigidBody3D, place: Vector3, above: float) -> void:
	body.global_transform = Transform3D(Basis(Vector3.UP, PI), hills.on_ground(place, above))
	body.linear_velocity = Vector3.ZERO
	body.angular_velocity = Vector3.ZERO


func _ahead() -> Vector3:
	return -(eye.global_basis.z * Vector3(1, 0, 1)).normalized()


func _hint() -> String:
	if driving:
		return "%d km/h" % roundi(3.6 * jeep.linear_velocity.length())
	if pushing:
		return "%.1f m³ of hay" % mower.hay
	if walker.global_position.distance_to(mower.global_position) < mower.REACH:
		return "E, Y: take the mower"
	return "E, Y: get in" if walker.global_position.distance_to(jeep.global_position) < jeep.REACH else ""

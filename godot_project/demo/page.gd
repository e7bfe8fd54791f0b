# SPDX-License-Identifier: MIT
## A lawn with flowers in a country of thin grass, to play in a browser (`./grass page`): arrow keys roll the ball, the space bar mows below
## it, S turns the sun's shadows off and on. For tests `-- --tell yes` holds the wind and prints what stands and what moves, and
## `--picture FILE` takes the first picture, then ends.
extends Node3D

const Options := preload("res://demo/options.gd")
const PUSH := 14.0  # N
const CALM := 36  # frames before the scene begins; in 30 a field has seen twice how the sky lights it
const LINE := 0.25  # seconds from one line of a test to the next
const LAWN := 7.0  # metres from the middle in which the country has no grass of its own
const PATH_HALF := 0.7  # metres
const PATH := [Vector3(-6, 0, -1.5), Vector3(6, 0, -1.5)]
const BEHIND := Vector3(0, 1.3, 3.2)  # from the ball to the eye
const DECK := Vector3(1.2, 0.25, 1.2)  # metres

var _tells := false
var _is_playing := false
var _told := 0.0  # seconds since the last line
var _deck := BoxShape3D.new()

@onready var _lawn: GrassField = $Lawn
@onready var _country: GrassWorld = $Country
@onready var _ball: RigidBody3D = $Ball
@onready var _eye: Camera3D = $Eye


func _ready() -> void:
	var options := Options.read({"tell": "", "picture": ""})
	_tells = not str(options.tell).is_empty()
	_deck.size = DECK
	_ball.freeze = true
	_look()
	if _tells:
		get_viewport().msaa_3d = Viewport.MSAA_DISABLED  # in software a frame takes seconds
		GrassQuality.set_level(GrassQuality.LEVEL_LOW)  # in which a browser starts
		_lawn.wind_speed = 0.0
		_country.plot_loaded.connect(func(_plot: Vector2i, p_field: GrassField) -> void: p_field.wind_speed = 0.0)
	await _stand(4)
	_paint()
	await _stand(CALM)
	_ball.freeze = false
	_is_playing = true
	if _tells:
		_tell("stands")
	if options.picture:
		await RenderingServer.frame_post_draw
		get_viewport().get_texture().get_image().save_png(options.picture)
		get_tree().quit()


func _physics_process(delta: float) -> void:
	if not _is_playing:
		return
	var pushed := Vector3.ZERO
	for key: Key in [KEY_LEFT, KEY_RIGHT, KEY_UP, KEY_DOWN]:
		if Input.is_physical_key_pressed(key):
			pushed += {KEY_LEFT: Vector3.LEFT, KEY_RIGHT: Vector3.RIGHT, KEY_UP: Vector3.FORWARD, KEY_DOWN: Vector3.BACK}[key]
	_ball.apply_central_force(PUSH * pushed)
	_told += delta
	if _tells and _told > LINE:
		_told = 0.0
		_tell("moves")


func _process(_delta: float) -> void:
	_look()


func _unhandled_key_input(event: InputEvent) -> void:
	if not event.is_pressed() or event.is_echo():
		return
	match event.physical_keycode:
		KEY_SPACE:
			_lawn.cut(_deck, Transform3D(Basis(), Vector3(_ball.position.x, 0.5 * DECK.y + 0.06, _ball.position.z)))
		KEY_S:
			$Sun.shadow_enabled = not $Sun.shadow_enabled


func _look() -> void:
	_eye.position = _ball.position + BEHIND
	_eye.look_at(_ball.position + Vector3(0, 0.1, -0.6))


## Waits until everything is made, and has been so for some frames.
func _stand(frames: int) -> void:
	var calm := 0
	while calm < frames:
		await get_tree().process_frame
		var world := _country.get_statistics()
		var waits: bool = _lawn.get_statistics().waiting or world.waiting > 0 or world.plots == 0
		calm = 0 if waits else calm + 1


## A mown path through the lawn, and no thin grass where the lawn is.
func _paint() -> void:
	var brush := GrassBrush.new()
	brush.hardness = 1.0
	brush.strength = 1.0
	brush.tool = GrassBrush.TOOL_HEIGHT
	brush.target = 0.2
	brush.radius = PATH_HALF
	_lawn.paint(brush, PATH[0], PATH[1])
	brush.tool = GrassBrush.TOOL_DENSITY
	brush.target = 0.0
	brush.radius = LAWN
	_country.paint(brush, Vector3.ZERO, Vector3.ZERO)


func _tell(what: String) -> void:
	var facts := _lawn.get_statistics()
	var below := Vector3(_ball.position.x, 0.0, _ball.position.z)
	var seen := {
		does = what,
		version = facts.version,
		backend = facts.backend,
		blades = _lawn.get_blade_count(),
		drawn_tiles = facts.drawn_tiles,
		plots = _country.get_statistics().plots,
		beside_path = _lawn.get_height_at(Vector3(0, 0, 1.5)),
		on_path = _lawn.get_height_at(Vector3(0, 0, PATH[0].z)),
		in_country = _country.get_field_at(Vector3(12, 0, 0)).get_height_at(Vector3(12, 0, 0)),
		bend = _lawn.get_bend_at(below).length(),
		ball = snappedf(_ball.position.x, 0.01),
		mown = _lawn.get_mown_share(),
	}
	print("GrassField page: ", JSON.stringify(seen))

# SPDX-License-Identifier: MIT
## What the benchmark measures, in order.
extends RefCounted

## side: of the field, metres. density: blades a square metre. bodies: thrown into it; -1: a walker instead. seconds: for how long frames
## are measured.
const PARTS: Array[Dictionary] = [
	{name = "meadow_16", words = "meadow, 16 blades a square metre", side = 256.0, density = 16.0, bodies = 0, seconds = 18.0},
	{name = "meadow_64", words = "meadow, 64 blades a square metre", side = 256.0, density = 64.0, bodies = 0, seconds = 18.0},
	{name = "meadow_256", words = "meadow, 256 blades a square metre", side = 256.0, density = 256.0, bodies = 0, seconds = 18.0},
	{name = "walk", words = "a walker", side = 64.0, density = 256.0, bodies = -1, seconds = 25.0},
	{name = "bodies_10", words = "10 thrown bodies", side = 64.0, density = 256.0, bodies = 10, seconds = 25.0},
	{name = "bodies_128", words = "128 thrown bodies", side = 64.0, density = 256.0, bodies = 128, seconds = 40.0},
]
const AGAIN := 8.0  # seconds until bodies are thrown again
const EYE := 1.7  # metres
const PACE := 1.4  # of the walker, m/s
const ROUND := 3.0  # radius of the walker's way, metres

const Bodies := preload("res://demo/bodies.gd")

var field: GrassField

var _part: Dictionary
var _stage: Node3D
var _things: Array[Node3D] = []
var _time := 0.0  # seconds since the throw


## Puts a part into `stage`, and its camera where the part is seen from. `share`: of the sides and times, for software and tests.
func begin(stage: Node3D, camera: Camera3D, part: Dictionary, share: float) -> void:
	_stage = stage
	_part = part
	var side: float = maxf(part.side * share, 8.0)
	field = GrassField.new()
	field.size = Vector2(side, side)
	field.density = part.density
	field.wind_speed = 3.0
	field.measure_time = true
	stage.add_child(field)
	camera.position = Vector3(0.0, EYE, 0.45 * side)
	camera.rotation = Vector3(-0.12, 0.0, 0.0)
	if part.bodies != 0:
		var ground := StaticBody3D.new()
		ground.add_child(_shape(WorldBoundaryShape3D.new()))
		_add(ground)
	if part.bodies < 0:
		var walker := AnimatableBody3D.new()
		var capsule := CapsuleShape3D.new()
		capsule.radius = 0.3
		capsule.height = 1.7
		walker.add_child(_shape(capsule))
		_add(walker)
		advance(0.0)
	elif part.bodies > 0:
		_throw()


## Call it in each physics tick.
func advance(delta: float) -> void:
	_time += delta
	if _part.bodies < 0:
		var angle := _time * PACE / ROUND
		_things[-1].position = Vector3(ROUND * cos(angle), 0.86, 0.45 * field.size.y - 5.0 + ROUND * sin(angle))
	elif _part.bodies > 0 and _time >= AGAIN:
		_throw()


func end() -> void:
	for thing: Node3D in _things + ([field] as Array[Node3D]):
		thing.queue_free()
	_things.clear()
	_time = 0.0


func _throw() -> void:
	while _things.size() > 1:  # the ground stays
		_things.pop_back().queue_free()
	var source := Bodies.new(7)
	for i: int in _part.bodies:
		var body := source.make()
		source.throw(body, field.size.x)
		_add(body)
	_time = 0.0


func _add(thing: Node3D) -> void:
	_stage.add_child(thing)
	_things.append(thing)


static func _shape(shape: Shape3D) -> CollisionShape3D:
	var node := CollisionShape3D.new()
	node.shape = shape
	return node

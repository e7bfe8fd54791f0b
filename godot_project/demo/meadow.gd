# SPDX-License-Identifier: MIT
## A painted meadow on hills, with a path. Bodies roll down the slope; somebody leaves the path and treads one of their own.
extends "res://demo/place.gd"

const Bodies := preload("res://demo/bodies.gd")
const Figure := preload("res://demo/walk/figure.gd")
const ROLL_AGAIN := 10.0  # seconds
const PACE := 1.4  # m/s
const STEP := 0.7  # metres from one footprint to the next

var _bodies: Array[RigidBody3D] = []
var _rolled := -ROLL_AGAIN  # seconds: when bodies were let go last
var _walked := 0.0  # metres
var _trodden := 0.0  # metres, those with footprints
var _figure := Figure.new()

@onready var _terrain: StaticBody3D = $Terrain
@onready var _walker: AnimatableBody3D = $Walker
@onready var _stroll: Curve3D = ($Stroll as Path3D).curve


func _ready() -> void:
	_walker.add_child(_figure)
	super()


func happen(delta: float) -> void:
	if time - _rolled > ROLL_AGAIN:
		_roll()
	_walked = fmod(_walked + PACE * delta, _stroll.get_baked_length())
	var place := _on_ground(_stroll.sample_baked(_walked))
	var way := place - _walker.position
	_walker.position = place
	_figure.rotation.y = atan2(-way.x, -way.z)
	_figure.step(PACE * delta, PACE)
	if absf(_walked - _trodden) > STEP:
		_trodden = _walked
		field.trample(_walker.global_position, 0.4, 0.08)


func tell() -> String:
	return "Under the walker, the grass leans by %s of its height." % field.get_bend_at(_walker.global_position + Vector3(0.3, 0, 0))


func _roll() -> void:
	_rolled = time
	for body in _bodies:
		body.queue_free()
	_bodies.clear()
	var source := Bodies.new(11)
	for i in 14:
		var body := source.make()
		body.position = _on_ground(Vector3(-7.0 + 1.1 * i, 0.0, -17.0 + 0.9 * (i % 3))) + Vector3.UP
		body.linear_velocity = Vector3(0.0, 0.0, 5.0 + i % 4)
		add_child(body)
		_bodies.append(body)


func _on_ground(place: Vector3) -> Vector3:
	return Vector3(place.x, _terrain.height_at(place.x, place.z), place.z)

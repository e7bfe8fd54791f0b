# SPDX-License-Identifier: MIT
## A lawn in a rough meadow. Half of it is mown in stripes; a mower goes on with the rest, lane by lane, and a ball rolls over it.
extends "res://demo/place.gd"

const Ball := preload("res://demo/walk/ball.gd")
const Look := preload("res://demo/walk/look.gd")
const MowerLook := preload("res://demo/walk/mower_look.gd")
const MOWER := Vector3(1.9, 0.18, 1.1)  # metres, of its deck
const MOWER_HEIGHT := 0.06  # metres
const LANES := 7
const LANE := 2.0  # metres, width of the deck; the map stores combing on a grid of a metre
const HALF := 10.0  # metres, half of a lane's length
const MOWN := 3  # lanes, before the scene begins
const SPEED := 2.5  # m/s
const COMB := 0.25  # metres from one touch of the roller to the next

var _lane := MOWN
var _along := 0.0  # metres mown of the lane
var _rolled := 0.0  # metres of the lane behind the roller
var _hay := 0.0  # m³
var _roller := GrassBrush.new()

@onready var _mower: AnimatableBody3D = $Mower
@onready var _deck: CollisionShape3D = $Mower/Deck


func _ready() -> void:
	field.map = field.map.duplicate()  # the scene's own map does not change
	_roller.tool = GrassBrush.TOOL_COMB
	_roller.radius = 0.5 * LANE
	_roller.hardness = 0.8
	_roller.strength = 0.6
	Look.add_mesh(_mower, MowerLook.mesh(MOWER, MOWER_HEIGHT), Vector3.ZERO).rotation.y = -0.5 * PI  # it goes along x
	Look.add_mesh($Ball, Ball.mesh(), Vector3.ZERO)
	_place()
	landscape.trees.others.append($Tree.position)
	super()


## Returns the middle of the lawn's `lane`, `along` metres from where the mower begins; every other lane goes back.
static func place_of(lane: int, along: float) -> Vector3:
	var direction := 1.0 if lane % 2 == 0 else -1.0
	return Vector3(direction * (along - HALF), 0.0, (lane - 0.5 * (LANES - 1)) * LANE)


func happen(delta: float) -> void:
	if _lane == LANES:
		return
	_along += SPEED * delta
	_place()
	_hay += field.cut(_deck.shape, _deck.global_transform).volume
	if _along - _rolled > COMB:
		field.paint(_roller, place_of(_lane, _rolled), place_of(_lane, _along))
		_rolled = _along
	if _along > 2.0 * HALF:
		_lane += 1
		_along = 0.0
		_rolled = 0.0


func tell() -> String:
	return "%.2f m³ of hay; %d %% of the field is mown." % [_hay, roundi(100.0 * field.get_mown_share())]


func _place() -> void:
	_mower.position = place_of(mini(_lane, LANES - 1), _along)
	_mower.rotation.y = 0.0 if _lane % 2 == 0 else PI

# SPDX-License-Identifier: MIT
## A mower that somebody pushes: grass under its deck is cut, and stays cut.
extends AnimatableBody3D

const Look := preload("res://demo/walk/look.gd")
const MowerLook := preload("res://demo/walk/mower_look.gd")
const Hills := preload("res://demo/walk/hills.gd")
const Country := preload("res://demo/walk/country.gd")
const DECK := Vector3(1.0, 0.16, 0.8)  # metres
const HEIGHT := 0.08  # metres, height to which it cuts
const AHEAD := 1.25  # metres from the person who pushes it
const REACH := 2.2  # metres within which one can take it

var hay := 0.0  ## m³ cut so far

var _deck: CollisionShape3D


func _ready() -> void:
	sync_to_physics = false
	_deck = Look.add_shape(self, Look.box(DECK), Vector3(0.0, HEIGHT + 0.5 * DECK.y, 0.0))
	Look.add_mesh(self, MowerLook.mesh(DECK, HEIGHT), Vector3.ZERO)


## Moves it for a tick, in front of somebody at `place` who looks along `yaw`.
func push(place: Vector3, yaw: float, hills: Hills, country: Country) -> void:
	var way := Basis(Vector3.UP, yaw)
	var at := hills.on_ground(place + way * (AHEAD * Vector3.FORWARD))
	var up := hills.normal_at(at)
	var right := (way * Vector3.RIGHT).slide(up).normalized()
	global_transform = Transform3D(Basis(right, up, right.cross(up)), at)
	var field := country.field_at(at)
	if field:
		hay += float(field.cut(_deck.shape, _deck.global_transform).volume)


## Puts it on the ground at `place`.
func park(place: Vector3, hills: Hills) -> void:
	var up := hills.normal_at(place)
	var right := Vector3.RIGHT.slide(up).normalized()
	global_transform = Transform3D(Basis(right, up, right.cross(up)), hills.on_ground(place))

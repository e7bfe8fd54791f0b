# SPDX-License-Identifier: MIT
## The camera: in the walker's head, behind the walker, or behind the jeep. Mouse and right stick turn it.
extends Camera3D

const MOUSE := 0.0025  # radians a pixel
const STICK := 2.6  # radians a second
const STEEPEST := 1.35  # radians
const BEHIND := Vector3(0.7, 0.6, 3.2)  # metres from the head, third person
const CHASE := Vector3(0.0, 2.3, 6.5)  # metres from the jeep
const LAZINESS := 3.5  # how fast the chase follows, a second
const LEAST := 0.4  # metres above the ground

const Hills := preload("res://demo/walk/hills.gd")
const Look := preload("res://demo/walk/look.gd")

var yaw := 0.0  ## radians; 0 looks to -z
var pitch := -0.08
var behind := false  ## third person
var chased: Node3D = null  ## the jeep, while somebody drives it
var lamp: SpotLight3D

var _chase_yaw := 0.0
var _hills: Hills


func _init() -> void:
	fov = 70.0
	near = 0.08
	far = 3000.0


func set_up(hills: Hills) -> void:
	_hills = hills
	lamp = Look.add_lamp(self, Vector3(0.15, 0.1, 0.0), 14.0, 28.0)
	lamp.shadow_enabled = true


func _unhandled_input(event: InputEvent) -> void:
	if event is InputEventMouseMotion and Input.mouse_mode == Input.MOUSE_MODE_CAPTURED:
		_turn(-MOUSE * (event as InputEventMouseMotion).screen_relative)


func look(delta: float) -> void:
	_turn(-STICK * delta * Input.get_vector("walk_look_left", "walk_look_right", "walk_look_up", "walk_look_down"))


## The camera's place for a walker's head at `head`.
func follow(head: Vector3, delta: float) -> void:
	if chased:
		var way := chased.global_basis.z
		_chase_yaw = lerp_angle(_chase_yaw, atan2(-way.x, -way.z), 1.0 - exp(-LAZINESS * delta))
		_place(chased.global_position, CHASE, Basis(Vector3.UP, _chase_yaw + yaw) * Basis(Vector3.RIGHT, pitch - 0.12))
	else:
		_place(head, BEHIND if behind else Vector3.ZERO, Basis(Vector3.UP, yaw) * Basis(Vector3.RIGHT, pitch))


func chase(what: Node3D) -> void:
	chased = what
	if what:
		var way := what.global_basis.z
		_chase_yaw = atan2(-way.x, -way.z)
		yaw = 0.0


func _turn(by: Vector2) -> void:
	yaw = wrapf(yaw + by.x, -PI, PI)
	pitch = clampf(pitch + by.y, -STEEPEST, STEEPEST)


func _place(at: Vector3, offset: Vector3, turned: Basis) -> void:
	var place := at + turned * offset
	place.y = maxf(place.y, _hills.height_at(place) + LEAST)
	global_transform = Transform3D(turned, place)

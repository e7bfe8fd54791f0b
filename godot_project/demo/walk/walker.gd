# SPDX-License-Identifier: MIT
## The player on foot: a character that presses the grass, treads a path, and kicks things that it runs into.
extends CharacterBody3D

const PACE := 3.0  # m/s
const SPRINT := 7.0
const PUSHING := 1.6  # behind a mower
const HASTE := 12.0  # m/s², how fast it gets there
const JUMP := 5.0  # m/s
const HEIGHT := 1.75  # metres
const HEAD := 1.62
const STEP := 0.75  # metres from one footprint to the next
const TREAD := 0.03  # wear of a step
const KICK := 1.7  # speed of a kicked body, as a multiple of the walker's own
const HEAVIEST := 3.0  # kg; heavier bodies get less speed

const Eye := preload("res://demo/walk/eye.gd")
const Country := preload("res://demo/walk/country.gd")
const Look := preload("res://demo/walk/look.gd")
const Figure := preload("res://demo/walk/figure.gd")

var is_pushing := false
var kicks := 0

var _shape: CollisionShape3D
var _look := Figure.new()
var _since_step := 0.0  # metres
var _gravity: float = ProjectSettings.get_setting("physics/3d/default_gravity")


func _ready() -> void:
	var capsule := CapsuleShape3D.new()
	capsule.radius = 0.28
	capsule.height = HEIGHT
	_shape = Look.add_shape(self, capsule, Vector3(0.0, 0.5 * HEIGHT, 0.0))
	add_child(_look)
	floor_snap_length = 0.3


## Hides it, as long as it sits in a jeep.
func set_away(is_away: bool) -> void:
	_shape.disabled = is_away
	visible = not is_away
	velocity = Vector3.ZERO


func get_head() -> Vector3:
	return global_position + Vector3(0.0, HEAD, 0.0)


## Walks for a tick as the player wishes, seen by `eye`, over the grass of `country`.
func walk(delta: float, eye: Eye, country: Country) -> void:
	var wish := Input.get_vector("walk_left", "walk_right", "walk_forward", "walk_back")
	var pace := PUSHING if is_pushing else SPRINT if Input.is_action_pressed("walk_sprint") else PACE
	if is_on_floor() and Input.is_action_pressed("walk_jump") and not is_pushing:
		velocity.y = JUMP
	_look.visible = eye.behind
	go(delta, Basis(Vector3.UP, eye.yaw) * Vector3(wish.x, 0.0, wish.y) * pace, eye.yaw, country)


## Walks for a tick at a velocity, with its face along `yaw`.
func go(delta: float, towards: Vector3, yaw: float, country: Country) -> void:
	velocity.x = move_toward(velocity.x, towards.x, HASTE * delta)
	velocity.z = move_toward(velocity.z, towards.z, HASTE * delta)
	if not is_on_floor():
		velocity.y -= _gravity * delta
	var wanted := velocity
	var from := global_position
	move_and_slide()
	_kick(wanted)
	rotation.y = yaw
	_look.holds = is_pushing
	var by := global_position.distance_to(from)
	_look.step(by, by / delta)
	_tread(by, country)


## Kicks the bodies that it ran into: they fly ahead, and a little up.
func _kick(wanted: Vector3) -> void:
	for i in get_slide_collision_count():
		var hit := get_slide_collision(i)
		var body := hit.get_collider() as RigidBody3D
		if body == null or hit.get_normal().y > 0.7:
			continue  # it does not move, or the walker stands on it
		var way := -hit.get_normal()
		var short := KICK * maxf(wanted.dot(way), 0.0) - body.linear_velocity.dot(way)
		if short > 0.0:
			body.apply_central_impulse(minf(body.mass, HEAVIEST) * short * (way + 0.25 * Vector3.UP))
			kicks += 1


func _tread(by: float, country: Country) -> void:
	_since_step += by
	if _since_step > STEP and is_on_floor():
		_since_step = 0.0
		var field := country.field_at(global_position)
		if field:
			field.trample(global_position, 0.36, TREAD)

# SPDX-License-Identifier: MIT
## An explosion: a force that flattens the grass, and throws rigid bodies; earth flies, and there is a flash.
extends GrassForce3D

const PUSH := 14.0  # m/s, speed of a light body near it
const HEAVY := 60.0  # kg, mass from which on a body gets less speed
const FLASH := 0.25  # seconds

const Look := preload("res://demo/walk/look.gd")
const Mould := preload("res://demo/walk/mould.gd")
const EARTH := Color(0.29, 0.23, 0.16)
const CLOD := 0.035  # metres, radius of a clod

var blasts := 0

var _earth := CPUParticles3D.new()
var _flash := OmniLight3D.new()


func _ready() -> void:
	speed = 50.0
	radius = 7.0
	duration = 0.7
	_flash.light_color = Color(1.0, 0.75, 0.4)
	_flash.omni_range = 14.0
	_flash.position.y = 0.8
	_flash.visible = false
	add_child(_flash)
	_earth.mesh = _clod()
	_earth.material_override = Look.painted()
	_earth.emitting = false
	_earth.one_shot = true
	_earth.explosiveness = 0.97
	_earth.amount = 420
	_earth.lifetime = 1.6
	_earth.direction = Vector3.UP
	_earth.spread = 55.0
	_earth.initial_velocity_min = 4.0
	_earth.initial_velocity_max = 11.0
	_earth.scale_amount_min = 0.25
	_earth.scale_amount_max = 1.5
	_earth.angular_velocity_max = 700.0
	_earth.angle_max = 360.0
	_earth.particle_flag_rotate_y = true
	add_child(_earth)


func blow(place: Vector3, bodies: Array[RigidBody3D]) -> void:
	global_position = place
	fire()
	blasts += 1
	for body in bodies:
		var way := body.global_position - place
		var share := 1.0 - way.length() / radius
		if share > 0.0:
			body.apply_central_impulse(minf(body.mass, HEAVY) * PUSH * share * (way.normalized() + 0.6 * Vector3.UP))
	_earth.restart()
	_flash.visible = true
	_flash.light_energy = 8.0
	create_tween().tween_property(_flash, "light_energy", 0.0, FLASH).finished.connect(_flash.hide)


static func _clod() -> ArrayMesh:
	var random := RandomNumberGenerator.new()
	random.seed = 2
	var points := PackedVector3Array()
	for i in 9:
		points.append(Vector3(random.randfn(), 0.7 * random.randfn(), random.randfn()).normalized() * CLOD * random.randf_range(0.6, 1.2))
	var mould := Mould.new()
	mould.paint(EARTH, 1.0)
	mould.hull(points)
	return mould.commit()

# SPDX-License-Identifier: MIT
## An explosion: a force that flattens the grass, and throws rigid bodies; earth flies, and there is a flash.
extends GrassForce3D

const PUSH := 14.0  # m/s, speed of a light body near it
const HEAVY := 60.0  # kg, mass from which on a body gets less speed
const FLASH := 0.25  # seconds

const Look := preload("res://demo/walk/look.gd")

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
	var clod := BoxMesh.new()
	clod.size = Vector3(0.06, 0.045, 0.05)
	_earth.mesh = clod
	_earth.material_override = Look.paint(Color(0.2, 0.15, 0.09), 1.0)
	_earth.emitting = false
	_earth.one_shot = true
	_earth.explosiveness = 0.97
	_earth.amount = 160
	_earth.lifetime = 1.6
	_earth.direction = Vector3.UP
	_earth.spread = 55.0
	_earth.initial_velocity_min = 4.0
	_earth.initial_velocity_max = 11.0
	_earth.scale_amount_min = 0.4
	_earth.scale_amount_max = 1.5
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

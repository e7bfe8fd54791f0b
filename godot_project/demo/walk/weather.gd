# SPDX-License-Identifier: MIT
## The weather: each kind is a row of numbers, and the present numbers change towards them at a fixed rate, so nothing jumps. Wind, wetness
## and snow are the fields' own properties.
extends Node3D

const Country := preload("res://demo/walk/country.gd")
const Hills := preload("res://demo/walk/hills.gd")
const Look := preload("res://demo/walk/look.gd")
const Trees := preload("res://demo/walk/trees.gd")
## wind: m/s; gusts, wet, snow, clouds, rain and flakes in the air: 0 to 1.
const KINDS := {
	clear = {wind = 2.0, gusts = 0.4, wet = 0.0, snow = 0.0, clouds = 0.0, rain = 0.0, flakes = 0.0},
	windy = {wind = 9.0, gusts = 1.0, wet = 0.0, snow = 0.0, clouds = 0.35, rain = 0.0, flakes = 0.0},
	rain = {wind = 5.0, gusts = 0.8, wet = 1.0, snow = 0.0, clouds = 1.0, rain = 1.0, flakes = 0.0},
	snow = {wind = 1.5, gusts = 0.4, wet = 0.0, snow = 0.8, clouds = 0.9, rain = 0.0, flakes = 1.0},
}
## How fast each of them changes, a second.
const RATES := {wind = 1.5, gusts = 0.2, wet = 0.12, snow = 0.06, clouds = 0.2, rain = 0.25, flakes = 0.25}
const AIR := Vector3(8.0, 7.0, 8.0)  # metres around the eye in which drops and flakes are drawn, half

var kind := "clear"
var now: Dictionary = KINDS.clear.duplicate()  ## the present weather

var _rain: GPUParticles3D
var _flakes: GPUParticles3D


func _ready() -> void:
	var drop := BoxMesh.new()
	drop.size = Vector3(0.0035, 0.5, 0.0035)
	_rain = _add_air(drop, 4400, 1.1, 11.0, Color(0.85, 0.9, 0.95, 0.28))
	var flake := SphereMesh.new()
	flake.radius = 0.009
	flake.height = 0.018
	flake.radial_segments = 6
	flake.rings = 3
	_flakes = _add_air(flake, 5200, 8.0, 1.4, Color(1, 1, 1, 0.9))


func change() -> void:
	var names := KINDS.keys()
	kind = names[(names.find(kind) + 1) % names.size()]


## Changes the weather at once.
func settle() -> void:
	now = KINDS[kind].duplicate()


func advance(delta: float, country: Country, hills: Hills, eye: Vector3) -> void:
	for what: String in now:
		now[what] = move_toward(now[what], KINDS[kind][what], RATES[what] * delta)
	for field in country.fields:
		field.wind_speed = now.wind
		field.gust_strength = now.gusts
		field.wetness = now.wet
		field.snow = now.snow
	hills.cover(now.snow, now.wet)
	Look.cover(now.snow, now.wet)
	Trees.cover(now.snow, now.wet)
	global_position = eye
	_show(_rain, now.rain)
	_show(_flakes, now.flakes)


func _show(air: GPUParticles3D, share: float) -> void:
	air.visible = share > 0.01
	air.emitting = air.visible
	air.amount_ratio = maxf(share, 0.01)


func _add_air(mesh: Mesh, amount: int, lifetime: float, speed: float, color: Color) -> GPUParticles3D:
	var way := ParticleProcessMaterial.new()
	way.emission_shape = ParticleProcessMaterial.EMISSION_SHAPE_BOX
	way.emission_box_extents = Vector3(AIR.x, 0.5 * AIR.y, AIR.z)
	way.direction = Vector3(0.16, -1.0, 0.05)
	way.particle_flag_align_y = speed > 5.0  # drops are drawn out along their way
	way.spread = 2.0 if speed > 5.0 else 25.0
	way.gravity = Vector3.ZERO
	way.initial_velocity_min = 0.8 * speed
	way.initial_velocity_max = 1.2 * speed
	var air := GPUParticles3D.new()
	air.process_material = way
	air.draw_pass_1 = mesh
	air.amount = amount
	air.lifetime = lifetime
	air.preprocess = 0.5 * lifetime
	air.position.y = AIR.y
	air.visibility_aabb = AABB(-2.0 * AIR, 4.0 * AIR)
	air.material_override = Look.paint(color)
	air.material_override.shading_mode = BaseMaterial3D.SHADING_MODE_PER_VERTEX
	air.material_override.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	air.material_override.distance_fade_mode = BaseMaterial3D.DISTANCE_FADE_PIXEL_ALPHA  # none before the lens
	air.material_override.distance_fade_min_distance = 0.4
	air.material_override.distance_fade_max_distance = 1.5
	air.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	air.visible = false
	add_child(air)
	return air

# SPDX-License-Identifier: MIT
## Day and night: one lamp is the sun by day and the moon by night, and sky, ambient light and fog follow it. Its light is 0 at the moment
## when it changes from one to the other, so no shadow jumps.
extends Node

const Clouds := preload("res://demo/walk/clouds.gd")
const Stars := preload("res://demo/walk/stars.gd")
const Sun := preload("res://demo/sun.gd")
const Look := preload("res://demo/walk/look.gd")
const PACE := 24.0 / 900.0  # hours a second: a day in a quarter of an hour
const HURRY := 1.5  # hours a second while the key is held
const NOON_HEIGHT := 1.0  # radians
const WHITE_SUN := Color(1.0, 0.95, 0.85)
const LOW_SUN := Color(1.0, 0.62, 0.35)
const MOON := Color(0.6, 0.72, 1.0)
const SKY_STEPS := 48.0  # the sky is drawn again, which costs time, when its light has changed by one of these steps
## Zenith, horizon, ambient light; by day, at dusk, by night, under clouds.
const DAY: Array[Color] = [Color(0.2, 0.4, 0.7), Color(0.66, 0.76, 0.85), Color(0.5, 0.58, 0.68)]
const DUSK: Array[Color] = [Color(0.18, 0.22, 0.42), Color(0.85, 0.5, 0.3), Color(0.36, 0.32, 0.38)]
const NIGHT: Array[Color] = [Color(0.035, 0.05, 0.11), Color(0.1, 0.13, 0.22), Color(0.13, 0.16, 0.27)]
const STARLIGHT := 0.12  # light of the day below which stars shine in place of clouds
## What a low sun adds by day to zenith, horizon and ambient light, and what its light makes of thin clouds.
const LOW: Array[Color] = [Color(0.25, 0.41, 0.63), Color(0.94, 0.8, 0.6), Color(0.64, 0.61, 0.62)]
const LOW_CLOUDS := Color(1.0, 0.84, 0.66)
const LOW_GLOW := 0.08  # Sun.GLOW_CURVE of a low sun
const LOW_HAZE := 0.35  # share of the fog before the sun that has its colour
const LOW_BELOW := Vector2(0.06, 0.5)  # height of the sun, 1 at noon: low, and no longer
const CLOUDS: Array[Color] = [Color(0.5, 0.54, 0.58), Color(0.68, 0.71, 0.74), Color(0.5, 0.53, 0.57)]

var hour := 9.0
var light := 1.0  ## 0 by night, 1 by day

var _sun: DirectionalLight3D
var _environment: Environment
var _sky: ProceduralSkyMaterial
var _drawn := Vector3.INF  # light, clouds and warmth for which the sky was drawn last
var _warm := 0.0  # 1 by day while the sun is low


func set_up(sun: DirectionalLight3D, world: WorldEnvironment) -> void:
	_sun = sun
	_environment = world.environment.duplicate(true)  # the environment in the file does not change
	world.environment = _environment
	_sky = _environment.sky.sky_material
	_sky.sky_cover = Clouds.cover()
	Sun.complete(sun, _sky)
	_environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	_environment.reflected_light_source = Environment.REFLECTION_SOURCE_DISABLED
	_environment.sky.radiance_size = Sky.RADIANCE_SIZE_32  # nothing takes light from it


func is_dark() -> bool:
	return light < 0.3


func advance(delta: float, clouds: float) -> void:
	hour = fposmod(hour + delta * (HURRY if Input.is_action_pressed("walk_hurry") else PACE), 24.0)
	var height := sin((hour - 6.0) / 12.0 * PI)  # of the sun: 1 at noon, -1 at midnight
	light = smoothstep(-0.15, 0.25, height)
	var way := fposmod(hour - 6.0, 12.0) / 12.0 * PI  # the moon goes the sun's way, twelve hours later
	_sun.basis = Basis(Vector3.UP, way - 0.35) * Basis(Vector3.RIGHT, -maxf(sin(way), 0.06) * NOON_HEIGHT)
	var is_day := height > 0.0
	_sun.light_color = LOW_SUN.lerp(WHITE_SUN, smoothstep(0.05, 0.5, height)) if is_day else MOON
	var strength := 1.5 * smoothstep(0.0, 0.18, height) if is_day else 0.4 * smoothstep(0.0, 0.2, -height)
	_sun.light_energy = strength * (1.0 - 0.85 * clouds)
	_sun.visible = _sun.light_energy > 0.001
	Sun.follow(_sun)
	_warm = 1.0 - smoothstep(LOW_BELOW.x, LOW_BELOW.y, height) if is_day else 0.0
	_set_air(clouds)


func _set_air(clouds: float) -> void:
	var ambient := _mix(2, clouds)
	_environment.ambient_light_color = ambient
	_environment.ambient_light_energy = 1.0
	_environment.fog_light_color = _mix(1, clouds)
	Look.reflect(_mix(1, clouds))
	_environment.fog_sun_scatter = LOW_HAZE * _warm * (1.0 - clouds)
	_environment.fog_density = lerpf(0.0006, 0.004, clouds)
	var state := (SKY_STEPS * Vector3(light, clouds, _warm)).round()
	if state != _drawn:
		_drawn = state
		_sky.sun_curve = lerpf(Sun.GLOW_CURVE, LOW_GLOW, _warm)
		_sky.sky_top_color = _mix(0, clouds)
		_sky.sky_horizon_color = _mix(1, clouds)
		_sky.ground_horizon_color = _mix(1, clouds)
		_cover(clouds)
		_sky.ground_bottom_color = 0.4 * _mix(1, clouds)


## Draws thin clouds by day, stars by night. Both are gone where one takes the other's place.
func _cover(clouds: float) -> void:
	var stars := 1.0 - smoothstep(0.0, STARLIGHT, light)
	_sky.sky_cover = Stars.cover() if stars > 0.0 else Clouds.cover()
	var color := Color.WHITE if stars > 0.0 else Color.WHITE.lerp(LOW_CLOUDS, _warm)
	_sky.sky_cover_modulate = Color(color, (stars if stars > 0.0 else light * light - STARLIGHT * STARLIGHT) * (1.0 - clouds))


## Blends the colours of night, dusk and day, in this order with growing light; greyer under clouds, which show by day.
func _mix(which: int, clouds: float) -> Color:
	var day := DAY[which].lerp(LOW[which], _warm)
	var clear := NIGHT[which].lerp(DUSK[which], minf(2.0 * light, 1.0)).lerp(day, maxf(2.0 * light - 1.0, 0.0))
	return clear.lerp(CLOUDS[which] * lerpf(0.04, 1.0, light), clouds)

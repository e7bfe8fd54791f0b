# SPDX-License-Identifier: MIT
## Surroundings up to the horizon, made of the walk's country: a level middle or a terrain for what is shown, around it meadows, hills and
## groves.
extends Node3D

const Hills := preload("res://demo/walk/hills.gd")
const Clouds := preload("res://demo/walk/clouds.gd")
const Sun := preload("res://demo/sun.gd")
const Country := preload("res://demo/walk/country.gd")
const Trees := preload("res://demo/walk/trees.gd")
const Look := preload("res://demo/walk/look.gd")
const SIDE := {true: 192, false: 1024}  # metres, of all grass: small, for software rendering, or not
## Metres, side up to which the grass around the middle is as dense as in the walk's own middle. Farther out a blade is narrower than a
## pixel from every camera of the demo, so wider blades look the same.
const CLOSE := 320.0
const MARGIN := 6.0  # metres, by which the level ground is larger than the middle

var hills := Hills.new()
var country := Country.new()
var trees := Trees.new()


## p_middle: side of the square in the middle that stays free of this grass, metres. p_level: side of the square whose
## ground is level; 0: none.
func make(p_middle: float, p_level: float, is_small: bool) -> void:
	add_child(hills)
	add_child(country)
	add_child(trees)
	hills.level = 0.5 * sqrt(2.0) * p_level + MARGIN if p_level > 0.0 else 0.0
	hills.make(SIDE[is_small])
	if p_middle < CLOSE and not is_small:
		country.surround(p_middle, CLOSE, hills, Country.NEAR_DENSITY)
	country.surround(p_middle if is_small else maxf(p_middle, CLOSE), SIDE[is_small], hills, Country.FAR_DENSITY)
	if hills.water > -INF:
		country.flood(hills.water, hills)
	trees.make(hills, clampf(0.5 * p_middle, 45.0, 70.0), 460.0)
	set_weather(0.0, 0.0)


## Makes it around a field, whose grass goes on there. p_terrain: what the field stands on; null: level ground.
func surround(p_field: GrassField, p_terrain: Hills.Terrain, is_small: bool) -> void:
	country.species = p_field.species
	if not country.species:
		country.species = [GrassSpecies.new()]
	country.soil_color = p_field.soil_color
	country.root_shade = p_field.root_shade
	p_field.border_fade = 0.0
	hills.terrain = p_terrain
	make(p_field.size.x, 0.0 if p_terrain else p_field.size.x, is_small)
	set_wind(p_field.wind_speed)


## Gives a scene's sky clouds and a sun, whose shadows reach as far as the groves.
static func open_sky(world: WorldEnvironment, sun: DirectionalLight3D) -> void:
	world.environment = with_clouds(world.environment)  # the environment in the file does not change
	Sun.complete(sun, world.environment.sky.sky_material)
	Look.reflect(Look.SKY)


## Returns a copy of an environment, with clouds in its sky.
static func with_clouds(environment: Environment) -> Environment:
	var clouded: Environment = environment.duplicate(true)
	clouded.sky.sky_material.sky_cover = Clouds.cover()
	return clouded


func set_wind(speed: float) -> void:
	for field in country.fields:
		field.wind_speed = speed


func set_weather(snow: float, wetness: float) -> void:
	hills.cover(snow, wetness)
	Look.cover(snow, wetness)
	Trees.cover(snow, wetness)
	for field in country.fields:
		field.snow = snow
		field.wetness = wetness

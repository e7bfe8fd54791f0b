# SPDX-License-Identifier: MIT
## The demo's fire spreads with the wind, leaves stubble, wear and a black tint in the map, and goes out.
extends "res://tests/field_case.gd"

const Fire := preload("res://demo/fire.gd")


## Returns how far along `way` the fire has come without a gap, metres.
func reach(fire: Fire, way: Vector2) -> float:
	var far := 0.0
	while fire.has_reached(way * (far + Fire.SIDE)):
		far += Fire.SIDE
	return far


func lit_fire(field: GrassField, wind: Vector2) -> Fire:
	var fire := Fire.new(field)
	fire.wind = wind
	fire.light(Vector3.ZERO, 0.8)
	return fire


func test_fire_runs_down_the_wind() -> void:
	var field := add_field({size = Vector2(24, 24)})
	await ticks(1)
	var fire := lit_fire(field, Vector2(4, 0))
	for i in 50:
		fire.advance(0.1)
	var down := reach(fire, Vector2.RIGHT)
	var up := reach(fire, Vector2.LEFT)
	print("    in 5 s: %.1f m down the wind, %.1f m against it" % [down, up])
	assert_greater(down, 3.0)
	assert_greater(down, 2.0 * up)
	assert_greater(fire.burnt, 0)


func test_without_wind_it_runs_to_all_sides() -> void:
	var field := add_field({size = Vector2(24, 24)})
	await ticks(1)
	var fire := lit_fire(field, Vector2.ZERO)
	for i in 60:
		fire.advance(0.1)
	var ways := [Vector2.RIGHT, Vector2.LEFT, Vector2.UP, Vector2.DOWN].map(func(way: Vector2) -> float: return reach(fire, way))
	assert_greater(ways.min(), 1.0)
	assert_less(ways.max() - ways.min(), 1.6, str(ways))


func test_it_leaves_stubble_and_ends() -> void:
	var field := add_field({size = Vector2(6, 6)})
	await ticks(1)
	var tall := field.get_height_at(Vector3(1, 0, 0))
	var fire := lit_fire(field, Vector2(4, 0))
	var steps := 0
	while not fire.is_out() and steps < 600:
		fire.advance(0.1)
		steps += 1
	assert_true(fire.is_out(), "it ends")
	assert_greater(fire.burnt, 60, "most of the 72 down the wind")
	await ticks(1)
	assert_greater(tall, 0.15)
	for place: Vector2 in [Vector2(1, 0), Vector2(2, 0.5)]:
		assert_less(field.get_height_at(Vector3(place.x, 0, place.y)), 0.05, "stubble")
		var wear := field.map.sample(GrassMap.CHANNEL_WEAR, place)
		assert_true(wear > 0.1 and wear < 0.6, "worn, not bare: %f" % wear)
		assert_greater(field.get_density_at(Vector3(place.x, 0, place.y)), 0.4)
		assert_less(field.map.sample(GrassMap.CHANNEL_TINT, place, 1), 0.15, "black")
		assert_greater(field.map.sample(GrassMap.CHANNEL_TINT, place, 3), 0.5)
	assert_eq(fire.image.get_pixel(8, 6), Color(0, 1, 0), "charred, and no longer burning")

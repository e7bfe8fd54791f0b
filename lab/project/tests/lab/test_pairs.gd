# SPDX-License-Identifier: MIT
## Of each pair the second half shows something else than the first, and nothing of it stays for the next pair.
extends "res://tests/case.gd"

const Features := preload("res://demo/pairs/features.gd")
const Pairs := preload("res://demo/pairs/pairs.gd")

var pairs: Pairs


func before() -> void:
	pairs = (load("res://demo/pairs.tscn") as PackedScene).instantiate()
	pairs.size = "tiny"
	add_child(pairs)
	await ticks(60)


func after() -> void:
	pairs.free()


## Returns what of the grass in the middle a picture would show, as one value.
func state() -> Array:
	var field: GrassField = pairs.stage.country.field
	var place: Vector3 = pairs.pair.on_ground(Vector3.ZERO)
	var facts := [field.density, field.species.size(), field.snow, field.wetness, field.wind_speed]
	facts.append(snappedf(field.get_density_at(place), 0.1))
	facts.append(snappedf(field.get_height_at(place), 0.02))
	var worn := 0.0
	for i in 5:
		var at := place + Vector3(0.0, 0.0, 0.2 * i)
		worn = maxf(worn, field.map.sample(GrassMap.CHANNEL_WEAR, Vector2(at.x, at.z)))
	facts.append(snappedf(worn, 0.25))
	return facts


func bend() -> float:
	var most := 0.0
	for i in 20:
		var place := Vector3(0.15 if i % 2 == 0 else 0.3, 0.0, -0.125 * i)
		var lean: Vector3 = pairs.stage.country.field.get_bend_at(pairs.pair.on_ground(place))
		most = maxf(most, absf(lean.x) + absf(lean.y) + absf(lean.z))
	return most


func test_halves_differ() -> void:
	var camera: Camera3D = pairs.get_node("Camera")
	for name: String in Features.ALL:
		await pairs.show_pair(name, false)
		assert_true(camera.is_position_in_frustum(pairs.pair.on_ground(Vector3.ZERO)), name + ": its middle is in the picture")
		assert_true(pairs.pair.about.contains(";"), name + " says what its halves are")
		var first := state()
		var lean := bend()
		await pairs.show_pair(name, true)
		var second := state()
		if name in ["bent", "risen", "blast"]:
			assert_greater(absf(bend() - lean), 0.05, "%s: the grass lies otherwise" % name)
		else:
			assert_true(first != second, "%s: %s" % [name, first])


func test_nothing_stays() -> void:
	await pairs.show_pair("wind", false)
	var begin := state()
	for name: String in Features.ALL:
		if name not in ["bent", "risen", "blast", "wind"]:
			await pairs.show_pair(name, true)
	await pairs.show_pair("wind", false)
	assert_eq(state(), begin)

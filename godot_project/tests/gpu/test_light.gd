# SPDX-License-Identifier: MIT
## Grass has about the same brightness near and far, in any light.
extends "res://tests/light_case.gd"


## Luminances of columns of a picture around `distance`, of some rows each.
func columns_at(image: Image, distance: float) -> Array[PackedFloat32Array]:
	var coarse: Image = image.duplicate()
	coarse.shrink_x2()
	coarse.shrink_x2()
	var rows: Array[PackedFloat32Array] = []
	for way: float in [0.7, 0.85, 1.0, 1.2, 1.4]:
		rows.append(PackedFloat32Array())
		for column in range(0, coarse.get_width(), 16):
			rows[-1].append(light_of(coarse, way * distance, column, column + 16, 0.06))
	return rows


## Returns how much lighter the lightest tenth of the columns is than the darkest, over what both are without wind: the mean of the rows.
func contrast(windy: Array[PackedFloat32Array], calm: Array[PackedFloat32Array]) -> float:
	var sum := 0.0
	for row in windy.size():
		var lights: Array[float] = []
		for column in windy[row].size():
			lights.append(windy[row][column] / calm[row][column])
		lights.sort()
		sum += lights[lights.size() * 9 / 10] / lights[lights.size() / 10] - 1.0
	return sum / windy.size()


## What is drawn of far grass is as light as all of it would be, in pictures that resolve each blade; and near grass is not black. Each view
## is drawn in all lights, one after the other: in another light the same blades are drawn, at once.
func test_grass_is_as_light_as_all_of_its_blades_at_any_distance() -> void:
	var field := add_even_field()
	look_ahead()
	await drawn()
	assert_less(field.get_statistics().drawn_blades, 0.05 * field.get_blade_count(), "few are drawn")
	var means: Dictionary[String, PackedFloat32Array] = {}
	for light: String in LIGHTS:
		set_light(light)
		var image := await next_picture()
		save(image, "light_%s" % light)
		means[light] = profile_of(image)
	for i in DISTANCES.size():
		var wholes := await references(field, DISTANCES[i])
		for light: String in LIGHTS:
			print("    %s, %d m: %.3f of %.3f" % [light, DISTANCES[i], means[light][i], wholes[light]])
			assert_near(means[light][i] / wholes[light], 1.0, 0.06, "%s, %d m" % [light, DISTANCES[i]])


## In a still picture.
func test_gusts_are_waves_of_light() -> void:
	var field := add_even_field()
	world.environment.ambient_light_energy = 0.35
	sun.rotation_degrees = Vector3(-40, 60, 0)
	look_ahead()
	var calm := await picture()
	field.wind_speed = 6.0
	var windy := await picture()
	save(windy, "gusts")
	var least := {12.0: 0.15, 30.0: 0.15, 80.0: 0.06}
	for distance: float in least:
		var waves := contrast(columns_at(windy, distance), columns_at(calm, distance))
		print("    at %d m crests are %.2f lighter than troughs" % [distance, waves])
		assert_greater(waves, least[distance])

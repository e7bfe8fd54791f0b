# SPDX-License-Identifier: MIT
## Grass is about as light near as far, whatever light falls on it.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(320, 180)
const PICTURES := "user://pictures/"  # looked at by people
const EYE := 1.7  # metres above the ground
const DISTANCES: Array[float] = [3.0, 5.0, 8.0, 12.0, 18.0, 27.0, 40.0, 60.0, 90.0]

var sun: DirectionalLight3D
var world: WorldEnvironment


func before() -> void:
	open_view(SIZE, 4)
	DirAccess.make_dir_recursive_absolute(PICTURES)
	camera.far = 400.0
	sun = DirectionalLight3D.new()
	viewport.add_child(sun)
	world = WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color(0.4, 0.5, 0.7)
	world.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	world.environment.ambient_light_color = Color.WHITE
	viewport.add_child(world)


## Mean luminance of the grass at each of DISTANCES.
func profile() -> PackedFloat32Array:
	look(Vector3(0, EYE, 118), Vector3(0, EYE - 3.0, 108))
	await drawn()
	var image := await picture()
	var means := PackedFloat32Array()
	for distance in DISTANCES:
		means.append(light_of(image, distance, 0, SIZE.x))
	return means


## Mean luminance of the grass at `distance`, and a share nearer and farther, within columns of a picture of profile().
func light_of(image: Image, distance: float, from: int, to: int, share := 0.15) -> float:
	var low := camera.unproject_position(Vector3(0, 0.25, 118.0 - (1.0 - share) * distance)).y / viewport.size.y * SIZE.y
	var high := camera.unproject_position(Vector3(0, 0.25, 118.0 - (1.0 + share) * distance)).y / viewport.size.y * SIZE.y
	var sum := 0.0
	var count := 0
	for y in range(maxi(floori(high), 0), mini(maxi(ceili(low), floori(high) + 1), SIZE.y)):
		for x in range(from, to):
			sum += image.get_pixel(x, y).srgb_to_linear().get_luminance()
			count += 1
	return sum / maxi(count, 1)


## How much lighter the lightest tenth of the picture's columns is than the darkest, around `distance`: the mean of some rows. Without the
## quarters at the sides, where the sky beside the field is seen from 90 m on.
func contrast_at(image: Image, distance: float) -> float:
	var sum := 0.0
	for way: float in [0.7, 0.85, 1.0, 1.2, 1.4]:
		var lights: Array[float] = []
		for column in range(SIZE.x / 4, SIZE.x * 3 / 4, 16):
			lights.append(light_of(image, way * distance, column, column + 16, 0.06))
		lights.sort()
		sum += lights[lights.size() * 9 / 10] / lights[lights.size() / 10] - 1.0
	return sum / 5.0


## From 12 m on it is as light as anywhere, and near, where the eye sees between the blades, at least as light as 0.4 of that.
func test_far_grass_is_as_light_at_any_distance_and_near_grass_is_not_black() -> void:
	var field := add_seen_field({size = Vector2(240, 240), wind_speed = 0.0, clump_height = 0.0, clump_lean = 0.0, clump_tint = 0.0})
	for light: Array in [["sky", 1.0, false, 0.0], ["front", 0.35, true, 0.0], ["side", 0.35, true, 90.0], ["back", 0.35, true, 180.0]]:
		world.environment.ambient_light_energy = light[1]
		sun.visible = light[2]
		sun.rotation_degrees = Vector3(-40, light[3], 0)
		var means := await profile()
		(await picture()).save_png(PICTURES + "light_%s.png" % light[0])
		var texts := PackedStringArray()
		for i in means.size():
			texts.append("%d m %.3f" % [DISTANCES[i], means[i]])
		print("    %s: %s" % [light[0], ", ".join(texts)])
		var far := means.slice(3)
		var middle := 0.0
		for mean in far:
			middle += mean / far.size()
		for i in far.size():
			assert_near(far[i], middle, 0.1 * middle, "%s, %d m" % [light[0], DISTANCES[3 + i]])
		assert_greater(means[0], 0.4 * middle, "%s, %d m" % [light[0], DISTANCES[0]])
	assert_less(field.get_statistics().drawn_blades, 0.05 * field.get_blade_count(), "few are drawn")


## In a still picture.
func test_gusts_are_waves_of_light() -> void:
	var field := add_seen_field({size = Vector2(240, 240), clump_height = 0.0, clump_lean = 0.0, clump_tint = 0.0})
	world.environment.ambient_light_energy = 0.35
	sun.rotation_degrees = Vector3(-40, 60, 0)
	look(Vector3(0, EYE, 118), Vector3(0, EYE - 3.0, 108))
	for distance: float in [12.0, 30.0, 80.0]:
		field.wind_speed = 0.0
		await drawn()
		var calm := contrast_at(await picture(), distance)
		field.wind_speed = 6.0
		await drawn()
		var windy := contrast_at(await picture(), distance)
		print("    at %d m crests are %.2f lighter than troughs, %.2f without wind" % [distance, windy, calm])
		assert_greater(windy, 0.1)
		assert_greater(windy, 1.5 * calm)

# SPDX-License-Identifier: MIT
## A stand of a short species is about as bright as the meadow beside it, near and far, and does not look like a carpet of dots.
extends "res://tests/species_case.gd"

const PRESETS := "res://addons/grass_field/presets/%s.tres"
const HALF := 10.0  # metres, of the field's side: clover grows at x < 0, meadow at x > 0
## Over the meadow. From above leaves that lie flat are lighter than blades that stand.
const DARKEST := 2.0 / 3.0
const LIGHTEST := 4.0 / 3.0
const LIGHTEST_FROM_ABOVE := 1.75
## Eye, and the corners of what is compared; x is that of the meadow.
const VIEWS := {
	three = [Vector3(0, 1.7, 9), Rect2(0.4, 5.5, 0.8, 1.0)],
	ten = [Vector3(0, 1.7, 9.5), Rect2(0.8, -2.0, 3.0, 3.0)],
	sixty = [Vector3(0, 60, 0.1), Rect2(1.5, -7.0, 6.0, 14.0)],
}

var sun: DirectionalLight3D
var world: WorldEnvironment


func before() -> void:
	open_view(Vector2i(320, 360), 2)
	sun = DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-45, 60, 0)
	sun.light_energy = 1.4
	sun.shadow_enabled = true
	viewport.add_child(sun)
	world = WorldEnvironment.new()
	world.environment = load("res://demo/day.tres").duplicate(true)
	world.environment.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	world.environment.fog_enabled = false
	world.environment.sky.radiance_size = Sky.RADIANCE_SIZE_32  # it has no details
	viewport.add_child(world)


func set_overcast() -> void:
	sun.visible = false
	var sky: ProceduralSkyMaterial = world.environment.sky.sky_material
	sky.sky_top_color = Color(0.62, 0.65, 0.68)
	sky.sky_horizon_color = Color(0.78, 0.8, 0.82)
	var size := viewport.size
	viewport.size = Vector2i(16, 16)  # nobody looks at these frames
	await frames(6)  # the sky's light comes in parts
	viewport.size = size


## Meadow, and left of it the species that is painted.
func add_stands(name: String) -> GrassField:
	var species: Array[GrassSpecies] = []
	for preset: String in ["meadow", "hay_meadow", name]:
		species.append(load(PRESETS % preset).duplicate())
	species[-1].share = 0.0  # only where it is painted
	var field := add_seen_field({size = Vector2(2, 2) * HALF, density = 600.0, map = full_map(), species = species})
	field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON
	var tool := brush(GrassBrush.TOOL_SPECIES, 5.2, {species = 3})
	for x: float in [-5.2, -9.0]:
		field.paint(tool, Vector3(x, 0, -HALF), Vector3(x, 0, HALF))
	return field


## Luminances of the picture's pixels whose grass stands within a rectangle of the ground.
func lights_in(image: Image, ground: Rect2) -> PackedFloat32Array:
	var corner := camera.unproject_position(Vector3(ground.position.x, 0.1, ground.position.y))
	var low := corner
	var high := corner
	for place: Vector2 in [ground.end, Vector2(ground.position.x, ground.end.y), Vector2(ground.end.x, ground.position.y)]:
		corner = camera.unproject_position(Vector3(place.x, 0.1, place.y))
		low = low.min(corner)
		high = high.max(corner)
	var lights := PackedFloat32Array()
	var finer := float(viewport.size.x) / image.get_width()
	for y in range(maxi(int(low.y / finer), 0), mini(int(high.y / finer), image.get_height())):
		for x in range(maxi(int(low.x / finer), 0), mini(int(high.x / finer), image.get_width())):
			lights.append(image.get_pixel(x, y).srgb_to_linear().get_luminance())
	return lights


## Median, which flowers do not lift; and the standard deviation over the mean.
func spread_of(lights: PackedFloat32Array) -> Vector2:
	var sum := 0.0
	var squares := 0.0
	for light in lights:
		sum += light
		squares += light * light
	var middle := sum / lights.size()
	lights.sort()
	return Vector2(lights[lights.size() / 2], sqrt(maxf(squares / lights.size() - middle * middle, 0.0)) / middle)


func test_clover_is_as_light_as_the_meadow_beside_it() -> void:
	add_stands("clover")
	for light: String in ["sun", "overcast"]:
		if light == "overcast":
			await set_overcast()
		for view: String in VIEWS:
			var eye: Vector3 = VIEWS[view][0]
			var ground: Rect2 = VIEWS[view][1]
			camera.fov = 20.0 if view == "sixty" else 60.0
			look(eye, Vector3(0, 0, ground.get_center().y) if view != "sixty" else Vector3.ZERO)
			var image := await picture()
			save(image, "stands_%s_%s" % [light, view])
			var meadow := spread_of(lights_in(image, ground))
			var clover := spread_of(lights_in(image, Rect2(-ground.end.x, ground.position.y, ground.size.x, ground.size.y)))
			print("    %s, %s: clover %.3f, grain %.2f; meadow %.3f, grain %.2f" % [light, view, clover.x, clover.y, meadow.x, meadow.y])
			assert_less(clover.x, (LIGHTEST_FROM_ABOVE if view == "sixty" else LIGHTEST) * meadow.x, "%s, %s" % [light, view])
			assert_greater(clover.x, DARKEST * meadow.x, "%s, %s" % [light, view])
			if view == "sixty":
				assert_less(clover.y, 0.5, "no speckle, " + light)

# SPDX-License-Identifier: MIT
## Grass is as light with its own shadows as without them, at any distance and in any sun, and shadows of other things on it stay black.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(256, 144)
const HEIGHTS: Array[float] = [15.0, 45.0, 75.0]  # of the sun, degrees
const DISTANCES: Array[float] = [3.0, 7.0, 14.0, 29.0, 69.0]  # along a line of sight that falls by 60 degrees
const UNLIKE := 0.045  # most by which the light of two pictures may differ, as a share
const UNLIKE_FAR := 0.08  # the same of pictures from different distances

var sun: DirectionalLight3D
var world: WorldEnvironment


func before() -> void:
	open_view(SIZE)
	add_light()
	sun = viewport.get_child(1) as DirectionalLight3D
	world = viewport.get_child(2) as WorldEnvironment
	world.environment.ambient_light_energy = 0.35
	camera.fov = 20.0
	camera.far = 400.0


func look_down(distance: float) -> void:
	look(distance * Vector3(0, sin(PI / 3.0), cos(PI / 3.0)), Vector3.ZERO)


func light_of(image: Image) -> float:
	var sum := 0.0
	for y in image.get_height():
		for x in image.get_width():
			sum += image.get_pixel(x, y).srgb_to_linear().get_luminance()
	return sum / (image.get_width() * image.get_height())


## Returns the light of pictures as things are now, one for each of HEIGHTS.
func lights() -> Array[float]:
	var all: Array[float] = []
	for height in HEIGHTS:
		sun.rotation_degrees = Vector3(-height, 90, 0)
		all.append(light_of(await picture()))
	return all


func test_grass_is_as_light_with_its_shadows_as_without() -> void:
	var field := add_seen_field({size = Vector2(100, 100)})
	field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON
	sun.shadow_enabled = true
	await drawn()  # the renderer may compile what casts shadows in the first of these frames
	var near_and_far: Array[float] = []
	for distance in DISTANCES:
		look_down(distance)
		var light := {}
		for shadows: String in ["cast", "not cast", "none"]:
			sun.shadow_enabled = shadows != "none"
			field.cast_shadow = int(shadows == "cast") as GeometryInstance3D.ShadowCastingSetting
			light[shadows] = await lights()
		for i in HEIGHTS.size():
			var text := "%d m, sun %d degrees high: %.4f with shadows, %.4f without"
			text = text % [distance, HEIGHTS[i], light["cast"][i], light["none"][i]]
			print("    ", text)
			assert_near(light["cast"][i] / light["none"][i], 1.0, UNLIKE, text)
			assert_near(light["not cast"][i] / light["none"][i], 1.0, 0.01, "a field without shadows, " + text)
		near_and_far.append(light["cast"][1])
	assert_less(near_and_far.max() / near_and_far.min(), 1.0 + UNLIKE_FAR, "from all distances: %s" % [near_and_far])


## A light's shader must know whether that light's map has the grass's shadows.
func test_grass_is_as_light_below_two_suns_of_which_one_casts() -> void:
	var method := RenderingServer.get_current_rendering_method()
	if method == "gl_compatibility":
		skip("Compatibility adds each sun in sRGB, and a light's shader does not know which sun it is")
		return
	var field := add_seen_field({size = Vector2(30, 30)})
	field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON
	var other := DirectionalLight3D.new()
	viewport.add_child(other)
	other.rotation_degrees = Vector3(-60, -60, 0)
	other.light_energy = 0.5
	look_down(7.0)
	sun.shadow_enabled = true
	await drawn()
	var light := {}
	for casting: String in ["neither", "one", "both"]:
		sun.shadow_enabled = casting != "neither"
		other.shadow_enabled = casting == "both"
		light[casting] = await lights()
	for i in HEIGHTS.size():
		var text := "sun %d degrees high: %.4f if one casts, %.4f if both, %.4f if neither"
		text = text % [HEIGHTS[i], light["one"][i], light["both"][i], light["neither"][i]]
		print("    ", text)
		assert_near(light["one"][i] / light["neither"][i], 1.0, UNLIKE, text)
		assert_near(light["both"][i] / light["neither"][i], 1.0, UNLIKE if method == "forward_plus" else 2.2 * UNLIKE, text)


func test_shadows_of_other_things_are_black_on_grass() -> void:
	var field := add_seen_field({size = Vector2(30, 30)})
	field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON
	var roof := MeshInstance3D.new()
	roof.mesh = BoxMesh.new()
	(roof.mesh as BoxMesh).size = Vector3(12, 0.2, 12)
	roof.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_SHADOWS_ONLY
	viewport.add_child(roof)
	roof.position = Vector3(4, 4, 0)  # towards the sun
	sun.shadow_enabled = true
	sun.rotation_degrees = Vector3(-45, 90, 0)
	world.environment.ambient_light_energy = 0.0
	look_down(7.0)
	await grown(field)
	roof.visible = false
	var lit := light_of(await picture())
	roof.visible = true
	var shaded := light_of(await picture())
	print("    %.4f of %.4f below a roof" % [shaded, lit])
	assert_less(shaded, 0.005 * lit, "no light gets through")


## Around a field there is often one with fewer and wider blades that casts no shadows. From above no border shows, wherever the sun is: as
## many pixels a blade as in a picture of 1080 rows.
func test_no_border_shows_from_above_beside_a_field_of_wider_blades() -> void:
	const WIDER := 2.8
	var calm := {size = Vector2(20, 40), clump_height = 0.0, clump_lean = 0.0, clump_tint = 0.0, border_fade = 0.0}
	var fine := add_seen_field(calm.merged({cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON}, true))
	var patch := GrassPatch.new()
	patch.width_min *= WIDER
	patch.width_max *= WIDER
	var wide := add_seen_field(calm.merged({density = 64.0, shadow_distance = 0.0, species = kind({patch = patch})}))
	sun.shadow_enabled = true
	camera.fov = 8.0
	look_down(59.0)
	for angle: float in [0.0, 90.0, 180.0]:
		var ratio := 1.0
		for side: float in [-1.0, 1.0]:
			fine.position.x = 10.0 * side
			wide.position.x = -10.0 * side
			sun.rotation_degrees = Vector3(-41, angle, 0)
			var image := await picture()
			save(image, "wider_%d_%d" % [angle, side])
			var left := light_of(image.get_region(Rect2i(4, 0, SIZE.x / 2 - 8, SIZE.y)))
			var right := light_of(image.get_region(Rect2i(SIZE.x / 2 + 4, 0, SIZE.x / 2 - 8, SIZE.y)))
			ratio *= right / left if side < 0.0 else left / right
		print("    sun from %d degrees: wider blades are %.3f times as light as fine ones" % [angle, sqrt(ratio)])
		assert_near(sqrt(ratio), 1.0, 0.04, "sun from %d degrees" % angle)

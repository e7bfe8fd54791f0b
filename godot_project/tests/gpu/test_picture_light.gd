# SPDX-License-Identifier: MIT
## In any light, grass has the same mean colour in every renderer. Forward+ runs first and saves its colours for the others.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(192, 108)
const GRASS := Rect2i(0, 28, 192, 80)  # what of a picture shows nothing else
const MEANS := "user://renderers_agree.json"  # of Forward+
const A_LOOK := 40  # frames; grass looks at the sky every 30
const UNLIKE := 1.2  # the greatest distance of mean colours in CIE L*a*b*; 2 is just seen
const SKY_UNLIKE := 0.7  # the same, under a sky whose light is computed and one that the renderer lights; a tenth of its light

var sun: DirectionalLight3D
var environment: Environment
var world: WorldEnvironment


func before() -> void:
	open_view(SIZE)
	sun = DirectionalLight3D.new()
	viewport.add_child(sun)
	environment = Environment.new()
	environment.background_mode = Environment.BG_COLOR
	environment.background_color = Color(0.4, 0.5, 0.7)
	environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	environment.ambient_light_color = Color(0.75, 0.85, 1.0)
	world = WorldEnvironment.new()
	world.environment = environment
	viewport.add_child(world)


## CIE 1976 L*a*b* of an sRGB colour, under D65.
func to_lab(color: Color) -> Vector3:
	var c := color.srgb_to_linear()
	var x := (0.4124 * c.r + 0.3576 * c.g + 0.1805 * c.b) / 0.9505
	var y := 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b
	var z := (0.0193 * c.r + 0.1192 * c.g + 0.9505 * c.b) / 1.089
	var f := func(t: float) -> float: return pow(t, 1.0 / 3.0) if t > 0.008856 else 7.787 * t + 16.0 / 116.0
	return Vector3(116.0 * f.call(y) - 16.0, 500.0 * (f.call(x) - f.call(y)), 200.0 * (f.call(y) - f.call(z)))


## Light from straight behind the eye: 0; from its right: 90.
func shine(from: float, has_shadows: bool, ambient := 0.35) -> void:
	sun.visible = true
	sun.rotation_degrees = Vector3(-40, from, 0)
	sun.shadow_enabled = has_shadows
	environment.ambient_light_energy = ambient


func under_a_sky(field: GrassField, material: Material, size := Sky.RADIANCE_SIZE_32) -> void:
	var sky := Sky.new()
	sky.sky_material = material
	sky.radiance_size = size
	environment.sky = sky
	environment.background_mode = Environment.BG_SKY
	environment.ambient_light_source = Environment.AMBIENT_SOURCE_BG
	field.visible = false
	await frames(12)  # the sky's light comes in parts
	field.visible = true


func test_all_renderers_show_the_same_colours() -> void:
	var field := add_seen_field({size = Vector2(30, 30)})
	look(Vector3(0, 1.7, 12), Vector3(0, 0, 9))
	var means := {}
	for light: String in [
		"front",
		"side",
		"back",
		"overcast",
		"front, shadows",
		"side, shadows",
		"side, shadows of grass",
		"shadows without a sky",
		"soil, shadows",
		"two species",
		"tinted",
		"sky, shadows",
		"of a camera, shadows"
	]:
		shine(0.0 if light.begins_with("front") else (180.0 if light == "back" else 90.0), light.contains("shadows"))
		match light:
			"overcast":
				environment.ambient_light_energy = 1.0
				sun.visible = false
			"shadows without a sky":
				environment.ambient_light_energy = 0.0
			"soil, shadows":
				field.density = 1.0
				await grown(field)
			"two species":
				field.density = 256.0
				field.species = [GrassSpecies.new(), GrassSpecies.new()]
				await grown(field)
			"tinted":
				field.species = []
				field.map = full_map()
				field.map.stroke(brush(GrassBrush.TOOL_TINT, 9.0, {color = Color(0.8, 0.4, 0.1)}), Vector2(0, 9), Vector2(0, 9))
				await grown(field)
			"sky, shadows":
				field.map = null
				await grown(field)
				await under_a_sky(field, ProceduralSkyMaterial.new())
			"of a camera, shadows":
				camera.environment = environment
				world.environment = null
		field.cast_shadow = int(light == "side, shadows of grass") as GeometryInstance3D.ShadowCastingSetting
		var image := await picture()
		save(image, "light_" + light.replace(",", "").replace(" ", "_"))
		means[light] = mean(image.get_region(GRASS))
	compare(means)


func compare(means: Dictionary) -> void:
	var renderer := RenderingServer.get_current_rendering_method()
	if renderer == "forward_plus":
		FileAccess.open(MEANS, FileAccess.WRITE).store_string(var_to_str(means))
	if not FileAccess.file_exists(MEANS):
		skip("Forward+ has not run here")
		return
	var wanted: Dictionary = str_to_var(FileAccess.get_file_as_string(MEANS))
	for light: String in means:
		var unlike := to_lab(means[light]).distance_to(to_lab(wanted[light]))
		var color: Color = 100.0 * means[light]
		print("    %s: (%.1f, %.1f, %.1f) %%, %.2f from Forward+" % [light, color.r, color.g, color.b, unlike])
		assert_less(unlike, UNLIKE, light)


## Returns each sky's material twice: as grass computes its light, and with a picture of halves, of which it asks the renderer.
func skies() -> Dictionary:
	var clear := Image.create_empty(8, 8, false, Image.FORMAT_RGBA8)
	var clouds := Image.create_empty(64, 32, false, Image.FORMAT_RGBA8)
	clouds.fill_rect(Rect2i(0, 3, 24, 12), Color(0.9, 0.8, 0.7, 0.8))
	var found := {}
	for kind: String in ["gradient", "clouds", "panorama"]:
		found[kind] = []
		for format: Image.Format in [Image.FORMAT_RGBA8, Image.FORMAT_RGBAH]:
			var picture: Image = (clear if kind == "gradient" else clouds).duplicate()
			picture.convert(format)
			var texture := ImageTexture.create_from_image(picture)
			if kind == "panorama":
				found[kind].append(PanoramaSkyMaterial.new())
				found[kind][-1].panorama = texture
				continue
			var sky := ProceduralSkyMaterial.new()
			sky.sky_top_color = Color(0.28, 0.47, 0.72)
			sky.sky_horizon_color = Color(0.72, 0.79, 0.85)
			sky.sky_energy_multiplier = 0.9
			sky.sky_cover = texture
			found[kind].append(sky)
	return found


func test_the_light_of_a_sky_is_that_of_the_renderer() -> void:
	if RenderingServer.get_current_rendering_method() != "gl_compatibility":
		skip("only Compatibility needs the sky's light")
		return
	var field := add_seen_field({size = Vector2(30, 30)})
	look(Vector3(0, 1.7, 12), Vector3(0, 0, 9))
	shine(90.0, true)
	sun.sky_mode = DirectionalLight3D.SKY_MODE_LIGHT_ONLY  # what is computed has no suns
	environment.background_energy_multiplier = 0.8
	await grown(field)
	var all := skies()
	for kind: String in all:
		var means: Array[Color] = []
		for material: Material in all[kind]:
			await under_a_sky(field, material, Sky.RADIANCE_SIZE_256)
			await frames(A_LOOK)
			var image := await picture()
			means.append(mean(image.get_region(GRASS)))
		var unlike := to_lab(means[0]).distance_to(to_lab(means[1]))
		print("    %s: %s computed, %s baked, %.2f apart" % [kind, means[0], means[1], unlike])
		assert_less(unlike, SKY_UNLIKE, kind)

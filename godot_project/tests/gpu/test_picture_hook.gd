# SPDX-License-Identifier: MIT
## The effect of a surface hook on blades and soil, in every renderer: its inputs, colour, glow, snow and wetness.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(192, 108)
const HOOKS := "res://addons/grass_field/hooks/"
const HEAD := "void grass_surface(in GrassSurface s, inout vec3 albedo, inout float roughness, inout vec3 emission) {\n"


func before() -> void:
	open_view(SIZE)


func hook(code: String) -> ShaderInclude:
	var made := ShaderInclude.new()
	made.code = code
	return made


## Expressions of s, each a number, in one hook: a shader for each takes the engine seconds.
const SHOWN: Array[String] = [
	"0.5",
	"s.wetness",
	"s.snow",
	"s.wear",
	"10.0 * (s.cut - 0.05)",
	"s.normal.y > 0.5 ? 0.5 : 0.0",
	"s.position.y > 0.3 || s.position.y < -0.01 ? 0.0 : 0.5",
	"s.height > 0.12 ? 0.0 : 0.5",
	"s.is_soil ? 0.5 : 0.0",
	"abs(s.uv.x * 8.0 - 4.0 - s.position.x) < 0.2 ? 0.5 : 0.0",
	"s.uv.x",
]


func hook_of_shown() -> ShaderInclude:
	var code := "uniform int hook_shown;\n" + HEAD + "\talbedo = vec3(0.0);\n"
	for i in SHOWN.size():
		code += "\tif (hook_shown == %d) {\n\t\temission = vec3(%s);\n\t}\n" % [i, SHOWN[i]]
	return hook(code + "}\n")


## Returns a picture of the field that shows `what`, one of SHOWN, as light of its own. Linear.
func shown(field: GrassField, what: String) -> Color:
	assert_true(what in SHOWN, what)
	field.set_hook_parameter("hook_shown", SHOWN.find(what))
	return mean(await picture()).srgb_to_linear()


## Without any light a hook's emission alone is seen.
func test_the_hook_is_given_what_the_page_says() -> void:
	var map := full_map()
	map.stroke(brush(GrassBrush.TOOL_CUT, 9.0, {cut_height = 0.1}), Vector2.ZERO, Vector2.ZERO)
	var field := add_seen_field({size = Vector2(8, 8), map = map, wetness = 0.25, snow = 0.75, sheen = 0.0})
	field.trample(Vector3.ZERO, 9.0, 0.5)
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color.BLACK
	viewport.add_child(world)
	look(Vector3(0, 2.0, 0), Vector3(0, 0, 0.01))
	await grown(field)
	assert_less(mean(await picture()).get_luminance(), 0.01, "dark without a hook")
	field.surface_hook = hook_of_shown()
	var all := await shown(field, "0.5")
	assert_near(all.g, 0.5, 0.02, "emission is linear")
	assert_near((await shown(field, "s.wetness")).g, 0.25, 0.02)
	assert_near((await shown(field, "s.snow")).g, 0.75, 0.03)
	assert_near((await shown(field, "s.wear")).g, map.sample(GrassMap.CHANNEL_WEAR, Vector2.ZERO), 0.05)
	assert_near((await shown(field, "10.0 * (s.cut - 0.05)")).g, 0.5, 0.05)
	assert_near((await shown(field, "s.normal.y > 0.5 ? 0.5 : 0.0")).g, 0.5, 0.05)
	assert_near((await shown(field, "s.position.y > 0.3 || s.position.y < -0.01 ? 0.0 : 0.5")).g, 0.5, 0.02)
	assert_near((await shown(field, "s.height > 0.12 ? 0.0 : 0.5")).g, 0.5, 0.02, "nothing stands higher than it was cut")
	var soil := (await shown(field, "s.is_soil ? 0.5 : 0.0")).g
	assert_true(soil > 0.01 and soil < 0.49, "soil and blades are seen: %f" % soil)
	look(Vector3(1, 1.0, 0), Vector3(1, 0, 0.01))
	var x := await shown(field, "abs(s.uv.x * 8.0 - 4.0 - s.position.x) < 0.2 ? 0.5 : 0.0")
	assert_near(x.g, 0.5, 0.05, "uv and position name the same place")
	assert_near((await shown(field, "s.uv.x")).g, 0.625, 0.05)


func test_a_hook_changes_blades_and_soil_and_goes() -> void:
	add_light()
	var field := add_seen_field({size = Vector2(12, 12)})
	look(Vector3(0, 1.7, 5), Vector3(0, 0, 2))
	var plain := await picture()
	field.surface_hook = hook("uniform vec3 hook_color : source_color;\n" + HEAD + "\talbedo = grass_linear(hook_color);\n}\n")
	field.set_hook_parameter("hook_color", Color(0.8, 0.1, 0.1))
	var red := await picture()
	save(red, "hook_red")
	assert_greater(share_of(red, is_red), 0.6)
	assert_eq(share_of(plain, is_red), 0.0)
	field.debug_view = GrassField.DEBUG_VIEW_LOD
	assert_less(share_of(await picture(), is_red), 0.2, "debug views show what they are for")
	field.debug_view = GrassField.DEBUG_VIEW_OFF
	field.surface_hook = null
	assert_less(difference(plain, await picture()).y, 1e-3, "as before")


func test_snow_and_wetness() -> void:
	add_light()
	var field := add_seen_field({size = Vector2(12, 12), surface_hook = load(HOOKS + "weather.gdshaderinc")})
	look(Vector3(0, 1.2, 4), Vector3(0, 0, 1.5))
	var plain := await picture()
	save(plain, "hook_dry")
	field.surface_hook = null
	assert_less(difference(plain, await picture()).y, 1e-3, "without weather the hook changes nothing")
	field.surface_hook = load(HOOKS + "weather.gdshaderinc")
	var whiter := mean(plain).b
	for snow: float in [0.3, 0.6, 1.0]:
		field.snow = snow
		var snowy := await picture()
		save(snowy, "hook_snow_%d" % roundi(100 * snow))
		assert_greater(mean(snowy).b, whiter + 0.03, "more snow is whiter: %.1f" % snow)
		whiter = mean(snowy).b
	field.snow = 0.0
	field.wetness = 1.0
	var wet := await picture()
	save(wet, "hook_wet")
	assert_less(mean(wet).g, mean(plain).g - 0.02, "wet grass is darker")
	for sun: DirectionalLight3D in viewport.find_children("*", "DirectionalLight3D", true, false):
		sun.rotation_degrees = Vector3(-20, 180, 0)  # into the eye
	await drawn()
	var spot := Rect2i(76, 24, 32, 28)  # below the sun
	var shining := await next_picture()
	save(shining, "hook_wet_against_the_sun")
	field.set_hook_parameter("wet_roughness", 0.9)
	var dull := await picture()
	print("    wet grass against the sun shines by %.4f" % (mean(shining.get_region(spot)).g - mean(dull.get_region(spot)).g))
	assert_greater(mean(shining.get_region(spot)).g, mean(dull.get_region(spot)).g + 0.006, "and shines")  # by 0.012 with 64 samples a pixel


## Plants have no colour of their own here, neither their meshes nor their impostors: what glows is theirs alone, since nothing else grows.
func test_the_hook_reaches_plants_with_a_mesh_and_their_impostors() -> void:
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color.BLACK
	viewport.add_child(world)
	var fern: GrassSpecies = load("res://addons/grass_field/presets/fern.tres").duplicate()
	fern.share = 1.0
	var field := add_seen_field({size = Vector2(8, 8), density = 20.0, species = [fern] as Array[GrassSpecies], soil_enabled = false})
	look(Vector3(0, 1.2, 3), Vector3(0, 0.3, 0))
	for distance: float in [100.0, 1.0]:
		fern.plant_distance = distance
		field.surface_hook = null
		await drawn()
		assert_greater(field.get_counters().drawn_plants + field.get_counters().drawn_impostors, 20)
		assert_less(mean(await picture()).get_luminance(), 0.02, "dark without a hook")
		field.surface_hook = hook(HEAD + "\talbedo = vec3(0.0);\n\temission = vec3(0.0, s.is_soil ? 0.0 : s.along, 0.0);\n}\n")
		var glowing := mean(await picture())
		print("    plants drawn up to %.0f m as meshes glow by %s" % [distance, glowing])
		assert_greater(glowing.g, 0.05)
		assert_less(glowing.r, 0.02)

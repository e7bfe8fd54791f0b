# SPDX-License-Identifier: MIT
## A field's surface hook: its uniforms are properties; code that does not compile is reported and left out.
extends "res://tests/field_case.gd"

const HOOKS := "res://addons/grass_field/hooks/"
const HEAD := "void grass_surface(in GrassSurface s, inout vec3 albedo, inout float roughness, inout vec3 emission) {\n"
const GLOW := (
	"uniform float ember_glow : hint_range(0, 4) = 0.5;\nuniform sampler2D ember_paint;\n" + HEAD + "\temission = vec3(ember_glow);\n}\n"
)


func include(code: String) -> ShaderInclude:
	var made := ShaderInclude.new()
	made.code = code
	return made


## Returns the names of the hook's uniforms among the field's properties.
func listed(field: GrassField) -> Array:
	var names := field.get_property_list().map(func(property: Dictionary) -> String: return property.name)
	return names.filter(func(name: String) -> bool: return name.begins_with("hook/"))


func test_uniforms_are_properties() -> void:
	var field := add_field({surface_hook = include(GLOW)})
	await ticks(2)
	assert_eq(listed(field), ["hook/ember_glow", "hook/ember_paint"])
	var glow: Dictionary = field.get_property_list().filter(func(one: Dictionary) -> bool: return one.name == "hook/ember_glow")[0]
	assert_eq(glow.hint, PROPERTY_HINT_RANGE)
	assert_true(glow.usage & PROPERTY_USAGE_STORAGE, "saved with the scene")
	field.set_hook_parameter("ember_glow", 2.0)
	assert_eq(field.get("hook/ember_glow"), 2.0)
	field.set("hook/ember_glow", 3.0)
	assert_eq(field.get_hook_parameter("ember_glow"), 3.0)
	field.surface_hook = null
	assert_eq(listed(field), [])
	field.surface_hook = include(GLOW)
	assert_eq(field.get_hook_parameter("ember_glow"), 3.0, "kept for the next hook")
	field.set_hook_parameter("ember_glow", null)
	assert_ne(field.get_hook_parameter("ember_glow"), 3.0, "as the include has it")


func test_a_scene_keeps_them() -> void:
	var field := add_field({surface_hook = include(GLOW), snow = 0.25})
	field.set_hook_parameter("ember_glow", 1.5)
	var scene := PackedScene.new()
	scene.pack(field)
	var copy: GrassField = scene.instantiate()
	add_child(copy)
	await ticks(1)
	assert_eq(copy.get_hook_parameter("ember_glow"), 1.5)
	assert_eq(copy.snow, 0.25)
	assert_eq(copy.surface_hook.code, GLOW)


func test_an_unknown_uniform_is_an_error() -> void:
	expect_error("set_hook_parameter(): there is no uniform `wind`. The uniforms of `surface_hook` are: ember_glow, ember_paint.")
	expect_error("get_hook_parameter(): there is no uniform `glew`.")
	var field := add_field({surface_hook = include(GLOW)})
	field.set_hook_parameter("wind", Vector2(9, 9))
	assert_eq(field.get_hook_parameter("glew"), null)


func test_what_does_not_compile_is_left_out() -> void:
	expect_error("Unknown identifier in expression: 'nonsense'")
	expect_error("Shader compilation failed")
	expect_error("`surface_hook`: the include does not compile")
	var field := add_field({surface_hook = include(HEAD + "\talbedo = nonsense;\n}\n")})
	await ticks(2)
	assert_eq(listed(field), [])
	assert_greater(await bend_with_ball(field), 0.05, "the field goes on")
	field.surface_hook.code = GLOW
	await frames(2)
	assert_eq(listed(field), ["hook/ember_glow", "hook/ember_paint"], "mended")


func test_an_include_without_the_function_is_left_out() -> void:
	expect_error("No matching function found for: 'grass_surface'")
	expect_error("Shader compilation failed")
	expect_error("`surface_hook`: the include does not compile")
	var field := add_field({surface_hook = include("void grass_surfaces() {}\n")})
	await ticks(2)
	assert_eq(listed(field), [])
	assert_greater(field.get_blade_count(), 0)


## A name that the field's own shaders have passes where the include stands alone.
func test_a_name_that_is_taken_is_left_out() -> void:
	expect_error("Redefinition of 'root_shade'")
	expect_error("Shader compilation failed")
	expect_error("`surface_hook`: the include does not compile")
	var field := add_field({surface_hook = include("uniform float root_shade;\n" + HEAD + "\talbedo *= root_shade;\n}\n")})
	await ticks(2)
	assert_eq(listed(field), [])
	assert_greater(field.get_blade_count(), 0)


func test_presets_compile_in_every_field() -> void:
	for hook: String in ["snow", "wetness", "weather"]:
		var field := add_field({surface_hook = load(HOOKS + hook + ".gdshaderinc"), map = full_map(), snow = 1.0, wetness = 1.0})
		await ticks(2)
		assert_eq("hook/snow_color" in listed(field), hook != "wetness", hook)
		assert_eq("hook/wet_soil" in listed(field), hook != "snow", hook)
		assert_false("hook/other_light" in listed(field) or "hook/snow" in listed(field), "ours are not theirs")
		field.species = [GrassSpecies.new(), load("res://addons/grass_field/presets/wheat.tres")]
		await grown(field)
		assert_greater(listed(field).size(), 2, hook + " of a field with cards")
		field.free()

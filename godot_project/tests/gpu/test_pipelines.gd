# SPDX-License-Identifier: MIT
## Shaders and their pipelines are compiled in the background: the frame that first shows a change compiles none.
extends "res://tests/view_case.gd"

const HOOK := """
void grass_surface(in GrassSurface s, inout vec3 albedo, inout float roughness, inout vec3 emission) {
	albedo = vec3(1.0, %f, 0.0);
}
"""


## With the project's samples a pixel: the engine makes pipelines in advance for those only.
func before() -> void:
	super()
	viewport.msaa_3d = ProjectSettings.get_setting("rendering/anti_aliasing/quality/msaa_3d")


## Text that no shader of an earlier frame was made of.
func new_hook() -> ShaderInclude:
	var hook := ShaderInclude.new()
	hook.code = HOOK % (1e-6 * Engine.get_frames_drawn())
	return hook


## One text for the fields of several tests, which none else has: what these change is new. Kept by the tree: a static variable would keep
## scripts alive for ever.
func shared_hook() -> ShaderInclude:
	if not get_tree().has_meta("shared_hook"):
		get_tree().set_meta("shared_hook", new_hook())
	return get_tree().get_meta("shared_hook")


## Pipelines that the renderer began in frames, and those that loaders wait for.
func pipelines() -> Vector2i:
	var drawn_ones := RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_PIPELINE_COMPILATIONS_SURFACE)
	drawn_ones += RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_PIPELINE_COMPILATIONS_DRAW)
	return Vector2i(drawn_ones, RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_PIPELINE_COMPILATIONS_MESH))


## Changes the field, draws until that shows, and returns by how much pipelines() rose.
func pipelines_of(change: Callable) -> Vector2i:
	await drawn()
	var before := pipelines()
	change.call()
	await drawn()
	return pipelines() - before


func test_a_hook() -> void:
	var field := add_seen_field()
	add_light()
	await drawn()
	var found := await pipelines_of(func() -> void: field.surface_hook = shared_hook())
	assert_eq(found.x, 0, "none by drawing")
	assert_greater(found.y, 0)
	assert_greater(share_of(await picture(), is_red), 0.05, "it shows")


func test_a_map_and_species() -> void:
	add_light()
	var field := add_seen_field({surface_hook = shared_hook()})
	var map := GrassMap.new()
	map.base_density = 1.0
	for change: Callable in [func() -> void: field.map = map, func() -> void: field.species = [GrassSpecies.new(), GrassSpecies.new()]]:
		var found := await pipelines_of(change)
		assert_eq(found.x, 0, "none by drawing")
		assert_greater(found.y, 0)


func test_plants_with_a_mesh() -> void:
	add_light()
	var species := GrassSpecies.new()
	species.plant_mesh = BoxMesh.new()
	var field := add_seen_field({surface_hook = shared_hook()})
	var found := await pipelines_of(func() -> void: field.species = [species])
	assert_eq(found.x, 0, "none by drawing")
	assert_greater(field.get_counters().drawn_plants, 0)


## A field stands for scripts and bodies at once.
func test_a_new_field_is_drawn_when_its_shaders_are_there() -> void:
	add_light()
	await frames(3)
	var before := pipelines()
	var empty := await next_picture()
	var field := add_seen_field({surface_hook = new_hook()})
	await frames(1)
	assert_true(field.get_statistics().waiting, "its shaders are being made")
	assert_greater(field.get_blade_count(), 0, "it stands")
	if field.get_statistics().waiting:
		assert_less(difference(empty, await next_picture()).x, 0.01, "nothing is drawn with shaders of the engine's")
	assert_greater(share_of(await picture(), is_red), 0.05)
	assert_eq(pipelines().x - before.x, 0, "none by drawing")


func test_a_field_that_leaves_before_it_is_drawn() -> void:
	var field := add_seen_field({surface_hook = new_hook()})
	await frames(1)
	field.free()
	await frames(3)
	var next := add_seen_field()
	await drawn()
	assert_false(next.get_statistics().waiting)

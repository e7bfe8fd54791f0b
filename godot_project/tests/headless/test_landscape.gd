# SPDX-License-Identifier: MIT
## What surrounds the gallery and the presets: level in the middle, grass without gaps around it, hills and trees up to the horizon.
extends "res://tests/case.gd"

const Landscape := preload("res://demo/landscape.gd")
const MIDDLE := 20.0

var landscape: Landscape


func before() -> void:
	landscape = Landscape.new()
	add_child(landscape)
	landscape.make(MIDDLE, MIDDLE, true)


func after() -> void:
	landscape.free()


func test_the_middle_is_level_and_free() -> void:
	for x: float in [-10.0, 0.0, 10.0]:
		for z: float in [-10.0, 0.0, 10.0]:
			assert_near(landscape.hills.height_at(Vector3(x, 0, z)), 0.0, 0.001, "level")
	assert_eq(landscape.country.field_at(Vector3(5, 0, -9)), null, "no grass in the middle")


func test_grass_goes_on_to_the_rim() -> void:
	var half := 0.5 * Landscape.SIDE[true]
	for i in 16:
		for away: float in [1.45 * 0.5 * MIDDLE, 0.5 * half, 0.98 * half]:
			var way := Vector3.RIGHT.rotated(Vector3.UP, TAU * i / 16.0)
			assert_true(landscape.country.field_at(away * way) != null, "grass at %.0f m, %d" % [away, i])


func test_hills_and_trees_reach_the_horizon() -> void:
	var farthest := 0.0
	for look: MeshInstance3D in landscape.hills.find_children("*", "MeshInstance3D", true, false):
		farthest = maxf(farthest, look.get_aabb().end.x)
	assert_greater(farthest, 1500.0, "hills")
	assert_greater(landscape.trees.count, 50)
	var highest := 0.0
	for i in 64:
		highest = maxf(highest, landscape.hills.ground_at(Vector2.from_angle(TAU * i / 64.0) * 900.0))
	assert_greater(highest, 15.0, "hills rise behind the grass")


func test_hills_whiten() -> void:
	var look: MeshInstance3D = landscape.hills.find_children("*", "MeshInstance3D", true, false)[0]
	var material: ShaderMaterial = look.material_override
	assert_eq(material.get_shader_parameter("snow"), 0.0)
	landscape.set_weather(1.0, 0.0)
	assert_eq(material.get_shader_parameter("snow"), 1.0)
	assert_eq(landscape.country.fields[0].snow, 1.0)


func test_the_sun_reaches_the_groves_and_has_a_disc() -> void:
	var world := WorldEnvironment.new()
	world.environment = load("res://demo/day.tres")
	var sun := DirectionalLight3D.new()
	sun.light_energy = 2.0
	Landscape.open_sky(world, sun)
	assert_greater(sun.directional_shadow_max_distance, 200.0)
	assert_less(sun.directional_shadow_split_1 * sun.directional_shadow_max_distance, 8.0, "fine near shadows")
	assert_eq(sun.sky_mode, DirectionalLight3D.SKY_MODE_LIGHT_ONLY)
	var disc: DirectionalLight3D = sun.get_node(^"Disc")
	assert_eq(disc.sky_mode, DirectionalLight3D.SKY_MODE_SKY_ONLY, "it lights no grass")
	assert_greater(disc.light_energy, 2.0 * sun.light_energy)
	assert_true(world.environment != load("res://demo/day.tres"), "the file's stays as it is")
	world.free()
	sun.free()

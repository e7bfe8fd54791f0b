# SPDX-License-Identifier: MIT
## Grass and soil as they are drawn at the edges of baked ground.
extends "res://tests/view_case.gd"

const LedgeScene = preload("res://tests/ledge_scene.gd")


## Nothing is drawn before the face of a block: no blade that hangs, and no soil from its roof to the floor.
func test_no_curtain_hangs_before_a_wall() -> void:
	add_light()
	for offset: float in [0.0, 0.3, 0.62]:
		var level := Node3D.new()
		viewport.add_child(level)
		LedgeScene.add_box(level, Vector3(0, -0.5, 0), Vector3(30, 1, 30))
		LedgeScene.add_box(level, Vector3(0, 1.5, -3 + offset), Vector3(8, 3, 4))
		var face := StandardMaterial3D.new()
		face.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
		face.albedo_color = Color.WHITE
		for look_of: MeshInstance3D in level.find_children("*", "MeshInstance3D", true, false):
			look_of.material_override = face
		await ticks(2)
		var field := add_seen_field({size = Vector2(16, 16)})
		field.bake_ground()
		await grown(field)
		look(Vector3(0, 1.8, 4), Vector3(0, 1.8, -3))
		camera.fov = 20.0  # of the face what lies from 1.3 to 2.3 m above the floor
		var image := await picture()
		var seen_face := share_of(image, func(color: Color) -> bool: return minf(color.r, minf(color.g, color.b)) > 0.95)
		assert_near(seen_face, 1.0, 0.0, "offset %.2f" % offset)
		look(Vector3(0, 6, 6), Vector3(0, 2.6, -3 + offset))
		camera.fov = 10.0
		image = await picture()
		var green := share_of(image, func(color: Color) -> bool: return color.g > color.b + 0.05)
		assert_greater(green, 0.3, "grass stands on the roof")
		level.free()
		field.free()
		await ticks(2)


## A level as a designer makes it.
func test_a_level_with_edges() -> void:
	open_view(Vector2i(960, 540))
	add_light()
	var level := Node3D.new()
	viewport.add_child(level)
	LedgeScene.add_to(level, Vector2(0.37, 0.21), 0.3)
	await ticks(2)
	var field := add_seen_field({size = Vector2(26, 26)})
	field.bake_ground()
	await grown(field)
	look(Vector3(-3, 9, 17), Vector3(0, 0, 0))
	var image := await picture()
	var green := share_of(image, func(color: Color) -> bool: return color.g > color.b + 0.05)
	assert_greater(green, 0.2)


## Ground that only curves follows the terrain, though the same map has ledges where the terrain ends.
func test_a_terrain_does_not_show_through_its_soil() -> void:
	open_view(Vector2i(192, 108))
	add_light()
	var terrain: StaticBody3D = load("res://demo/terrain.gd").new()
	var noise := FastNoiseLite.new()
	noise.frequency = 0.06
	var red := StandardMaterial3D.new()
	red.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	red.albedo_color = Color.RED
	terrain.size = 32
	terrain.noise = noise
	terrain.relief = 4.0
	terrain.material = red
	viewport.add_child(terrain)
	var field := add_seen_field({size = Vector2(32, 32), density = 1.0, border_fade = 0.0})
	field.bake_ground_from(terrain.shape, terrain.global_transform)
	await grown(field)
	look(Vector3(0, 20, 0), Vector3.ZERO)
	camera.fov = 40.0  # without the terrain's border, where soil ends a little earlier
	var image := await picture()
	save(image, "soil_of_a_terrain")
	assert_near(share_of(image, is_red), 0.0, 0.0)

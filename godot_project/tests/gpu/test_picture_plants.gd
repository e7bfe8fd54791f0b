# SPDX-License-Identifier: MIT
## Colours and shadows of plants with a mesh, in every renderer: Forward+, Mobile, Compatibility.
extends "res://tests/species_case.gd"


## Returns a box whose material shows the colours of its vertices.
func painted_box(color: Color) -> ArrayMesh:
	var tool := SurfaceTool.new()
	var box := BoxMesh.new()
	box.size = Vector3(0.4, 1.0, 0.4)
	tool.append_from(box, 0, Transform3D(Basis(), Vector3(0, 0.5, 0)))
	var arrays := tool.commit_to_arrays()
	var colors := PackedColorArray()
	colors.resize((arrays[Mesh.ARRAY_VERTEX] as PackedVector3Array).size())
	colors.fill(color)
	arrays[Mesh.ARRAY_COLOR] = colors
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	var material := StandardMaterial3D.new()
	material.vertex_color_use_as_albedo = true
	mesh.surface_set_material(0, material)
	return mesh


func add_boxes(color: Color) -> GrassField:
	var species := make(1.0, Color(0.3, 0.6, 0.2), {length_min = 0.7, length_max = 0.7, plant_mesh = painted_box(color)})
	look(Vector3(0, 9, 5), Vector3.ZERO)
	return add_seen_field(
		{species = [species] as Array[GrassSpecies], size = Vector2(6, 6), density = 8.0, soil_enabled = false, border_fade = 0.0}
	)


## Share of the pixels in which a channel is by far the strongest: in the sky blue is 2.25 times the next.
func share_with(image: Image, channel: int) -> float:
	return share_of(
		image, func(color: Color) -> bool: return color[channel] > 2.5 * maxf(color[(channel + 1) % 3], color[(channel + 2) % 3])
	)


func test_plants_show_all_channels_of_their_vertices() -> void:
	for channel in 3:
		var color := Color(0.1, 0.1, 0.1)
		color[channel] = 0.8
		var field := add_boxes(color)
		var image := await picture()
		var shares := range(3).map(func(other: int) -> float: return share_with(image, other))
		print("    vertices strong in channel %d: shares of pixels strong in each %s" % [channel, shares])
		assert_greater(shares[channel], 0.05)
		for other in 3:
			if other != channel:
				assert_less(shares[other], 0.005, "channel %d" % other)
		field.free()


## Returns a thin green stem with a wide red head on the last fifth of its height.
func stem_with_head() -> ArrayMesh:
	var mesh := ArrayMesh.new()
	for part: Array in [[Vector3(0.03, 0.8, 0.03), 0.4, Color(0.1, 0.7, 0.1)], [Vector3(0.25, 0.2, 0.25), 0.9, Color(0.8, 0.1, 0.1)]]:
		var box := BoxMesh.new()
		box.size = part[0]
		var arrays := box.get_mesh_arrays()
		var places: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
		var colors := PackedColorArray()
		colors.resize(places.size())
		colors.fill(part[2])
		arrays[Mesh.ARRAY_VERTEX] = Transform3D(Basis(), Vector3(0, part[1], 0)) * places
		arrays[Mesh.ARRAY_COLOR] = colors
		mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
		var material := StandardMaterial3D.new()
		material.vertex_color_use_as_albedo = true
		mesh.surface_set_material(mesh.get_surface_count() - 1, material)
	return mesh


## Far away a plant is a blade; its head stays on top, in its own colour, and its stem green.
func test_a_far_plant_keeps_the_place_of_its_colours() -> void:
	var upright := {length_min = 1.0, length_max = 1.0, weight_upright = 1.0, weight_arched = 0.0, weight_drooping = 0.0, weight_wavy = 0.0}
	var species := make(1.0, Color(0.3, 0.6, 0.2), upright.merged({plant_mesh = stem_with_head(), plant_distance = 1.0}))
	look(Vector3(0, 0.5, 5), Vector3(0, 0.5, 0))
	var field := add_seen_field(
		{species = [species] as Array[GrassSpecies], size = Vector2(6, 1), density = 4.0, soil_enabled = false, border_fade = 0.0}
	)
	field.clump_height = 0.0
	field.clump_lean = 0.0
	var image := await picture()
	save(image, "far_plants")
	var half := Vector2i(image.get_width(), image.get_height() / 2)
	var above := image.get_region(Rect2i(Vector2i.ZERO, half))
	var below := image.get_region(Rect2i(Vector2i(0, half.y), half))
	print("    red above %.4f, below %.4f; green below %.4f" % [share_with(above, 0), share_with(below, 0), share_with(below, 1)])
	assert_greater(share_with(above, 0), 0.002)
	assert_less(share_with(below, 0), 0.05 * share_with(above, 0))
	assert_greater(share_with(below, 1), 0.005)

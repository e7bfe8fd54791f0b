# SPDX-License-Identifier: MIT
## Colours and shadows of plants with a mesh, in every renderer: Forward+, Mobile, Compatibility.
extends "res://tests/species_case.gd"


## A box whose material shows the colours of its vertices.
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
		{species = [species] as Array[GrassSpecies], size = Vector2(6, 6), density = 8.0, ground = false, border_fade = 0.0}
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
		await drawn()
		var image := await picture()
		var shares := range(3).map(func(other: int) -> float: return share_with(image, other))
		print("    vertices strong in channel %d: shares of pixels strong in each %s" % [channel, shares])
		assert_greater(shares[channel], 0.05)
		for other in 3:
			if other != channel:
				assert_less(shares[other], 0.005, "channel %d" % other)
		field.free()

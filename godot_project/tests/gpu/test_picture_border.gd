# SPDX-License-Identifier: MIT
## The border of a field: grass gets thinner and lower, soil has a soft edge. Runs in every renderer.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(192, 108)
const PIXEL := 0.02  # metres


## Straight from above, over a white floor.
func before() -> void:
	open_view(SIZE)
	add_light()
	var below := MeshInstance3D.new()
	below.mesh = PlaneMesh.new()
	below.mesh.size = Vector2(60, 60)
	var white := StandardMaterial3D.new()
	white.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	below.material_override = white
	viewport.add_child(below)
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = PIXEL * SIZE.y


## Mean luminance of each column.
func columns(image: Image) -> PackedFloat32Array:
	var means := PackedFloat32Array()
	for x in image.get_width():
		var sum := 0.0
		for y in image.get_height():
			sum += image.get_pixel(x, y).get_luminance()
		means.append(sum / image.get_height())
	return means


## Returns metres between where the first fifth and the last fifth of the way from grass to floor is done.
func width_of_border(image: Image) -> float:
	var means := columns(image)
	var inside := 0.0
	for x in 30:
		inside += means[x] / 30
	var from := means.size()
	var to := 0
	for x in means.size():
		var way := (means[x] - inside) / (means[-1] - inside)
		from = mini(from, x) if way > 0.2 else from
		to = x if way < 0.8 else to
	return maxi(to - from, 0) * PIXEL


func test_a_field_fades_at_its_border() -> void:
	var field := add_seen_field({size = Vector2(16, 16), clump_tint = 0.0})
	look(Vector3(7, 5, 0), Vector3(7, 0, 0))
	var widths := PackedFloat32Array()
	for fade: float in [0.0, 1.0, 2.0]:
		field.border_fade = fade
		var image := await picture()
		save(image, "border_%d" % fade)
		assert_greater(columns(image)[-1], 0.99, "floor outside")
		widths.append(width_of_border(image))
	print("    the border is %s m wide" % widths)
	assert_less(widths[0], 0.2)
	assert_greater(widths[1], 0.35)
	assert_greater(widths[2], 1.5 * widths[1])


## Returns how much farther out grass ends in one place than in another, metres.
func spread_of_border(image: Image, pixel: float) -> float:
	const ROWS := 6
	var least := INF
	var most := 0.0
	for y in range(0, image.get_height() - ROWS, ROWS):
		var means := columns(image.get_region(Rect2i(0, y, image.get_width(), ROWS)))
		var end := means.size() - 1
		while end > 0 and means[end] > 0.5 * (means[0] + means[-1]):
			end -= 1
		least = minf(least, end)
		most = maxf(most, end)
	return (most - least) * pixel


func test_a_border_wavers() -> void:
	const WIDE := 4.0  # times as much as the other pictures show
	var field := add_seen_field({size = Vector2(32, 32), clump_tint = 0.0, clump_lean = 0.0, border_fade = 2.0})
	camera.size *= WIDE
	look(Vector3(13, 5, 0), Vector3(13, 0, 0))
	var spreads := PackedFloat32Array()
	for waver: float in [0.0, 1.0]:
		field.border_waver = waver
		var image := await picture()
		save(image, "waver_%d" % waver)
		spreads.append(spread_of_border(image, WIDE * PIXEL))
	print("    grass ends within %s m" % spreads)
	assert_less(spreads[0], 0.7)
	assert_greater(spreads[1], spreads[0] + 0.5)


## Blades hide most of the soil, so here are hardly any.
func test_the_soil_has_a_soft_edge() -> void:
	var map := GrassMap.new()
	map.stroke(brush(GrassBrush.TOOL_PAINT, 1.0), Vector2(7, -4), Vector2(7, 4))
	var field := add_seen_field({size = Vector2(32, 32), density = 1.0, map = map, root_shade = 0.0, border_fade = 0.1})
	await grown(field)
	look(Vector3(7.8, 5, 0), Vector3(7.8, 0, 0))
	var painted := await picture()
	field.map = null
	await grown(field)
	look(Vector3(15, 5, 0), Vector3(15, 0, 0))
	for picture: Array in [["painted", painted], ["own", await picture()]]:
		var image: Image = picture[1]
		save(image, "soil_" + picture[0])
		var between := share_of(image, func(color: Color) -> bool: return absf(color.get_luminance() - 0.6) < 0.2)
		print("    %s border: %.3f of the pixels are neither soil nor floor" % [picture[0], between])
		assert_greater(share_of(image, func(color: Color) -> bool: return color.get_luminance() > 0.95), 0.1, "floor")
		assert_greater(share_of(image, func(color: Color) -> bool: return color.get_luminance() < 0.4), 0.1, "soil")
		assert_greater(between, 0.02)


## Two fields side by side: no floor shows between their soils.
func test_no_gap_between_adjoining_fields() -> void:
	for side: float in [-8.0, 8.0]:
		var field := add_seen_field({size = Vector2(16, 16), density = 1.0, border_fade = 0.0, root_shade = 0.0})
		field.position.x = side
	look(Vector3(0, 5, 0), Vector3.ZERO)
	var image := await picture()
	save(image, "soil_seam")
	var means := columns(image)
	var lightest := 0.0
	for x in range(SIZE.x / 2 - 20, SIZE.x / 2 + 20):
		lightest = maxf(lightest, means[x])
	assert_less(means[10], 0.7, "soil, over a white floor")
	print("    the lightest column at the seam has %.3f, one inside %.3f" % [lightest, means[10]])
	assert_less(lightest, means[10] + 0.1)


## The same on hills: a large field's sheet has coarser cells, so its edge runs above and below that of a small one.
func test_no_gap_between_adjoining_fields_on_hills() -> void:
	for wide: float in [16.0, 512.0]:
		var heights := Image.create_empty(65, 65, false, Image.FORMAT_RF)
		for z in 65:
			for x in 65:
				heights.set_pixel(x, z, Color(2.0 + 0.4 * sin(0.7 * z), 0, 0))
		var map := GrassMap.new()
		map.base_density = 1.0
		map.set_ground(heights, Rect2(-16.25, -16.25, 32.5, 32.5) if wide < 100.0 else Rect2(-272.25, -16.25, 32.5, 32.5))
		var looks := {
			size = Vector2(wide, 32), map = map, density = 1.0, border_fade = 0.0, root_shade = 0.0, soil_color = Color(0.1, 0.1, 0.1)
		}
		var field := add_seen_field(looks)
		field.position.x = 0.5 * wide if wide > 100.0 else -0.5 * wide
		await grown(field)
	camera.projection = Camera3D.PROJECTION_PERSPECTIVE
	camera.fov = 40.0
	for side: float in [-1.0, 1.0]:
		look(Vector3(3.0 * side, 4.5, 3), Vector3(0, 2, 0))
		var image := await picture()
		save(image, "soil_seam_on_hills_%d" % side)
		var lights := share_of(image, func(color: Color) -> bool: return color.b > 0.6)
		print("    %.4f of the pixels show the floor through the seam, seen from %.0f" % [lights, side])
		assert_eq(lights, 0.0, "no floor between the sheets")

# SPDX-License-Identifier: MIT
## Level of detail without a pop: a slow flight over a field is compared, frame by frame, with the same flight at full detail.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(192, 108)
const FLIGHT_SIZE := Vector2i(96, 108)  # many pictures: narrow ones
const BLOCK := 12  # pixels a side: a jump of one tile is lost in the mean of a whole picture, not in that of a block
const STEPS := 24
const STEP := 0.002  # metres a frame
const FULL := {pixels_min = 0.0, lod_error = 0.0, lod_far = 10000.0}
const LIMIT := 1.5  # of the difference at full detail


func before() -> void:
	open_view(SIZE, 4)  # single pixels of thin blades flicker, which would hide a jump
	add_light()


## Mean difference of two pictures, and the greatest mean of a block, 0..1.
func change(a: Image, b: Image) -> Vector2:
	var blocks := FLIGHT_SIZE / BLOCK
	a.convert(Image.FORMAT_RGB8)
	b.convert(Image.FORMAT_RGB8)
	var sums := PackedFloat32Array()
	sums.resize(blocks.x * blocks.y)
	var one := a.get_data()
	var other := b.get_data()
	for y in FLIGHT_SIZE.y:
		for x in FLIGHT_SIZE.x:
			var at := 3 * (x + FLIGHT_SIZE.x * y)
			sums[x / BLOCK + blocks.x * (y / BLOCK)] += (
				absf(one[at] - other[at]) + absf(one[at + 1] - other[at + 1]) + absf(one[at + 2] - other[at + 2])
			)
	var sum := 0.0
	var most := 0.0
	for block in sums:
		sum += block
		most = maxf(most, block)
	return Vector2(sum / (FLIGHT_SIZE.x * FLIGHT_SIZE.y), most / (BLOCK * BLOCK)) / (3.0 * 255.0)


## Changes from frame to frame of a flight over the field, or of the two steps in the middle of it. `at_half` is called there.
func fly(at_half := Callable()) -> PackedVector2Array:
	var changes := PackedVector2Array()
	var last: Image = null
	for i in range(STEPS / 2 - 1, STEPS / 2 + 2) if at_half.is_valid() else range(STEPS + 1):
		look(Vector3(0.3, 0.9, 4.4 - STEP * i), Vector3(0.2, 0.0, 1.2 - STEP * i))
		if i == STEPS / 2 and at_half.is_valid():
			at_half.call()
		if not last:
			await ready_for_picture()
		var now := await next_picture()
		if last:
			changes.append(change(last, now))
		last = now
	return changes


func greatest(changes: PackedVector2Array) -> Vector2:
	var most := Vector2.ZERO
	for one in changes:
		most = most.max(one)
	return most


func test_a_slow_flight_shows_no_jump() -> void:
	viewport.size = viewport.size * FLIGHT_SIZE / SIZE
	picture_size = FLIGHT_SIZE
	var field := add_seen_field({size = Vector2(8, 8)})
	var coarse := await fly()
	var drawn_coarse: int = field.get_statistics().drawn_triangles
	var jumping := await fly(func() -> void: field.pixels_min = 3.0)
	for property: String in FULL:
		field.set(property, FULL[property])
	var full := await fly()
	await drawn()
	var most := greatest(full)
	print(
		(
			"    greatest change: full detail %.4f (block %.4f), with level of detail %.4f (%.4f), %d of %d triangles; with a jump %.4f (%.4f)"
			% [
				most.x,
				most.y,
				greatest(coarse).x,
				greatest(coarse).y,
				drawn_coarse,
				field.get_statistics().drawn_triangles,
				greatest(jumping).x,
				greatest(jumping).y
			]
		)
	)
	assert_less(drawn_coarse, field.get_statistics().drawn_triangles / 4.0, "there is a level of detail to be seen")
	for i in full.size():
		assert_less(coarse[i].x, LIMIT * full[i].x, "frame %d" % i)
		assert_less(coarse[i].y, LIMIT * most.y, "a block of frame %d" % i)
	assert_greater(greatest(jumping).x, LIMIT * most.x, "a jump would be seen")


## Blades that are fewer and wider cover as much: the ground shows through as much as at full detail.
func test_thinned_grass_covers_as_much() -> void:
	var field := add_seen_field({size = Vector2(8, 8), soil_enabled = false})
	for view: Array in [[Vector3(0, 1.2, 3.8), Vector3(0, 0, 0)], [Vector3(0, 5, 0.1), Vector3(0, 0, 0)]]:
		for property: String in FULL:
			field.set(property, FULL[property])
		look(view[0], view[1])
		var full := share_of(await picture(), is_green)
		for property: String in FULL:
			field.set(property, ClassDB.class_get_property_default_value("GrassField", property))
		await drawn()
		var thinned := share_of(await next_picture(), is_green)
		print(
			(
				"    from %s: %.3f green at full detail, %.3f with %d of %d blades"
				% [view[0], full, thinned, field.get_statistics().drawn_blades, field.get_blade_count()]
			)
		)
		assert_near(thinned, full, 0.1 * full, "from %s" % view[0])


## Rows of a mesh slide together before the next coarser mesh takes its place: no step from fine to coarse shows much of the whole change.
func test_meshes_change_by_sliding() -> void:
	open_view(SIZE)
	viewport.msaa_3d = Viewport.MSAA_4X
	add_light()
	var field := add_seen_field({size = Vector2(0.5, 0.5), soil_enabled = false, pixels_min = 0.0, lod_far = 10000.0, lod_error = 0.1})
	look(Vector3(0, 0.4, 1.1), Vector3(0, 0.25, 0))
	var last := await picture()
	var triangles: int = field.get_statistics().drawn_triangles
	var sum := 0.0
	var most := 0.0
	for i in range(1, 31):
		field.lod_error = 0.1 * pow(1.157, i)  # to 8 pixels
		await frames(1)
		var now := await next_picture()
		var changed := difference(last, now).y
		sum += changed
		most = maxf(most, changed)
		last = now
	await drawn()
	var left: int = field.get_statistics().drawn_triangles
	print("    %d triangles become %d; the greatest of 30 steps is %.2f of the change" % [triangles, left, most / sum])
	assert_less(left, triangles / 15.0)
	assert_less(most, 0.2 * sum)


## Mean of red, green and blue over some rows, linear.
func light_of(image: Image, rows: Vector2i) -> Vector3:
	var sum := Vector3.ZERO
	for y in range(rows.x, rows.y):
		for x in SIZE.x:
			var color := image.get_pixel(x, y).srgb_to_linear()
			sum += Vector3(color.r, color.g, color.b)
	return sum / (SIZE.x * (rows.y - rows.x))


## A low eye sees a fraction of the far blades; the others are not drawn, and nobody misses them.
func test_what_other_grass_hides_is_not_missed() -> void:
	var field := add_seen_field({size = Vector2(48, 48), density = 64.0})
	look(Vector3(0, 0.9, 23), Vector3(0, 0.2, -23))
	await drawn()
	var thinned := await next_picture()
	var drawn_blades: int = field.get_statistics().drawn_blades
	for property: String in FULL:
		field.set(property, FULL[property])
	await drawn()
	var full := await next_picture()
	assert_less(drawn_blades, 0.2 * field.get_statistics().drawn_blades, "most are not drawn")
	var horizon := 0  # the first row of the grass
	while is_green(full.get_pixel(SIZE.x / 2, horizon)) == false and horizon < SIZE.y - 1:
		horizon += 1
	for band: Vector2i in [Vector2i(1, 5), Vector2i(5, 12), Vector2i(12, 30)]:
		var rows := band + Vector2i(horizon, horizon)
		var one := light_of(thinned, rows)
		var other := light_of(full, rows)
		print("    rows %s: %s, and %s with all %d of %d blades" % [rows, one, other, field.get_statistics().drawn_blades, drawn_blades])
		assert_near(one.y, other.y, 0.1 * other.y, "as light in rows %s" % rows)


## One tile from the side, ever fewer of its blades: each shrinks before it is gone.
func test_blades_fade_by_shrinking() -> void:
	var field := add_seen_field({size = Vector2(0.5, 0.5), soil_enabled = false, pixels_min = 0.0, lod_error = 0.0, thin_widening = 0.0})
	camera.fov = 15.2  # 0.8 m at a distance of 3 m
	look(Vector3(0, 0.35, 3), Vector3(0, 0.35, 0))
	field.hide()
	var empty := await picture()
	field.show()
	var covered := PackedFloat32Array()  # in units of a blade's contrast to the sky
	for i in 25:
		var share := (14.0 - 0.25 * i) / 64.0
		field.lod_far = 7.0 * (3.0 - camera.near) / (8.0 * (1.0 - share))  # [Eq L1]
		covered.append(difference(await picture(), empty).y)
	var blade := 0.0  # the most that a whole blade covers
	var step := 0.0  # the most that a quarter of one does
	for i in range(4, covered.size()):
		blade = maxf(blade, covered[i - 4] - covered[i])
		step = maxf(step, covered[i - 1] - covered[i])
		assert_true(covered[i] < covered[i - 1] + 1e-4, "step %d: no blade grows" % i)
	print("    14 blades cover %.4f, 8 %.4f; a whole one up to %.4f, a quarter up to %.4f" % [covered[0], covered[24], blade, step])
	assert_less(covered[24], 0.8 * covered[0], "blades have gone")
	assert_less(step, 0.65 * blade, "a quarter of a blade")


## A blade right before the eye gets narrow, so that it neither fills the picture nor is cut by the near plane.
func test_a_blade_right_before_the_eye_gets_narrow() -> void:
	var field := add_seen_field({size = Vector2(8, 8), density = 1.0, soil_enabled = false, wind_speed = 0.0})
	await drawn()
	var tile := field.get_tile_at(Vector3.ZERO)
	var knots := field.get_tile_knots(tile)
	var point: Vector3 = knots[7]  # the middle of the first blade
	var shares := {}
	for distance: float in [0.06, 0.3]:
		look(point + Vector3(0, 0, distance), point)
		shares[distance] = share_of((await picture()).get_region(Rect2i(0, SIZE.y / 3, SIZE.x, SIZE.y / 3)), is_green)
	print("    from 6 cm it fills %.4f of the picture, from 30 cm %.4f" % [shares[0.06], shares[0.3]])
	assert_greater(shares[0.3], 0.003, "it is there")
	assert_less(shares[0.06], 2.0 * shares[0.3], "five times as near it is no wider")

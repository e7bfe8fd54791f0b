# SPDX-License-Identifier: MIT
## Rough terrain: a field's ground is that of the terrain's own cells, wherever the field lies on them.
extends "res://tests/hill_case.gd"

const CELLS := 64
const PLACES := 20000

var noise := FastNoiseLite.new()  # the engine's defaults: five octaves


func _init() -> void:
	noise.frequency = 0.02


func vertex(x: int, z: int) -> Vector3:
	return Vector3(x - CELLS / 2, 5.0 * noise.get_noise_2d(x, z), z - CELLS / 2)


## Returns the height of the terrain at a place: its cells' common edges join (x + 1, z) and (x, z + 1).
func height_at(place: Vector2) -> float:
	var corner := (place + Vector2.ONE * CELLS / 2).floor()
	var t := place + Vector2.ONE * CELLS / 2 - corner
	var here := vertex(int(corner.x), int(corner.y)).y
	var along_x := vertex(int(corner.x) + 1, int(corner.y)).y
	var along_z := vertex(int(corner.x), int(corner.y) + 1).y
	var across := vertex(int(corner.x) + 1, int(corner.y) + 1).y
	if t.x + t.y < 1.0:
		return here + t.x * (along_x - here) + t.y * (along_z - here)
	return across + (1.0 - t.x) * (along_z - across) + (1.0 - t.y) * (along_x - across)


func height_map() -> HeightMapShape3D:
	var heights := PackedFloat32Array()
	for z in CELLS + 1:
		for x in CELLS + 1:
			heights.append(vertex(x, z).y)
	var shape := HeightMapShape3D.new()
	shape.map_width = CELLS + 1
	shape.map_depth = CELLS + 1
	shape.map_data = heights
	return shape


func trimesh() -> ConcavePolygonShape3D:
	var faces := PackedVector3Array()
	for z in CELLS:
		for x in CELLS:
			for corner: Vector2i in [Vector2i(0, 0), Vector2i(1, 0), Vector2i(0, 1), Vector2i(1, 0), Vector2i(1, 1), Vector2i(0, 1)]:
				faces.append(vertex(x + corner.x, z + corner.y))
	var shape := ConcavePolygonShape3D.new()
	shape.set_faces(faces)
	return shape


## Returns the share of places where the field's ground is more than 2 cm off the terrain.
func share_off(field: GrassField) -> float:
	var random := RandomNumberGenerator.new()
	random.seed = 5
	var count := 0
	var most := 0.0
	for n in PLACES:
		var half := 0.5 * field.size
		var place := Vector2(random.randf_range(-half.x, half.x), random.randf_range(-half.y, half.y))
		var there := field.to_global(Vector3(place.x, 0, place.y))
		var off := absf(field.global_position.y + field.map.sample(GrassMap.CHANNEL_GROUND, place) - height_at(Vector2(there.x, there.z)))
		most = maxf(most, off)
		count += 1 if off > 0.02 else 0
	print("    %.2f %% of the places are more than 2 cm off; at most %.1f cm" % [100.0 * count / PLACES, 100.0 * most])
	return float(count) / PLACES


func test_rays_find_the_cells_of_a_height_map() -> void:
	add_body(StaticBody3D.new(), height_map(), Vector3.ZERO)
	await ticks(2)
	var field := add_field({size = Vector2(40, 40)})
	field.bake_ground()
	assert_less(share_off(field), 0.001)
	field.position = Vector3(3.3, 0.5, -2.15)
	field.rotation.y = PI / 2
	field.bake_ground()
	assert_less(share_off(field), 0.001, "moved and turned")


func test_rays_find_the_cells_of_a_trimesh() -> void:
	var body := add_body(StaticBody3D.new(), trimesh(), Vector3.ZERO)
	var rock := BoxShape3D.new()
	add_body(StaticBody3D.new(), rock, Vector3(2, -30, 0))
	await ticks(2)
	var field := add_field({size = Vector2(CELLS, CELLS)})  # up to the terrain's border
	field.bake_ground()
	assert_less(share_off(field), 0.001)
	body.free()


func test_a_shape_without_a_body() -> void:
	for shape: Shape3D in [height_map(), trimesh()]:
		var field := add_field({size = Vector2(40, 30), position = Vector3(-0.4, 1, 0.7)})
		field.bake_ground_from(shape, Transform3D())
		assert_less(share_off(field), 0.001)


func test_a_part_is_baked_as_the_rest_was() -> void:
	add_body(StaticBody3D.new(), height_map(), Vector3.ZERO)
	await ticks(2)
	var field := add_field({size = Vector2(40, 40)})
	field.bake_ground()
	var before := field.map.take_snapshot()
	field.position.x = 0.3  # the part has its cells elsewhere than the map
	field.bake_ground(Rect2(-5, -5, 10, 10))
	var kept := field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(-15, 12))
	assert_near(kept, height_at(Vector2(-15, 12)), 0.002, "what is not baked stays where it was")
	field.map.restore_snapshot(before)
	field.position.x = 0.0
	assert_less(share_off(field), 0.001, "undone")


## Ledges would make the soil a split sheet, and all shaders look for them.
func test_a_terrain_that_ends_with_its_field_has_no_ledges() -> void:
	add_body(StaticBody3D.new(), height_map(), Vector3.ZERO)
	await ticks(2)
	var field := add_field({size = Vector2(CELLS, CELLS)})
	for bake: Callable in [field.bake_ground, field.bake_ground_from.bind(height_map(), Transform3D.IDENTITY)]:
		field.map = GrassMap.new()
		assert_greater(bake.call(), CELLS * CELLS)
		var none := field.map.sample(GrassMap.CHANNEL_LEDGE, Vector2.ZERO)
		var ledges := 0
		for i in range(-8 * CELLS / 2 - 4, 8 * CELLS / 2 + 4):  # a ledge is kept in eighths of a metre
			for side: float in [-0.5, 0.5]:
				for beyond: float in [-0.3, 0.3]:
					var out := side * CELLS + beyond
					ledges += int(field.map.sample(GrassMap.CHANNEL_LEDGE, Vector2(i / 8.0, out)) != none)
					ledges += int(field.map.sample(GrassMap.CHANNEL_LEDGE, Vector2(out, i / 8.0)) != none)
		assert_eq(ledges, 0, "ledges, with %s" % bake)
		assert_less(share_off(field), 0.001)

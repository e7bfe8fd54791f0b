# SPDX-License-Identifier: MIT
## Shapes of bodies: each kind pushes blades out of itself, and the field follows every change of them at run time.
extends "res://tests/field_case.gd"

const TOLERANCE := 1e-3  # metres that a knot may lie inside of a shape
const ABOVE := Vector3(0, 0.34, 0)  # of a shape about 0.3 m thick, so that most roots are outside of it


func capsule(radius: float, height: float) -> CapsuleShape3D:
	var shape := CapsuleShape3D.new()
	shape.radius = radius
	shape.height = height
	return shape


func cylinder(radius: float, height: float) -> CylinderShape3D:
	var shape := CylinderShape3D.new()
	shape.radius = radius
	shape.height = height
	return shape


## Eight faces, `radius` from the middle to each of the six corners.
func octahedron(radius: float) -> ConvexPolygonShape3D:
	var shape := ConvexPolygonShape3D.new()
	var corners := PackedVector3Array()
	for axis: Vector3 in [Vector3.RIGHT, Vector3.UP, Vector3.BACK]:
		corners.append_array([axis * radius, -axis * radius])
	shape.points = corners
	return shape


## Returns how deep `point`, in the shape's space, lies inside of it, metres; negative outside.
func depth(shape: Shape3D, point: Vector3) -> float:
	var across := Vector2(point.x, point.z).length()
	if shape is SphereShape3D:
		return shape.radius - point.length()
	if shape is CapsuleShape3D:
		var half: float = 0.5 * shape.height - shape.radius
		return shape.radius - point.distance_to(Vector3(0, clampf(point.y, -half, half), 0))
	if shape is CylinderShape3D:
		return minf(0.5 * shape.height - absf(point.y), shape.radius - across)
	if shape is BoxShape3D:
		var room: Vector3 = 0.5 * shape.size - point.abs()
		return minf(room.x, minf(room.y, room.z))
	return (shape.points[0].length() - absf(point.x) - absf(point.y) - absf(point.z)) / sqrt(3.0)


## Returns the deepest that `point` lies in any shape of the body.
func depth_in(body: PhysicsBody3D, point: Vector3) -> float:
	var deepest := -INF
	for shape: CollisionShape3D in body.find_children("*", "CollisionShape3D", true, false):
		deepest = maxf(deepest, depth(shape.shape, shape.global_transform.affine_inverse() * point))
	return deepest


## Returns the deepest that a free knot lies in the body, over all blades whose root does not; and how far blades were bent.
func measure(field: GrassField, body: PhysicsBody3D, rest: Dictionary[Vector2i, PackedVector3Array]) -> Dictionary:
	var result := {deepest = -INF, bent = 0.0, deepest_at_rest = -INF}
	for tile in rest:
		var knots := tile_knots(field, tile)
		result.bent = maxf(result.bent, farthest(knots, rest[tile]))
		for blade in BLADES:
			var first := blade * KNOTS
			if depth_in(body, knots[first]) > -0.05 or depth_in(body, knots[first + 1]) > -0.05:
				continue
			for k in range(first + CLAMPED, first + KNOTS):
				result.deepest = maxf(result.deepest, depth_in(body, knots[k]))
				result.deepest_at_rest = maxf(result.deepest_at_rest, depth_in(body, rest[tile][k]))
	return result


func hold(shapes: Array[Shape3D], places: Array[Transform3D], turn: Vector3, label: String) -> void:
	var field := add_field({size = Vector2(3, 3)})
	await ticks(2)
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	for i in shapes.size():
		add_shape(body, shapes[i], places[i])
	body.rotation = turn
	add_body(body, null, ABOVE)
	await ticks(2)
	var none: Array[Vector2i] = []
	var rest := knots_of(field, none)
	await ticks(25)
	var awake := awake_tiles(field)
	body.position.y += 50
	# Another field of the same seed tells where the blades were at rest.
	var still := add_field({size = Vector2(3, 3), simulated = false})
	await ticks(2)
	rest = knots_of(still, awake)
	body.position.y -= 50
	await ticks(40)
	var found := measure(field, body, rest)
	assert_greater(found.deepest_at_rest, 0.05, "blades grow through where it is: " + label)
	assert_greater(found.bent, 0.05, label)
	assert_less(found.deepest, TOLERANCE, "knot inside: " + label)
	body.free()
	field.free()
	still.free()
	await ticks(2)


func test_no_knot_inside_round_shapes() -> void:
	for turn: Vector3 in [Vector3.ZERO, Vector3(1.2, 0.4, 0.3)]:
		for shape: Shape3D in [ball(0.25), capsule(0.2, 0.6), cylinder(0.25, 0.4)]:
			await hold([shape], [Transform3D()], turn, "%s turned %s" % [shape.get_class(), turn])


func test_no_knot_inside_shapes_with_faces() -> void:
	for turn: Vector3 in [Vector3.ZERO, Vector3(1.2, 0.4, 0.3)]:
		for shape: Shape3D in [box(Vector3(0.5, 0.4, 0.6)), octahedron(0.3)]:
			await hold([shape], [Transform3D()], turn, "%s turned %s" % [shape.get_class(), turn])


func test_no_knot_inside_several_offset_and_turned_shapes() -> void:
	var left := Transform3D(Basis.from_euler(Vector3(0, 0, 1.0)), Vector3(-0.45, 0, 0.1))
	var right := Transform3D(Basis.from_euler(Vector3(0.7, 0, 0)), Vector3(0.45, 0.05, -0.1))
	await hold([box(Vector3(0.3, 0.3, 0.3)), ball(0.2)], [left, right], Vector3.ZERO, "two shapes")
	await hold([box(Vector3(0.3, 0.3, 0.3)), cylinder(0.15, 0.3)], [left, right], Vector3(0.2, 0.8, 0), "two shapes, turned")


func test_shapes_are_added_and_removed() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), Vector3(-1, 0.25, 0))
	assert_eq(await collider_count(field), 1)
	var second := add_shape(body, box(Vector3(0.3, 0.3, 0.3)), Transform3D(Basis(), Vector3(2, 0, 0)))
	assert_eq(await collider_count(field), 2)
	assert_true(field.is_tile_awake(field.get_tile_at(Vector3(1, 0, 0))))
	var third := add_shape(body, capsule(0.1, 0.4), Transform3D(Basis(), Vector3(1, 0, 1)))
	assert_eq(await collider_count(field), 3)
	second.free()  # the third shape's index changes
	assert_eq(await collider_count(field), 2)
	body.get_child(0).free()
	assert_eq(await collider_count(field), 1)
	assert_true(field.is_tile_awake(field.get_tile_at(Vector3(0, 0, 1))))
	third.free()
	assert_eq(await collider_count(field), 0)
	add_shape(body, ball(0.2))
	assert_eq(await collider_count(field), 1)


func test_shapes_are_disabled_and_enabled() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), Vector3(-1, 0.25, 0))
	var second := add_shape(body, ball(0.2), Transform3D(Basis(), Vector3(2, 0, 0)))
	assert_eq(await collider_count(field), 2)
	body.get_child(0).disabled = true
	assert_eq(await collider_count(field), 1, "the first is disabled")
	second.disabled = true
	assert_eq(await collider_count(field), 0, "both are disabled")
	body.get_child(0).disabled = false
	assert_eq(await collider_count(field), 1, "the first is enabled")
	second.disabled = false
	assert_eq(await collider_count(field), 2, "both are enabled")


## Returns blades that a knot of is as near to the body's place as `radius`.
func blades_within(field: GrassField, place: Vector3, radius: float) -> int:
	var count := 0
	for tile in awake_tiles(field):
		for blade in BLADES:
			for knot in field.get_knots(tile, blade).slice(CLAMPED):
				if knot.distance_to(place) < radius:
					count += 1
					break
	return count


func test_shapes_are_swapped_resized_and_moved() -> void:
	var field := add_field()
	var place := Vector3(0.25, 0.34, 0.25)
	var body := add_held_body(ball(0.1), place)
	var shape: CollisionShape3D = body.get_child(0)
	await ticks(10)
	assert_greater(blades_within(field, place, 0.25), 10, "a small ball leaves blades near it")
	shape.shape.radius = 0.25
	await ticks(60)
	assert_eq(blades_within(field, place, 0.245), 0, "grown in place")
	shape.shape = ball(0.1)
	await ticks(90)
	assert_greater(blades_within(field, place, 0.245), 10, "swapped for a small one")
	shape.shape = box(Vector3(0.5, 0.5, 0.5))
	await ticks(60)
	assert_eq(blades_within(field, place, 0.245), 0, "swapped for a box of the same reach")
	shape.position.x = 1.2
	await ticks(60)
	assert_eq(blades_within(field, place + Vector3(1.2, 0, 0), 0.245), 0, "moved within the body")
	shape.shape = null
	assert_eq(await collider_count(field), 0, "no shape at all")


func test_odd_sizes_do_no_harm() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), Vector3(0, 0.25, 0))
	var shape: CollisionShape3D = body.get_child(0)
	for odd: Shape3D in [
		ball(1e-6),
		ball(1000.0),
		capsule(0.2, 0.4),
		cylinder(0.001, 5.0),
		box(Vector3(1e-5, 1, 1)),
		box(Vector3(500, 500, 500)),
		octahedron(0.01)
	]:
		shape.shape = odd
		await seen()
		assert_true(all_finite(field, awake_tiles(field)), "%s" % odd)


## A CollisionShape3D that is scaled meets grass at the size it has.
func test_scaled_shapes_bend_at_their_scaled_size() -> void:
	var awake: Array[int] = []
	for scale_by: float in [1.0, 3.0]:
		var field := GrassField.new()
		field.size = Vector2(8.0, 8.0)
		add_child(field)
		var body := AnimatableBody3D.new()
		var shape := CollisionShape3D.new()
		shape.shape = BoxShape3D.new()
		shape.shape.size = Vector3.ONE * 0.5
		shape.scale = Vector3.ONE * scale_by
		body.add_child(shape)
		body.position.y = 0.25 * scale_by
		add_child(body)
		await ticks(10)
		awake.append(field.get_awake_tile_count())
		body.free()
		field.free()
	assert_greater(awake[0], 0)
	assert_greater(awake[1], 1.5 * awake[0], "awake tiles %s" % [awake])

# SPDX-License-Identifier: MIT
## A scene whose blades are known bit for bit: species, a painted map, bodies of all shapes, two seconds on the CPU. A change that should
## not affect results keeps the hashes; one that should records new ones.
extends "res://tests/field_case.gd"

const EVERY := 30  # ticks from one look to the next
## Of each method, at each look: a hash of all awake tiles and their knots.
const GOLDEN: Dictionary[int, Array] = {
	GrassField.METHOD_DIRECT: ["3277c5f7a23d91d4", "2a80ec3de4ba2b93", "668b0996f48b85dc", "429a01fc4a0756c9"],
	GrassField.METHOD_PBD: ["aa1af9b677faa7a8", "f6f45cdc878d7b68", "9f1629d026f779b4", "7b48f72c883cd751"],
}
# Numbers of the 3-4-5 triangle: no sine, whose last bit differs between processors.
const TURNED := Basis(Vector3(0.6, 0, -0.8), Vector3.UP, Vector3(0.8, 0, 0.6))
const TILTED := Basis(Vector3(0.6, 0.8, 0), Vector3(-0.8, 0.6, 0), Vector3.BACK)


func shapes() -> Array[Shape3D]:
	var capsule := CapsuleShape3D.new()
	capsule.radius = 0.125
	capsule.height = 0.75
	var cylinder := CylinderShape3D.new()
	cylinder.radius = 0.25
	cylinder.height = 0.25
	var hull := ConvexPolygonShape3D.new()
	var corners := PackedVector3Array()
	for axis: Vector3 in [Vector3.RIGHT, Vector3.UP, Vector3.BACK]:
		corners.append_array([0.25 * axis, -0.25 * axis])
	hull.points = corners
	return [ball(0.25), capsule, box(Vector3(0.5, 0.25, 0.375)), cylinder, hull]


func species(share: float, frequency: float) -> GrassSpecies:
	var made := GrassSpecies.new()
	made.share = share
	made.natural_frequency = frequency
	return made


## A field that lies aslant in the world, painted all over: thin, high, combed and mown places, a hill.
func add_painted_field(method: GrassField.SolverMethod) -> GrassField:
	var field := add_field(
		{
			size = Vector2(10, 8),
			transform = Transform3D(TURNED, Vector3(8, 1, -4)),
			backend = GrassField.BACKEND_CPU,
			method = method,
			seed = 7,
			map = full_map(),
			species = [species(0.75, 1.25), species(0.25, 2.0)],
			density = 200.0,
			follow_slope = 1.0,
			sleep_mode = GrassField.SLEEP_TIMER,
			sleep_delay = 0.5,
			settle_time = 0.25,
		}
	)
	for stroke: Array in [
		[GrassBrush.TOOL_ERASE, -2.0, {strength = 0.5}],
		[GrassBrush.TOOL_HEIGHT, -1.0, {target = 0.5}],
		[GrassBrush.TOOL_COMB, 0.0, {}],
		[GrassBrush.TOOL_CUT, 1.0, {cut_height = 0.125}],
		[GrassBrush.TOOL_SPECIES, 2.0, {species = 1}],
	]:
		var from := field.transform * Vector3(1.5 * stroke[1], 0, -3.5)
		field.paint(brush(stroke[0], 0.5, stroke[2]), from, from + field.transform.basis.z * 7.0)
	var hill := ConcavePolygonShape3D.new()
	(
		hill
		. set_faces(
			PackedVector3Array(
				[
					Vector3(-6, 0, -5),
					Vector3(6, 0.5, -5),
					Vector3(-6, 0, 5),
					Vector3(6, 0.5, -5),
					Vector3(6, 0.75, 5),
					Vector3(-6, 0, 5),
				]
			)
		)
	)
	field.bake_ground_from(hill, field.transform)
	return field


func hash_of(field: GrassField) -> String:
	var context := HashingContext.new()
	context.start(HashingContext.HASH_SHA256)
	for tile in awake_tiles(field):
		context.update(PackedInt32Array([tile.x, tile.y]).to_byte_array())
		context.update(field.get_tile_knots(tile).to_byte_array())
	return context.finish().hex_encode().left(16)


## Bodies that cross the field side by side, one that turns, a node without physics between them; then all stop, and grass rises.
func looks_of(method: GrassField.SolverMethod) -> Array[String]:
	var field := add_painted_field(method)
	await grown(field)
	var bodies: Array[Node3D] = []
	for shape in shapes():
		bodies.append(add_held_body(shape, Vector3(0, 100, 0)))
	var node := Node3D.new()
	add_child(node)
	field.register_collider(node, ball(0.125))
	bodies.append(node)
	await ticks(1)
	var looks: Array[String] = []
	for tick in 4 * EVERY:
		var way := minf(tick, 60.0) / 10.0 - 3.0
		for i in bodies.size():
			var place := Vector3(1.5 * i - 3.75, 0.1875 + 0.0625 * i, way if i % 2 == 0 else -way)
			bodies[i].global_transform = field.transform * Transform3D(TILTED if i % 3 == 1 else Basis(), place)
		await ticks(1)
		if (tick + 1) % EVERY == 0:
			looks.append(hash_of(field))
	assert_greater(field.get_awake_tile_count(), 20, "tiles in the hash")
	assert_greater(field.get_counters().woken, field.get_awake_tile_count(), "and some asleep by then")
	for body in bodies:
		body.free()
	field.free()
	return looks


func test_blades_stand_as_they_did() -> void:
	for method: GrassField.SolverMethod in GOLDEN:
		assert_eq(await looks_of(method), GOLDEN[method], "method %d" % method)

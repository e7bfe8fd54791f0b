# SPDX-License-Identifier: MIT
## A test with a field: makes fields and bodies, waits, and compares blades.
extends "res://tests/case.gd"

const BLADES := 64  # of a tile
const KNOTS := 16  # of a blade
const PAUSE_MOST := 100  # milliseconds
const CLAMPED := 2  # knots at the root that never move
const CLAMP_SHARE := 1.0 / 60  # of a blade's length that is between them
const LATE := 3  # frames from the tick whose step is the first to the frame in which `steps` counts it, at most


## A GrassField in the tree, `properties` set before it enters. By default it is named Meadow, 4 m wide, without wind, and as dense at its
## border as within.
func add_field(properties := {}) -> GrassField:
	var field := GrassField.new()
	field.name = "Meadow"
	field.size = Vector2(4, 4)
	field.wind_speed = 0.0
	field.border_fade = 0.0
	for property: String in properties:
		if not property in field:
			fail("a GrassField has no property " + property)
		field.set(property, properties[property])
	add_child(field)
	return field


## Returns the list of one species with these properties, for a field.
static func kind(properties: Dictionary) -> Array[GrassSpecies]:
	var species := GrassSpecies.new()
	for property: String in properties:
		species.set(property, properties[property])
	return [species]


## Waits until the driver has compiled all passes of fields, so that tests may count ticks: until then grass does not bend. Returns data of
## the first field of the process: in the last tick that was certainly before its pass was ready, if there is one, and the steps after.
static func warm_up(to: Node) -> Dictionary:
	var first_field := {}
	var field := GrassField.new()
	field.size = Vector2(4, 4)
	to.add_child(field)
	var body := AnimatableBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = SphereShape3D.new()
	body.sync_to_physics = false
	body.add_child(shape)
	to.add_child(body)
	var entered := []
	field.body_entered_grass.connect(entered.append)
	var ticks := 0
	var standing: Array[Dictionary] = []  # a tick each, without a step so far
	var deadline := Time.get_ticks_msec() + PATIENCE * 1000
	while ticks < 5 or field.get_counters().steps == 0 and Time.get_ticks_msec() < deadline:
		await to.get_tree().physics_frame
		body.position.x = 0.1 * sin(ticks)
		ticks += 1
		var counters := field.get_counters()
		if counters.steps == 0:
			standing.append(
				{ticks = ticks, tile_steps = counters.tile_steps, awake = field.get_awake_tile_count(), entered = entered.size()}
			)
			standing[-1].frame = Engine.get_frames_drawn()
		elif not first_field:
			first_field = {stepped = Engine.get_frames_drawn()}
	for tick in standing:
		if tick.frame < first_field.get("stepped", 0) - LATE:
			first_field.merge(tick, true)
	first_field.steps_after = field.get_counters().steps
	field.species = [GrassSpecies.new(), GrassSpecies.new()]
	var began := Time.get_ticks_msec()
	deadline = began + PATIENCE * 1000
	while (field.get_statistics().waiting or field.get_statistics().compiling > 0) and Time.get_ticks_msec() < deadline:
		pause(began)
		await to.get_tree().process_frame
	field.free()
	body.free()
	return first_field


## wait_until() for what other threads make: frames are few, which otherwise take the processors from them.
func wait_for_threads(condition: Callable, what: String, by_ticks := false) -> bool:
	var began := Time.get_ticks_msec()
	var is_there := func() -> bool:
		var there: bool = condition.call()
		if not there:
			pause(began)
		return there
	return await wait_until(is_there, what, by_ticks)


## Between two frames of a wait that began at that time: at most a quarter of it. Nothing where frames are not drawn, and cost nothing.
static func pause(began: int) -> void:
	if DisplayServer.get_name() != "headless":
		OS.delay_msec(mini((Time.get_ticks_msec() - began) / 4, PAUSE_MOST))


## Waits for ticks until the driver has compiled all passes of a field.
func compiled(field: GrassField) -> void:
	await wait_for_threads(func() -> bool: return field.get_statistics().compiling == 0, "all passes are compiled", true)


## Waits for frames until the field has been made so often.
func made(field: GrassField, makings: int) -> void:
	await wait_until(func() -> bool: return field.get_counters().makings >= makings, "the field has been made %d times" % makings)


## Waits for frames until the field shows its properties and its map.
func grown(field: GrassField) -> void:
	await frames(1)
	await wait_for_threads(
		func() -> bool: return not field.get_statistics().waiting and field.get_counters().map_waiting == 0, "the field is grown"
	)


## Waits for frames until every plot that a world wants stands.
func loaded(world: GrassWorld) -> void:
	var calm := [0]
	await wait_until(
		func() -> bool:
			var now := world.get_statistics()
			calm[0] = calm[0] + 1 if now.waiting == 0 and now.files_waiting == 0 and now.plots > 0 else 0
			return calm[0] > 4,
		"all plots are loaded"
	)


## Adds `body` to the tree at `place` with `shape`, or without a shape if that is null.
func add_body(body: PhysicsBody3D, shape: Shape3D, place: Vector3) -> PhysicsBody3D:
	if shape:
		add_shape(body, shape)
	body.position = place
	add_child(body)
	return body


func add_shape(body: PhysicsBody3D, shape: Shape3D, at := Transform3D()) -> CollisionShape3D:
	var node := CollisionShape3D.new()
	node.shape = shape
	node.transform = at
	body.add_child(node)
	return node


## Adds a body that stays where it is put.
func add_held_body(shape: Shape3D, place: Vector3) -> AnimatableBody3D:
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	return add_body(body, shape, place)


func ball(radius: float) -> SphereShape3D:
	var shape := SphereShape3D.new()
	shape.radius = radius
	return shape


func box(size: Vector3) -> BoxShape3D:
	var shape := BoxShape3D.new()
	shape.size = size
	return shape


## Returns a map on which grass grows everywhere.
func full_map() -> GrassMap:
	var map := GrassMap.new()
	map.base_density = 1.0
	return map


## Returns a brush of full strength, hard to its edge.
func brush(tool: GrassBrush.Tool, radius: float, properties := {}) -> GrassBrush:
	var made := GrassBrush.new()
	made.tool = tool
	made.radius = radius
	made.strength = 1.0
	made.hardness = 1.0
	for property: String in properties:
		made.set(property, properties[property])
	return made


## Waits for ticks until a body that was just placed has been read and its grass simulated once.
func seen() -> void:
	await ticks(3)


func awake_tiles(field: GrassField) -> Array[Vector2i]:
	var awake: Array[Vector2i] = []
	var count := field.get_grid_size()
	for z in count.y:
		for x in count.x:
			if field.is_tile_awake(Vector2i(x, z)):
				awake.append(Vector2i(x, z))
	return awake


## Returns the knots of one blade of `knots`, those of a whole tile.
func blade_of(knots: PackedVector3Array, blade: int) -> PackedVector3Array:
	return knots.slice(KNOTS * blade, KNOTS * (blade + 1))


## Returns the length of a blade of `knots`, those of a whole tile, metres.
func length_of(knots: PackedVector3Array, blade: int) -> float:
	var length := 0.0
	for knot in KNOTS - 1:
		length += knots[blade * KNOTS + knot].distance_to(knots[blade * KNOTS + knot + 1])
	return length


## Returns knots of all blades of `tile`, one after the other, as they are now.
func tile_knots(field: GrassField, tile: Vector2i) -> PackedVector3Array:
	return field.wait_for_knots(field.get_tile_blades(tile))


## Returns knots of all blades of the tiles, by tile.
func knots_of(field: GrassField, tiles: Array[Vector2i]) -> Dictionary[Vector2i, PackedVector3Array]:
	var knots: Dictionary[Vector2i, PackedVector3Array] = {}
	for tile in tiles:
		knots[tile] = tile_knots(field, tile)
	return knots


## The greatest distance of a knot from the same knot in the other list, metres. INF if there is nothing to compare or a number is not
## finite.
func farthest(a: PackedVector3Array, b: PackedVector3Array) -> float:
	if a.size() != b.size() or a.is_empty():
		return INF
	var most := 0.0
	for i in a.size():
		var off := a[i].distance_to(b[i])
		most = maxf(most, off) if is_finite(off) else INF
	return most


## Returns the greatest distance of a blade of a tile in `knots` from its place in `knots`. INF without tiles.
func farthest_of(field: GrassField, knots: Dictionary[Vector2i, PackedVector3Array]) -> float:
	var most := 0.0 if knots else INF
	for tile in knots:
		most = maxf(most, farthest(tile_knots(field, tile), knots[tile]))
	return most


## Returns whether there are tiles, and all of their knots are finite.
func all_finite(field: GrassField, tiles: Array[Vector2i]) -> bool:
	for tile in tiles:
		for knot in tile_knots(field, tile):
			if not knot.is_finite():
				return false
	return not tiles.is_empty()


## Waits for ticks until no tile is awake; fails after `limit`.
func ticks_to_sleep(field: GrassField, limit := 1200) -> int:
	for count in limit:
		if field.get_awake_tile_count() == 0:
			return count
		await ticks(1)
	fail("tiles are awake after %d ticks" % limit)
	return limit


## Adds a ball just above the blades of `tile`: it wakes the tile and touches nothing.
func add_ball_above(field: GrassField, tile: Vector2i) -> AnimatableBody3D:
	var tip := -INF
	for x: int in [-1, 0, 1]:
		for z: int in [-1, 0, 1]:
			for knot in tile_knots(field, tile + Vector2i(x, z)):
				tip = maxf(tip, knot.y)
	var center := field.get_tile_center(tile)
	return add_held_body(ball(0.1), Vector3(center.x, tip + 0.11, center.z))


## Bends grass with a ball for some ticks and returns the greatest way of a knot, metres.
func bend_with_ball(field: GrassField, place := Vector3(0, 0.25, 0)) -> float:
	var tile := field.get_tile_at(place)
	var rest := tile_knots(field, tile)
	var body := add_held_body(ball(0.2), place)
	await ticks(10)
	var bent := farthest(tile_knots(field, tile), rest)
	body.free()
	return bent


func collider_count(field: GrassField) -> int:
	await seen()
	return field.get_counters().colliders

# SPDX-License-Identifier: MIT
## The demo's places open, and what happens in them bends, cuts and tramples grass.
extends "res://tests/case.gd"

const Trail := preload("res://demo/trail.gd")
const Demo := "res://demo/%s.tscn"

var place: Node3D
var field: GrassField


func open(p_name: String) -> void:
	place = (load(Demo % p_name) as PackedScene).instantiate()
	if "size" in place:
		place.size = "small"
	add_child(place)
	field = place.get_node("Field")
	await ticks(2)


## Until it is as it should be, at most so many: on the CPU a tick of these places takes a tenth of a second.
func ticks_until(is_so: Callable, most: int) -> void:
	for i in most:
		if is_so.call():
			return
		await ticks(1)


func after() -> void:
	if is_instance_valid(place):
		place.free()


func test_bodies() -> void:
	await open("demo")
	await ticks_until(func() -> bool: return field.get_awake_tile_count() > 10, 60)
	assert_greater(field.get_awake_tile_count(), 10, "bodies fly through the grass")


func test_levels() -> void:
	await open("levels")
	await ticks(60)
	for each: String in ["Field", "Bridge"]:
		assert_greater(place.get_node(each).get_awake_tile_count(), 5, each)


## Nothing ends at the border of a field: the grass goes on, as high as the field's ground.
func test_the_landscape_goes_on() -> void:
	for name: String in ["forces", "burning", "levels", "meadow", "lawn", "reeds"]:
		await open(name)
		var half := 0.5 * field.size.x
		var terrain: Node3D = place.get_node_or_null("Terrain")
		for along: float in [-0.8, 0.0, 0.8]:
			for beside: Vector3 in [Vector3(half + 1.0, 0, along * half), Vector3(-half - 1.0, 0, along * half)]:
				var ground: float = terrain.height_at(clampf(beside.x, -half, half), beside.z) if terrain else 0.0
				assert_true(place.landscape.country.field_at(beside) != null, "%s: grass at %s" % [name, beside])
				assert_near(place.landscape.hills.height_at(beside), ground, 0.5, "%s: the ground at %s" % [name, beside])
		if field.species:
			assert_eq(place.landscape.country.fields[0].species[0].tip_color, field.species[0].tip_color, "%s: of one kind" % name)
		place.free()


func test_meadow() -> void:
	await open("meadow")
	var walker: Node3D = place.get_node("Walker")
	var start := walker.global_position
	var walks := func() -> bool: return walker.global_position.distance_to(start) > 1.5
	await ticks_until(func() -> bool: return walks.call() and field.get_awake_tile_count() > 10, 90)
	assert_greater(field.get_awake_tile_count(), 10)
	assert_true(walks.call(), "who walks is on the way")
	var stroll: Curve3D = place.get_node("Stroll").curve
	var trodden := 0.0
	for i in 25:
		var at := stroll.sample_baked(0.1 * i)
		trodden = maxf(trodden, field.map.sample(GrassMap.CHANNEL_WEAR, Vector2(at.x, at.z)))
	assert_greater(trodden, 0.02, "footprints")
	assert_less(field.get_density_at(Vector3(-16, 0, 14)), 0.5, "the path")
	assert_greater(field.get_density_at(Vector3(-16, 0, 20)), 0.9)
	for x in range(-40, 41, 10):  # roots stand on the terrain
		for z in range(-40, 41, 10):
			var ground: float = place.get_node("Terrain").height_at(x, z)
			assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(x, z)), ground, 0.1)


func grass_at(at: Vector3) -> GrassField:
	return field if field.get_tile_at(at) != Vector2i(-1, -1) else place.landscape.country.field_at(at)


## Returns how many metres of cuts across a path are bare, one cut for each five of its points.
func widths_of(points: PackedVector2Array) -> PackedFloat32Array:
	var widths := PackedFloat32Array()
	for i in range(5, points.size() - 1, 5):
		var across := (points[i + 1] - points[i]).orthogonal().normalized()
		var bare := 0
		for n in range(-25, 26):
			var at := points[i] + 0.1 * n * across
			var grass := grass_at(Vector3(at.x, 0.0, at.y))
			bare += int(grass != null and grass.get_density_at(Vector3(at.x, 0.0, at.y)) < 0.3)
		widths.append(0.1 * bare)
	return widths


func test_a_path_is_of_no_even_width_and_goes_on() -> void:
	await open("meadow")
	var curve: Curve3D = place.get_node("Path").curve
	var widths := widths_of(Trail.points_of(curve))
	widths.sort()
	print("    %.1f to %.1f m wide, %.1f m in the middle" % [widths[0], widths[-1], widths[widths.size() / 2]])
	assert_greater(widths[widths.size() / 10], 0.3, "it is a path")
	assert_greater(widths[-widths.size() / 10], 1.5 * widths[widths.size() / 10])
	for trail: Trail in Trail.beyond(curve, place.PATH_BEYOND):
		var beyond := widths_of(trail.points)
		assert_greater(beyond[0] + beyond[1] + beyond[2], 1.0, "it goes on beside the field")
		assert_less(beyond[-1], 0.3, "and gets lost")


func test_forces() -> void:
	await open("forces")
	await ticks(30)
	assert_eq(field.get_counters().forces, 2, "the rotor and the whirl")
	await ticks(45)
	assert_eq(field.get_counters().forces, 3, "and a blast")
	var blast: Vector3 = place.get_node("Blast").global_position
	assert_greater(field.get_bend_at(blast + Vector3(2, 0, 0)).x, 0.3)
	assert_less(field.get_bend_at(blast + Vector3(-2, 0, 0)).x, -0.3)


func test_burning() -> void:
	await open("burning")
	await ticks(200)
	assert_greater(place.fire.burnt, 5)
	assert_greater(place.fire.get_burning(), 5)
	assert_less(field.get_height_at(place.get_node("Start").global_position), 0.05, "stubble where it began")


func test_lawn() -> void:
	await open("lawn")
	var on_disk := FileAccess.get_md5("res://demo/lawn.grassmap")
	var mown := field.get_mown_share()
	assert_greater(mown, 0.1, "half of it is mown")
	await ticks(120)
	assert_greater(field.get_mown_share(), mown)
	assert_less(field.get_height_at(place.get_node("Mower").global_position), 0.07)
	assert_greater(field.get_awake_tile_count(), 0)
	assert_eq(FileAccess.get_md5("res://demo/lawn.grassmap"), on_disk)


func test_reeds() -> void:
	await open("reeds")
	var most := 0
	for i in 120:
		await ticks(1)
		most = maxi(most, field.get_awake_tile_count())
	assert_greater(most, 20, "the boat comes through the reeds")
	assert_greater(field.get_height_at(Vector3(10, 0, 4)), 1.0, "reeds")
	assert_near(field.get_height_at(Vector3(10, 0, 20)), 0.4, 0.2, "the bank")
	assert_eq(field.get_density_at(Vector3(0, 0, -20)), 0.0, "open water")
	var found := {true: 0, false: 0}
	for x in range(-90, 91, 4):
		for z in range(-90, 91, 4):
			var at := Vector3(x, 0, z)
			var beside: GrassField = place.landscape.country.field_at(at)
			var height: float = place.landscape.hills.height_at(at)
			if beside and absf(height) > 0.15:
				found[height > 0.0] += 1
				assert_near(beside.get_density_at(at), 1.0 if height > 0.0 else 0.0, 0.1, "beside the field, at %s" % at)
	assert_greater(found[true], 100)
	assert_greater(found[false], 100, "the lake goes on beside the field")

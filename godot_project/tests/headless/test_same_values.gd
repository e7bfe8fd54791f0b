# SPDX-License-Identifier: MIT
## Setting a property to the value that it already has changes nothing; a property that changes in every frame still takes effect.
extends "res://tests/world_case.gd"


func classes() -> Array[StringName]:
	var found: Array[StringName] = []
	for type: StringName in ClassDB.get_class_list():
		var is_ours := String(type).begins_with("Grass") and ClassDB.can_instantiate(type)
		if is_ours and (ClassDB.is_parent_class(type, &"Node3D") or ClassDB.is_parent_class(type, &"Resource")):
			found.append(type)
	return found


## Returns the class's own properties, by name. One of an index is there, too: `hook/...` and others that only an object has are not.
func properties_of(type: StringName) -> Array[String]:
	var names: Array[String] = []
	for property in ClassDB.class_get_property_list(type, true):
		if property.usage & (PROPERTY_USAGE_STORAGE | PROPERTY_USAGE_EDITOR) and property.type != TYPE_CALLABLE:
			names.append(property.name)
	return names


func test_resources_do_not_change() -> void:
	var count := [0, 0]  # properties, changes
	for type in classes():
		if not ClassDB.is_parent_class(type, &"Resource"):
			continue
		var resource: Resource = ClassDB.instantiate(type)
		if resource is GrassSpecies:
			resource.patch = GrassPatch.new()
			resource.card = GradientTexture2D.new()
			resource.plant_mesh = BoxMesh.new()
		resource.changed.connect(func() -> void: count[1] += 1)
		for property in properties_of(type):
			count[0] += 1
			count[1] = 0
			resource.set(property, resource.get(property))
			assert_eq(count[1], 0, "%s.%s" % [type, property])
	assert_greater(count[0], 70)


func test_a_field_is_not_made_again() -> void:
	var rule := GrassFillRule.new()
	var properties := {map = full_map(), fill_rule = rule, species = [GrassSpecies.new()] as Array[GrassSpecies]}
	properties.surface_hook = ShaderInclude.new()
	var field := add_field(properties)
	await grown(field)
	var makings: int = field.get_counters().makings
	var names := properties_of(&"GrassField")
	assert_greater(names.size(), 50)
	for property in names:
		for i in 3:
			field.set(property, field.get(property))
			await ticks(1)
		var now := field.get_statistics().merged(field.get_counters())
		assert_eq([now.makings, now.waiting], [makings, false], property)
	field.density = 300.0
	await made(field, makings + 1)
	assert_eq(field.get_counters().makings, makings + 1, "and another value makes it once")


func test_a_world_goes_on() -> void:
	var world := add_world({camera_radius = 100.0})
	await go(world, Vector3(64, 0, 64))
	var before := world.get_statistics()
	for property in properties_of(&"GrassWorld"):
		world.set(property, world.get(property))
		await frames(1)
		var now := world.get_statistics()
		assert_eq([now.plots, now.brought, now.left], [before.plots, before.brought, before.left], property)


func test_nodes_make_nothing_in_a_game() -> void:
	for type: StringName in [&"GrassForce3D", &"GrassExclusion3D", &"GrassPath3D"]:
		var node: Node3D = ClassDB.instantiate(type)
		if node is GrassExclusion3D:
			node.shape = ball(1.0)
		if node is GrassPath3D:
			node.curve = Curve3D.new()
			for i in 20:
				node.curve.add_point(Vector3(i, 0, i % 3))
		add_child(node)
		for property in properties_of(type):
			var made := objects_made(func() -> void: node.set(property, node.get(property)))
			assert_eq(made, 0, "%s.%s, the same" % [type, property])
		var changed := "fade" if node is GrassExclusion3D else "width" if node is GrassPath3D else "radius"
		assert_eq(
			objects_made(func() -> void: node.set(changed, 3.25)), 0, "%s.%s, for a picture that only the editor shows" % [type, changed]
		)
		assert_eq(node.get(changed), 3.25)


## Returns how many objects the engine makes while `work` runs: it counts them in their instances' ids.
func objects_made(work: Callable) -> int:
	var number := func() -> int: return (RefCounted.new().get_instance_id() >> 24) & 0x7fffffff
	var before: int = number.call()
	work.call()
	return number.call() - before - 1


func test_a_shape_of_no_numbers_does_no_harm() -> void:
	for bad: float in [NAN, INF, 1e30]:
		var shape := ConvexPolygonShape3D.new()
		shape.points = [Vector3(bad, 0, 0), Vector3(0, bad, 1), Vector3(-1, -bad, 0), Vector3(0, 0, bad), Vector3.ONE]
		var exclusion := GrassExclusion3D.new()
		add_child(exclusion)
		assert_eq(objects_made(func() -> void: exclusion.shape = shape), 0, "no mesh of %s" % bad)
		assert_eq(exclusion.shape, shape)


func test_a_patch_that_changes_in_every_frame_shows() -> void:
	var patch := GrassPatch.new()
	var species := GrassSpecies.new()
	species.patch = patch
	var field := add_field({species = [species] as Array[GrassSpecies]})
	await grown(field)
	var makings: int = field.get_counters().makings
	var count := [0]
	await wait_until(
		func() -> bool:
			count[0] += 1
			patch.length_max = 0.7 + 0.1 * (count[0] % 5)
			return field.get_counters().makings >= makings + 3,
		"a field is made whose patch changes in every frame"
	)
	patch.length_min = 1.3
	patch.length_max = 1.4
	await grown(field)
	var other := add_field({species = [species] as Array[GrassSpecies], position = Vector3(100, 0, 0)})
	await grown(other)
	var to_other := func(knot: Vector3) -> Vector3: return knot + Vector3(100, 0, 0)
	var here := Array(tile_knots(field, Vector2i.ONE)).map(to_other)
	assert_less(farthest(PackedVector3Array(here), tile_knots(other, Vector2i.ONE)), 1e-4, "in the end it is what the patch says")


func test_species_that_change_in_every_frame_show() -> void:
	var field := add_field({map = full_map()})
	await grown(field)
	var makings: int = field.get_counters().makings
	var came := await wait_until(
		func() -> bool:
			field.species = [GrassSpecies.new(), GrassSpecies.new()] as Array[GrassSpecies]
			return field.get_counters().makings >= makings + 3,
		"a field is made whose species change in every frame"
	)
	assert_true(came)

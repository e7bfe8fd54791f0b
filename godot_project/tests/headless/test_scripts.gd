# SPDX-License-Identifier: MIT
## A field survives anything that the scripts it calls may do: for its bodies, its map, its rule and its species.
extends "res://tests/scripts_case.gd"


class PlantMesh:
	extends PrimitiveMesh

	var told: Callable

	func _create_mesh_array() -> Array:
		told.call("_create_mesh_array")
		var arrays := []
		arrays.resize(ARRAY_MAX)
		arrays[ARRAY_VERTEX] = PackedVector3Array([Vector3.ZERO, Vector3(0.1, 0.3, 0), Vector3(0, 0.3, 0.1)])
		return arrays


class MaskMesh:
	extends Mesh

	var told := func(_method: String) -> void: pass  # until a field reads it

	func _get_surface_count() -> int:
		told.call("_get_surface_count")
		return 1

	func _surface_get_arrays(_surface: int) -> Array:
		told.call("_surface_get_arrays")
		var arrays := []
		arrays.resize(ARRAY_MAX)
		arrays[ARRAY_VERTEX] = PackedVector3Array([Vector3(-9, 0, -9), Vector3(9, 0, 0), Vector3(0, 0, 9)])
		return arrays

	func _get_blend_shape_count() -> int:
		return 0

	func _get_aabb() -> AABB:
		return AABB(Vector3.ZERO, Vector3.ONE)


func add_bodies() -> Array[AnimatableBody3D]:
	var bodies: Array[AnimatableBody3D] = []
	for i in 4:
		bodies.append(add_held_body(ball(0.2), Vector3(0.8 * i - 1.2, 0.2, 0)))
	return bodies


func test_bodies_enter_and_leave() -> void:
	allow_error(LOCKED)
	allow_error(EMITTING)
	await try_deeds(
		func() -> void:
			add_level().body_entered_grass.connect(hear.unbind(1))
			add_bodies()
			await until_heard(),
		"body_entered_grass"
	)
	await try_deeds(
		func() -> void:
			var field := add_level()
			var bodies := add_bodies()
			await ticks(5)
			field.body_exited_grass.connect(hear.unbind(1))
			for body in bodies:
				body.position.y = 5.0
			await until_heard(),
		"body_exited_grass"
	)
	await try_deeds(
		func() -> void:
			var field := add_level()
			add_bodies()
			await ticks(5)
			field.body_exited_grass.connect(hear.unbind(1))
			field.simulated = false,
		"body_exited_grass without simulation"
	)
	var not_while_leaving: Array[String] = [
		"free the level", "free the field", "free the ground", "remove the field", "remove the level", "remove and add the field"  # the engine takes nothing from a node that is just losing a child
	]
	await try_deeds(
		func() -> void:
			var field := add_level()
			add_bodies()
			await ticks(5)
			field.body_exited_grass.connect(hear.unbind(1))
			level.remove_child(field),
		"body_exited_grass of a field that leaves",
		not_while_leaving
	)


func test_plants_get_nodes_and_lose_them() -> void:
	allow_error(LOCKED)
	allow_error(EMITTING)
	var root := Node3D.new()
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	var species := GrassSpecies.new()
	species.plant_scene = scene
	var camera := Camera3D.new()
	add_child(camera)
	camera.make_current()
	await try_deeds(
		func() -> void:
			add_level({species = [species]}).plant_node_appeared.connect(hear.unbind(3))
			await until_heard(),
		"plant_node_appeared"
	)
	await try_deeds(
		func() -> void:
			var field := add_level({species = [species]})
			await ticks(10)
			field.plant_node_leaving.connect(hear.unbind(3))
			field.plant_nodes_max = 0
			await until_heard(),
		"plant_node_leaving"
	)


func change_map(field: GrassField, how: String) -> void:
	match how:
		"cut":
			field.cut(ball(0.5), Transform3D())
		"paint":
			field.paint(brush(GrassBrush.TOOL_ERASE, 1.0), Vector3.ZERO, Vector3.ONE)
		"trample":
			field.trample(Vector3.ZERO, 1.0, 0.5)
		"regrow":
			field.regrow(0.1)
		"fill":
			var rule := GrassFillRule.new()
			rule.density = 0.5
			field.fill(rule)
		"bake_ground":
			var slab := HeightMapShape3D.new()
			slab.map_data = [1.0, 1.0, 1.0, 1.0]
			field.bake_ground_from(slab, Transform3D(Basis.from_scale(Vector3(9, 1, 9)), Vector3.ZERO))


func test_the_map_changes() -> void:
	allow_error(EMITTING)
	for change: String in ["cut", "paint", "trample", "regrow", "fill", "bake_ground"]:
		await try_deeds(
			func() -> void:
				var field := add_level({map = full_map()})
				await ticks(2)
				if change == "regrow":
					field.cut(ball(0.5), Transform3D())
				field.map.chunks_changed.connect(hear.unbind(2))
				change_map(field, change),
			"chunks_changed by " + change
		)
	await try_deeds(
		func() -> void:
			var field := add_level({map = full_map()})
			await ticks(2)
			field.map.changed.connect(hear)
			field.cut(ball(0.5), Transform3D()),
		"changed of a map"
	)
	await try_deeds(
		func() -> void:
			var species := GrassSpecies.new()
			species.wear_recovery = 1.0
			var field := add_level({map = full_map(), species = [species] as Array[GrassSpecies]})
			await ticks(2)
			field.trample(Vector3.ZERO, 1.0, 1.0)
			field.map.chunks_changed.connect(hear.unbind(2))
			await until_heard(),
		"chunks_changed by recovery"
	)


func test_a_rule_fills() -> void:
	allow_error(LOCKED)
	allow_error(EMITTING)
	var rule := GrassFillRule.new()
	rule.density = 0.5
	await try_deeds(
		func() -> void:
			var field := add_level({map = full_map(), fill_rule = rule})
			field.fill_finished.connect(hear)
			await until_heard(),
		"fill_finished"
	)
	await try_deeds(
		func() -> void:
			var map := full_map()
			map.chunks_changed.connect(hear.unbind(2))
			add_level({map = map, fill_rule = rule})
			await until_heard(),
		"chunks_changed by a rule"
	)
	await try_deeds(
		func() -> void:
			var field := add_level({map = full_map(), fill_rule = rule})
			await ticks(2)
			await frames(2)
			field.map.chunks_changed.connect(hear.unbind(2))
			field.fill_rule = null,
		"chunks_changed by a rule that goes"
	)
	await try_deeds(
		func() -> void:
			var field := add_level({map = full_map()})
			await ticks(2)
			field.property_list_changed.connect(hear)
			field.fill_rule = rule,
		"property_list_changed"
	)


func test_meshes_of_a_rule_are_scripts() -> void:
	allow_error(EMITTING)
	var rule := GrassFillRule.new()
	rule.mask_group = "mask"
	for method: String in ["_get_surface_count", "_surface_get_arrays"]:
		for occasion: String in ["a rule that looks", "a field that is made", "fill()", "explain()"]:
			await try_deeds(
				func() -> void:
					var field := add_level({map = full_map(), fill_rule = null if occasion == "fill()" else rule})
					await ticks(2)
					await frames(2)
					if occasion == "a field that is made":
						level.remove_child(field)
						field.map = full_map()
					var masked := MeshInstance3D.new()
					masked.mesh = MaskMesh.new()
					(masked.mesh as MaskMesh).told = hear_of.bind(method)
					masked.add_to_group("mask")
					level.ground.add_child(masked)
					match occasion:
						"a field that is made":
							level.add_child(field)
							field.get_density_at(Vector3.ZERO)
						"fill()":
							field.fill(rule)
						"explain()":
							field.explain(Vector3.ZERO)
					await until_heard(),
				"%s for %s" % [method, occasion]
			)


func test_species_are_scripts() -> void:
	await try_deeds(
		func() -> void:
			var species := GrassSpecies.new()
			add_level({species = [species] as Array[GrassSpecies]})
			await ticks(2)
			species.changed.connect(hear)
			species.natural_frequency = 3.0,
		"changed of a species"
	)
	await try_deeds(
		func() -> void:
			var mesh := PlantMesh.new()
			mesh.told = hear_of.bind("_create_mesh_array")
			var species := GrassSpecies.new()
			species.plant_mesh = mesh
			add_level({species = [species] as Array[GrassSpecies]})
			await until_heard(),
		"a mesh of a species"
	)

# SPDX-License-Identifier: MIT
## Nodes of plants whose field, species or scene changes or goes, and nodes that a game frees or keeps.
extends "res://tests/plant_nodes_case.gd"


func test_fields_that_change_leave_and_return() -> void:
	var field := add_shrubs()
	await settled(field)
	assert_greater(nodes.size(), 50)
	var first: Node3D = nodes.values()[0]
	field.species = [GrassSpecies.new(), shrub(shrub_scene(), {share = 0.2})]
	await grown(field)
	await settled(field)
	assert_greater(nodes.size(), 100)
	await ticks(2)
	assert_false(is_instance_valid(first), "what no species has any more is freed")
	field.density = 9.0
	await grown(field)
	await settled(field)
	for blade: int in nodes:
		assert_near(nodes[blade].global_position, root_of(field, blade), 1e-4)
	var parent := Node3D.new()
	add_child(parent)
	remove_child(field)
	assert_eq(nodes.size(), 0, "a field outside of the tree has no plants")
	await ticks(2)
	parent.add_child(field)
	await settled(field)
	assert_greater(nodes.size(), 50)
	field.reparent(self)
	await settled(field)
	assert_greater(nodes.size(), 50)
	var node: Node3D = nodes.values()[0]
	field.free()
	assert_eq(nodes.size(), 0)
	assert_false(is_instance_valid(node))


func test_a_species_without_its_scene_has_no_nodes() -> void:
	var species := shrub(shrub_scene())
	var field := add_shrubs({}, species)
	await settled(field)
	var makings: int = field.get_counters().makings
	species.plant_scene = null
	await settled(field)
	assert_eq(nodes.size(), 0)
	species.plant_scene = shrub_scene()
	species.plant_scene_distance = 3.0
	await settled(field)
	assert_eq(sorted(nodes.keys()), sorted(shrubs_within(field, camera.position, 3.0)))
	assert_eq(field.get_counters().makings, makings, "the field is not made again")


func test_a_scene_that_makes_no_node_is_named() -> void:
	expect_error("GrassField 'Meadow': `plant_scene` of species 1 holds no nodes")
	expect_error("GrassField 'Meadow': `plant_scene` of species 1 (a scene without a file) cannot be instantiated")
	var field := add_shrubs({}, shrub(PackedScene.new()))
	await ticks(20)
	assert_eq(field.get_counters().plant_nodes, 0)
	field.free()
	var root := Node.new()
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	expect_error("has a root that is no Node3D")
	add_shrubs({}, shrub(scene))
	await ticks(20)
	assert_eq(nodes.size(), 0)


func test_a_node_that_the_game_frees_does_not_return_at_once() -> void:
	var field := add_shrubs({plant_nodes_max = 10})
	await settled(field)
	var blade: int = nodes.keys()[0]
	var made_before := all_nodes.size()
	nodes[blade].free()
	nodes.erase(blade)
	await ticks(30)
	assert_false(nodes.has(blade))
	assert_eq(all_nodes.size(), made_before)
	camera.position.x = 100.0
	await settled(field)
	assert_eq(nodes.size(), 0)


func test_a_script_may_remove_the_field() -> void:
	var removed := add_shrubs()
	removed.plant_node_appeared.connect(func(_node: Node3D, _species: int, _blade: int) -> void: remove_child(removed))
	await ticks(10)
	assert_false(removed.is_inside_tree())
	assert_eq(nodes.size(), 0)
	removed.free()


func test_baked_ground_does_not_rise_onto_plants() -> void:
	var ground := StaticBody3D.new()
	add_body(ground, box(Vector3(60, 1, 60)), Vector3(0, -0.5, 0))
	var field := add_shrubs({map = full_map()})
	await grown(field)
	await settled(field)
	assert_greater(nodes.size(), 50)
	field.bake_ground()
	await settled(field)
	for blade: int in nodes:
		assert_near(root_of(field, blade).y, 0.0, 0.02)


## A node that the game adds to a tree of its own after plant_node_leaving is the game's, however the field ends.
func test_nodes_that_the_game_adopts_stay() -> void:
	for end: String in ["free the field", "another scene"]:
		var species := shrub(shrub_scene())
		var field := add_shrubs({}, species)
		var own := Node3D.new()
		add_child(own)
		await settled(field)
		var kept: Array[Node3D] = []
		field.plant_node_leaving.connect(
			func(node: Node3D, _species: int, _blade: int) -> void:
				if kept.size() < 10:
					kept.append(node)
					own.add_child.call_deferred(node)
		)
		field.plant_nodes_max = nodes.size() - 10
		await ticks(5)
		assert_eq([kept.size(), own.get_child_count()], [10, 10])
		if end == "free the field":
			field.free()
		else:
			species.plant_scene = null
		await ticks(5)
		assert_eq(own.get_child_count(), 10, end)
		for node in kept:
			assert_true(is_instance_valid(node) and node.get_parent() == own, end)
		if is_instance_valid(field):
			field.free()
		own.free()
		nodes.clear()


## replace_by() gives the children of a field to another node, those inside of it as well.
func test_a_field_that_is_replaced_takes_its_nodes_along() -> void:
	var before := Performance.get_monitor(Performance.OBJECT_NODE_COUNT)
	var field := add_shrubs({size = Vector2(10, 10)})
	await settled(field)
	var count := nodes.size()
	assert_greater(count, 20)
	var other := Node3D.new()
	field.replace_by(other)
	await ticks(3)
	assert_eq(nodes.size(), 0, "all have left")
	assert_eq(other.get_child_count(true), 0, "and nothing is left behind")
	add_child(field)
	await settled(field)
	assert_eq(nodes.size(), count, "in the tree again it has its nodes again")
	assert_eq(field.get_child(0, true).get_child_count(), count)
	field.free()
	other.free()
	await ticks(3)
	assert_eq(Performance.get_monitor(Performance.OBJECT_NODE_COUNT), before)
	assert_eq(Performance.get_monitor(Performance.OBJECT_ORPHAN_NODE_COUNT), 0.0)


## A script that takes the inner node away has it with the nodes in it; the field makes another one.
func test_a_script_takes_the_inner_node_away() -> void:
	var field := add_shrubs({size = Vector2(10, 10)})
	await settled(field)
	var count := nodes.size()
	var taken := field.get_child(0, true)
	taken.reparent(self)
	field.plant_nodes_max = 0
	await settled(field)
	assert_eq(taken.get_child_count(), count, "its nodes are no longer the field's")
	field.plant_nodes_max = 1024
	await settled(field)
	assert_eq(nodes.size(), count)
	assert_eq(field.get_child(0, true).get_child_count(), count)
	field.free()
	assert_eq(taken.get_child_count(), count)

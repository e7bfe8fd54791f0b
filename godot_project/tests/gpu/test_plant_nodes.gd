# SPDX-License-Identifier: MIT
## Plants whose blades the GPU simulates have nodes, too, and these stand where the GPU has the blades' roots.
extends "res://tests/view_case.gd"

const SHRUB := 1  # index of the species

var nodes := {}  # by blade


func before() -> void:
	open_view(Vector2i(96, 54))
	add_light()
	look(Vector3(0, 1.2, 3.2), Vector3(0, 0.2, 0))


func shrub() -> GrassSpecies:
	var root := Node3D.new()
	var body := StaticBody3D.new()
	root.add_child(body)
	body.owner = root
	add_shape(body, ball(0.2)).owner = root
	var species: GrassSpecies = load("res://addons/grass_field/presets/small_shrub.tres").duplicate()
	species.plant_scene = PackedScene.new()
	species.plant_scene.pack(root)
	root.free()
	species.share = 0.2
	return species


func test_nodes_stand_where_the_gpu_draws_the_plants() -> void:
	var species: Array[GrassSpecies] = [GrassSpecies.new(), shrub()]
	var field := add_seen_field({soil_enabled = false, size = Vector2(8, 8), density = 16.0, species = species, map = full_map()})
	field.plant_node_appeared.connect(func(node: Node3D, of: int, blade: int) -> void: nodes[blade] = node if of == SHRUB else null)
	field.plant_node_leaving.connect(func(_node: Node3D, _of: int, blade: int) -> void: nodes.erase(blade))
	await drawn()
	await compiled(field)
	assert_eq(field.get_statistics().backend, "GPU")
	await ticks(60)
	assert_greater(nodes.size(), 10)
	assert_eq(nodes.size(), field.get_counters().plant_nodes)
	var blades := PackedInt64Array(nodes.keys())
	var knots := field.wait_for_knots(blades)
	for i in blades.size():
		assert_less(nodes[blades[i]].global_position.distance_to(blade_of(knots, i)[0]), 0.001)
	assert_eq(field.get_awake_tile_count(), 0, "none of these bodies wakes grass")
	field.map.stroke(brush(GrassBrush.TOOL_ERASE, 20.0), Vector2.ZERO, Vector2.ZERO)
	field.map.stroke(brush(GrassBrush.TOOL_ERASE, 20.0), Vector2.ZERO, Vector2.ZERO)
	await ticks(60)
	assert_eq(nodes.size(), 0, "nothing grows any more")

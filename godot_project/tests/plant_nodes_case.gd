# SPDX-License-Identifier: MIT
## Tests of plants with a scene, in a field of shrubs.
extends "res://tests/field_case.gd"

const DISTANCE := 6.0  # metres, `plant_scene_distance`
const SHRUB := 1  # index of the species

var camera: Camera3D
var appeared := {}  # by blade: how often
var left := {}
var nodes := {}  # by blade: the node that a plant has
var all_nodes := {}  # instance ids of all that plants have had
var changes := 0  # signals


func before() -> void:
	camera = Camera3D.new()
	camera.position = Vector3(0, 1.6, 0)
	add_child(camera)
	camera.make_current()


## Returns a shrub: a body that blocks, and an area.
func shrub_scene(body: PhysicsBody3D = StaticBody3D.new()) -> PackedScene:
	var root := Node3D.new()
	root.name = "Shrub"
	var cylinder := CylinderShape3D.new()
	cylinder.radius = 0.4
	cylinder.height = 2.0
	var shapes := {body: cylinder, Area3D.new(): ball(0.8)}
	for child: CollisionObject3D in shapes:
		var shape := CollisionShape3D.new()
		shape.shape = shapes[child]
		shape.position.y = 1.0
		root.add_child(child)
		child.add_child(shape)
		child.owner = root
		shape.owner = root
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	return scene


func shrub(scene: PackedScene, properties := {}) -> GrassSpecies:
	var species := GrassSpecies.new()
	species.patch = GrassPatch.new()
	species.patch.length_min = 1.0
	species.patch.length_max = 1.5
	species.share = 0.1
	species.stand_strength = 0.0
	species.plant_scene = scene
	species.plant_scene_distance = DISTANCE
	for property: String in properties:
		species.set(property, properties[property])
	return species


## Grass with shrubs in it, whose signals are counted. By default 40 m wide, with about 1.6 shrubs per square metre.
func add_shrubs(properties := {}, species: GrassSpecies = shrub(shrub_scene())) -> GrassField:
	var settings := {size = Vector2(40, 40), density = 16.0, species = [GrassSpecies.new(), species], plant_nodes_max = 1024}
	settings.merge(properties, true)
	var field := add_field(settings)
	field.plant_node_appeared.connect(_on_appeared)
	field.plant_node_leaving.connect(_on_left)
	return field


func _on_appeared(node: Node3D, species: int, blade: int) -> void:
	assert_eq(species, SHRUB)
	assert_true(node.is_inside_tree())
	assert_false(nodes.has(blade), "a plant has one node")
	changes += 1
	appeared[blade] = appeared.get(blade, 0) + 1
	nodes[blade] = node
	all_nodes[node.get_instance_id()] = true


func _on_left(node: Node3D, species: int, blade: int) -> void:
	assert_eq(species, SHRUB)
	assert_eq(nodes.get(blade), node, "the node that appeared")
	changes += 1
	left[blade] = left.get(blade, 0) + 1
	nodes.erase(blade)


## Waits until no plant waits for its node, or for losing it.
func settled(field: GrassField) -> void:
	var before := -1
	var looked_at := -1
	while before != changes or looked_at != field.get_counters().stems_looked_at:
		before = changes
		looked_at = field.get_counters().stems_looked_at
		await ticks(4)


func species_of(field: GrassField, blade: int) -> int:
	var tile := blade / BLADES
	var width := field.get_grid_size().x
	return field.get_blade_species(Vector2i(tile % width, tile / width), blade % BLADES)


## Returns the shrubs whose roots are up to `radius` from a place.
func shrubs_within(field: GrassField, place: Vector3, radius: float) -> Array[int]:
	var found: Array[int] = []
	for blade in field.find_blades(place, radius):
		if species_of(field, blade) == SHRUB and root_of(field, blade).distance_to(place) <= radius:
			found.append(blade)
	return found


func root_of(field: GrassField, blade: int) -> Vector3:
	return field.get_blade_knots([blade])[0]


func sorted(blades: Array) -> Array:
	var copy := blades.duplicate()
	copy.sort()
	return copy

# SPDX-License-Identifier: MIT
## Trees in groves, as simple shapes: a trunk, and a crown of some lumps that are darker below. All of them are two draw calls.
extends Node3D

const GROVES := 26
const IN_GROVE := Vector2i(1, 11)  # trees, fewest and most
const SPREAD := 18.0  # metres, from the middle of a grove
const HEIGHT := Vector2(6.0, 13.0)  # metres, smallest and tallest
const LEAVES: Array[Color] = [Color(0.33, 0.45, 0.16), Color(0.44, 0.53, 0.2), Color(0.26, 0.4, 0.18)]
const BARK := Color(0.2, 0.16, 0.12)
## The crown's parts: middle and half axes, in heights of the tree.
const PARTS: Array[Array] = [
	[Vector3(0.0, 0.64, 0.0), Vector3(0.27, 0.34, 0.27)],
	[Vector3(0.16, 0.5, 0.05), Vector3(0.2, 0.2, 0.18)],
	[Vector3(-0.13, 0.46, 0.1), Vector3(0.19, 0.19, 0.2)],
	[Vector3(0.0, 0.5, -0.17), Vector3(0.2, 0.22, 0.19)],
]
const LUMPS := 0.34  # how far the crown leaves the sphere, in its radii
const SHADE := 0.45  # of the light on the crown's underside

const Hills := preload("res://demo/walk/hills.gd")

var count := 0  ## trees
var others: Array[Vector3] = []  ## places of trees besides those in groves

var _trunks: Array[Transform3D] = []
var _crowns: Array[Transform3D] = []


## Plants groves on the hills, from `near` to `far` metres from the middle. The same numbers give the same trees.
func make(hills: Hills, near: float, far: float) -> void:
	var random := RandomNumberGenerator.new()
	random.seed = 5
	for grove in GROVES:
		var way := TAU * (grove + random.randf()) / GROVES
		var away := lerpf(near, far, pow(random.randf(), 1.7))  # most of them near
		for tree in random.randi_range(IN_GROVE.x, IN_GROVE.y):
			var off := Vector2.from_angle(TAU * random.randf()) * SPREAD * sqrt(random.randf())
			var place := Vector2.from_angle(way) * (away + SPREAD) + off
			var foot := Vector3(place.x, hills.ground_at(place) - 0.3, place.y)
			if foot.y > hills.water:
				_plant(foot, random)
	for place in others:
		_plant(place, random)
	count = _trunks.size()
	var trunk := CylinderMesh.new()
	trunk.top_radius = 0.3
	trunk.bottom_radius = 0.55
	trunk.height = 1.0
	trunk.radial_segments = 8
	trunk.rings = 1
	_add(trunk, _trunks, [BARK], random)
	_add(_crown(), _crowns, LEAVES, random)


func _plant(foot: Vector3, random: RandomNumberGenerator) -> void:
	var height := random.randf_range(HEIGHT.x, HEIGHT.y)
	var turned := Basis(Vector3.UP, TAU * random.randf())
	var thick := 0.05 * height
	_trunks.append(Transform3D(turned.scaled(Vector3(thick, 0.5 * height, thick)), foot + 0.25 * height * Vector3.UP))
	for part in PARTS:
		var crown := turned.scaled(height * part[1] * random.randf_range(0.9, 1.15))
		_crowns.append(Transform3D(crown, foot + height * (turned * part[0])))


func _add(mesh: Mesh, places: Array[Transform3D], colors: Array[Color], random: RandomNumberGenerator) -> void:
	var all := MultiMesh.new()
	all.transform_format = MultiMesh.TRANSFORM_3D
	all.use_colors = true
	all.mesh = mesh
	all.instance_count = places.size()
	for i in places.size():
		all.set_instance_transform(i, places[i])
		var first := colors[random.randi() % colors.size()]
		all.set_instance_color(i, first.lerp(colors[random.randi() % colors.size()], random.randf()))
	var shown := MultiMeshInstance3D.new()
	shown.multimesh = all
	shown.material_override = StandardMaterial3D.new()
	shown.material_override.vertex_color_use_as_albedo = true
	shown.material_override.vertex_color_is_srgb = true
	shown.material_override.roughness = 1.0
	shown.material_override.diffuse_mode = BaseMaterial3D.DIFFUSE_LAMBERT_WRAP  # leaves let light through
	shown.gi_mode = GeometryInstance3D.GI_MODE_DISABLED
	add_child(shown)


## A sphere of radius 1 with lumps.
func _crown() -> ArrayMesh:
	var noise := FastNoiseLite.new()
	noise.noise_type = FastNoiseLite.TYPE_SIMPLEX
	noise.frequency = 1.1
	noise.fractal_octaves = 3
	var sphere := SphereMesh.new()
	sphere.radius = 1.0
	sphere.height = 2.0
	sphere.radial_segments = 24
	sphere.rings = 14
	var arrays := sphere.get_mesh_arrays()
	var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
	var surface := SurfaceTool.new()
	surface.begin(Mesh.PRIMITIVE_TRIANGLES)
	for point in points:
		var light := lerpf(SHADE, 1.0, smoothstep(-0.9, 0.6, point.y + 0.5 * noise.get_noise_3dv(4.0 * point)))
		surface.set_color(Color(light, light, light))
		surface.add_vertex(point * (1.0 + LUMPS * noise.get_noise_3dv(point)))
	for index in indices:
		surface.add_index(index)
	surface.generate_normals()
	return surface.commit()

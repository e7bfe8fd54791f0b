# SPDX-License-Identifier: MIT
## Trees in groves: a trunk, and a crown of cards with leaves that is darker inside and below. All of them are two draw calls.
extends Node3D

const GROVES := 26
const IN_GROVE := Vector2i(1, 11)  # trees, fewest and most
const SPREAD := 18.0  # metres, from the middle of a grove
const HEIGHT := Vector2(6.0, 13.0)  # metres, smallest and tallest
const LEAVES: Array[Color] = [Color(0.45, 0.56, 0.24), Color(0.55, 0.62, 0.29), Color(0.37, 0.5, 0.23)]
const BARK := Color(0.2, 0.16, 0.12)
## The crown's parts: middle and half axes, in heights of the tree.
const PARTS: Array[Array] = [
	[Vector3(0.0, 0.74, 0.0), Vector3(0.19, 0.22, 0.19)],
	[Vector3(0.18, 0.59, 0.05), Vector3(0.17, 0.13, 0.16)],
	[Vector3(-0.16, 0.55, 0.11), Vector3(0.17, 0.13, 0.17)],
	[Vector3(-0.02, 0.57, -0.19), Vector3(0.18, 0.14, 0.15)],
	[Vector3(0.08, 0.47, 0.18), Vector3(0.13, 0.1, 0.12)],
]
const CARDS := 110  # of a part
const CARD := Vector2(0.075, 0.125)  # half the side of a card, in heights of the tree, least and most
const INSIDE := 0.55  # radii of a part from which on there are cards
const SHADE := 0.6  # of the light inside of the crown and on its underside
const PICTURE := 128  # texels, the side of the picture of a twig
const LEAVES_ON_CARD := 110

const Hills := preload("res://demo/walk/hills.gd")
const Foliage := preload("res://demo/walk/foliage.gdshader")

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
	_add(trunk, _trunks, _bark(), [BARK], random)
	_add(_crown(), _crowns, _foliage(), LEAVES, random)


func _plant(foot: Vector3, random: RandomNumberGenerator) -> void:
	var height := random.randf_range(HEIGHT.x, HEIGHT.y)
	var turned := Basis(Vector3.UP, TAU * random.randf())
	var thick := 0.05 * height
	_trunks.append(Transform3D(turned.scaled(Vector3(thick, 0.5 * height, thick)), foot + 0.25 * height * Vector3.UP))
	var wide := height * random.randf_range(0.85, 1.15)
	_crowns.append(Transform3D(turned.scaled(Vector3(wide, height * random.randf_range(0.9, 1.05), wide)), foot))


func _add(mesh: Mesh, places: Array[Transform3D], material: Material, colors: Array[Color], random: RandomNumberGenerator) -> void:
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
	shown.material_override = material
	shown.gi_mode = GeometryInstance3D.GI_MODE_DISABLED
	add_child(shown)


static func _bark() -> StandardMaterial3D:
	var bark := StandardMaterial3D.new()
	bark.vertex_color_use_as_albedo = true
	bark.vertex_color_is_srgb = true
	bark.roughness = 1.0
	return bark


static func _foliage() -> ShaderMaterial:
	var foliage := ShaderMaterial.new()
	foliage.shader = Foliage
	foliage.set_shader_parameter("twig", ImageTexture.create_from_image(_twig()))
	return foliage


## Returns a crown whose tree is 1 high: cards in the parts' shells, most of them outside.
func _crown() -> ArrayMesh:
	var random := RandomNumberGenerator.new()
	random.seed = 9
	var surface := SurfaceTool.new()
	surface.begin(Mesh.PRIMITIVE_TRIANGLES)
	var cards := 0
	for part in PARTS:
		for card in CARDS:
			var out := Vector3(random.randfn(), random.randfn(), random.randfn()).normalized()
			var away := lerpf(1.05, INSIDE, pow(random.randf(), 2.0))
			var middle: Vector3 = part[0] + out * away * part[1]
			var light := lerpf(SHADE, 1.0, smoothstep(-0.7, 0.7, out.y) * smoothstep(INSIDE - 0.1, 1.05, away))
			light *= lerpf(0.75, 1.0, smoothstep(0.3, 0.8, middle.y)) * random.randf_range(0.85, 1.1)
			_add_card(surface, 4 * cards, middle, (out + 0.6 * (middle - PARTS[0][0]) + 0.25 * Vector3.UP).normalized(), light, random)
			cards += 1
	return surface.commit()


func _add_card(surface: SurfaceTool, first: int, middle: Vector3, normal: Vector3, light: float, random: RandomNumberGenerator) -> void:
	var axis := Vector3(random.randfn(), random.randfn(), random.randfn()).normalized()
	var across := axis.cross(normal).normalized()
	var along := across.cross((normal + 0.8 * axis).normalized()).normalized()
	var half := random.randf_range(CARD.x, CARD.y)
	for corner: Vector2 in [Vector2(-1, -1), Vector2(1, -1), Vector2(-1, 1), Vector2(1, 1)]:
		var off := (across * corner.x + along * corner.y) * half
		surface.set_color(Color(light, light, light))
		surface.set_normal((normal + 1.5 * off).normalized())
		surface.set_uv(0.5 * corner + Vector2(0.5, 0.5))
		surface.add_vertex(middle + off)
	for index: int in [0, 1, 2, 2, 1, 3]:
		surface.add_index(first + index)


## Leaves in a loose round, white and transparent, some lighter than others.
static func _twig() -> Image:
	var random := RandomNumberGenerator.new()
	random.seed = 4
	var image := Image.create_empty(PICTURE, PICTURE, false, Image.FORMAT_RGBA8)
	image.fill(Color(0.75, 0.75, 0.75, 0.0))
	for leaf in LEAVES_ON_CARD:
		var at := Vector2.from_angle(TAU * random.randf()) * (0.43 * sqrt(random.randf())) + Vector2(0.5, 0.5)
		var way := (at - Vector2(0.5, 0.5)).normalized().rotated(random.randf_range(-0.9, 0.9))
		_draw_leaf(image, at, way, random.randf_range(0.045, 0.08), lerpf(0.55, 1.0, leaf / (LEAVES_ON_CARD - 1.0)))
	image.generate_mipmaps()
	return image


## `at`: its middle; `half`: half its length; in sides of the image.
static func _draw_leaf(image: Image, at: Vector2, way: Vector2, half: float, light: float) -> void:
	var low := Vector2i(((at - Vector2.ONE * half) * PICTURE).max(Vector2.ZERO))
	var high := Vector2i(((at + Vector2.ONE * half) * PICTURE).min(Vector2.ONE * (PICTURE - 1)))
	for y in range(low.y, high.y + 1):
		for x in range(low.x, high.x + 1):
			var off := (Vector2(x + 0.5, y + 0.5) / PICTURE - at) / half
			var along := off.dot(way)
			var across := absf(off.cross(way))
			if absf(along) < 1.0 and across < 0.42 * (1.0 - along * along):
				var shine := light * (0.8 if across < 0.05 else 1.0)
				image.set_pixel(x, y, Color(shine, shine, shine))

# SPDX-License-Identifier: MIT
## Trees in groves, some of them poplars, with bushes among the others: a trunk with limbs, and a crown of cards with leaves that is darker
## inside and below. Two draw calls a kind.
extends Node3D

const GROVES := 26
const IN_GROVE := Vector2i(1, 11)  # trees, fewest and most
const SPREAD := 18.0  # metres, from the middle of a grove
const LEAVES: Array[Color] = [
	Color(0.44, 0.53, 0.23), Color(0.51, 0.58, 0.27), Color(0.36, 0.49, 0.23), Color(0.46, 0.55, 0.33), Color(0.48, 0.54, 0.25)
]
const BARK := Color(0.4, 0.35, 0.29)
## The shapes of trees. height: least and most, metres. In heights: crown, of the lowest and of the highest part; part, about half the
## width of one, least and most; card, half the side of one, least and most; trunk, its radius above its foot. tall: height of a part over
## its width.
const ROUND := {
	height = Vector2(6.0, 13.0),
	crown = Vector2(0.3, 0.92),
	part = Vector2(0.07, 0.13),
	card = Vector2(0.036, 0.064),
	trunk = 0.021,
	tall = 0.75
}
const SLIM := {
	height = Vector2(12.0, 18.0),
	crown = Vector2(0.12, 0.93),
	part = Vector2(0.02, 0.065),
	card = Vector2(0.022, 0.042),
	trunk = 0.01,
	tall = 2.2
}
const LOW := {
	height = Vector2(1.5, 3.2),
	crown = Vector2(0.1, 0.8),
	part = Vector2(0.15, 0.22),
	card = Vector2(0.06, 0.1),
	trunk = 0.02,
	tall = 0.75,
}
const KINDS: Array[Dictionary] = [ROUND, ROUND, ROUND, SLIM, LOW]
const WIDEST: Array[float] = [0.25, 0.19, 0.3, 0.05, 0.5]  # heights from the trunk to the middle of a part, at most, of each kind
const BROAD := 3  # kinds that are neither of the next two
const POPLAR := 3
const BUSH := 4
const POPLARS := 5  # of so many groves one has only poplars
const BUSHES := 0.35  # of the plants in other groves
const PARTS := 19  # of a crown, each at the end of a limb; lengths here are in heights of the tree
const FORK := 0.55  # where a limb leaves the trunk, over the height of its part
const FOOT := 1.9  # radius there over that
const SIDES := 7  # of trunks and limbs
const CARDS := 38  # of a part
const SHADE := 0.68  # of the light inside of the crown and on its underside
const PICTURE := 256  # texels, the side of the picture of a twig
const SPRIGS := 9  # on a card, each with leaves on both sides
const PAIRS := 12  # of leaves on a sprig

const Hills := preload("res://demo/walk/hills.gd")
const SHADER := "res://demo/walk/foliage.gdshader"

var count := 0  ## trees
var others: Array[Vector3] = []  ## places of trees besides those in groves

static var _leaves: ShaderMaterial  # of all trees

var _places: Array[Array] = []  # Transform3D, for each kind


## Plants groves on the hills, from `near` to `far` metres from the middle. The same numbers give the same trees.
func make(hills: Hills, near: float, far: float) -> void:
	var random := RandomNumberGenerator.new()
	random.seed = 5
	_places.assign(KINDS.map(func(_kind: Dictionary) -> Array: return []))
	for grove in GROVES:
		var way := TAU * (grove + random.randf()) / GROVES
		var away := lerpf(near, far, pow(random.randf(), 1.7))  # most of them near
		for tree in random.randi_range(IN_GROVE.x, IN_GROVE.y):
			var off := Vector2.from_angle(TAU * random.randf()) * SPREAD * sqrt(random.randf())
			var place := Vector2.from_angle(way) * (away + SPREAD) + off
			var foot := Vector3(place.x, hills.ground_at(place) - 0.3, place.y)
			if foot.y > hills.water:
				var other := BUSH if random.randf() < BUSHES else tree % BROAD
				_plant(foot, POPLAR if grove % POPLARS == 2 else other, random)
	for i in others.size():
		_plant(others[i], i % BROAD, random)
	var bark := _bark()
	var foliage := _foliage()
	for kind in KINDS.size():
		var parts := _parts(kind)
		_add(_trunk(parts, KINDS[kind]), _places[kind], bark, [BARK], random)
		_add(_crown(parts, KINDS[kind]), _places[kind], foliage, LEAVES, random)
		count += _places[kind].size()


## Covers all trees with snow, and wets them; each 0 to 1.
static func cover(snow: float, wetness: float) -> void:
	_foliage().set_shader_parameter("snow", snow)
	_foliage().set_shader_parameter("wetness", wetness)


func _plant(foot: Vector3, kind: int, random: RandomNumberGenerator) -> void:
	var height := random.randf_range(KINDS[kind].height.x, KINDS[kind].height.y)
	var turned := Basis(Vector3.UP, TAU * random.randf())
	var wide := height * random.randf_range(0.85, 1.15)
	_places[kind].append(Transform3D(turned.scaled(Vector3(wide, height, wide)), foot))


func _add(mesh: Mesh, places: Array, material: Material, colors: Array[Color], random: RandomNumberGenerator) -> void:
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
	if _leaves == null:
		_leaves = ShaderMaterial.new()
		_leaves.shader = load(SHADER)
		_leaves.set_shader_parameter("twig", ImageTexture.create_from_image(_twig()))
	return _leaves


## Returns the middles of a crown's parts, around the trunk and upwards, and about half their widths: in w.
static func _parts(kind: int) -> Array[Vector4]:
	var crown: Vector2 = KINDS[kind].crown
	var part_size: Vector2 = KINDS[kind].part
	var random := RandomNumberGenerator.new()
	random.seed = 21 + kind
	var parts: Array[Vector4] = []
	for part in PARTS:
		var up := (part + random.randf()) / PARTS
		var away := WIDEST[kind] * sqrt(sin(PI * lerpf(0.25, 0.98, up))) * random.randf_range(0.35, 1.15)
		var side := Vector2.from_angle(2.4 * part + random.randf_range(-0.5, 0.5)) * away
		parts.append(
			Vector4(side.x, lerpf(crown.x, crown.y, up), side.y, lerpf(part_size.y, part_size.x, up * random.randf_range(0.5, 1.0)))
		)
	return parts


## Makes the trunk of a tree that is 1 high, and a limb to each part of its crown.
static func _trunk(parts: Array[Vector4], kind: Dictionary) -> ArrayMesh:
	var top: float = kind.crown.y
	var wide: float = kind.trunk
	var surface := SurfaceTool.new()
	surface.begin(Mesh.PRIMITIVE_TRIANGLES)
	surface.set_color(Color.WHITE)
	var rings: Array[Vector2] = [
		Vector2(0.0, FOOT), Vector2(0.03, 1.25), Vector2(0.1, 1.0), Vector2(0.4 * top + 0.03, 0.85), Vector2(top, 0.2)
	]
	for i in rings.size() - 1:
		_add_tube(surface, rings[i].x * Vector3.UP, rings[i + 1].x * Vector3.UP, rings[i].y * wide, rings[i + 1].y * wide)
	for part in parts:
		var end := Vector3(part.x, part.y, part.z)
		var from := FORK * part.y * Vector3.UP
		var elbow := from.lerp(end, 0.5) - 0.03 * Vector3.UP
		_add_tube(surface, from, elbow, 0.5 * wide, 0.3 * wide)
		_add_tube(surface, elbow, end, 0.3 * wide, 0.1 * wide)
	surface.index()
	return surface.commit()


static func _add_tube(surface: SurfaceTool, from: Vector3, to: Vector3, first: float, last: float) -> void:
	var along := (to - from).normalized()
	var across := along.cross(Vector3(0.3, 0.1, 0.9)).normalized()
	for side in SIDES:
		var a := across.rotated(along, TAU * side / SIDES)
		var b := across.rotated(along, TAU * (side + 1) / SIDES)
		var ring: Array[Vector3] = [a, b, a, a, b, b]
		var up: Array[bool] = [false, false, true, true, false, true]
		for corner in ring.size():
			surface.set_normal(ring[corner])
			surface.add_vertex((to + ring[corner] * last) if up[corner] else (from + ring[corner] * first))


## Makes the crown of a tree that is 1 high: cards around the parts' middles, fewer with the distance, so that no outline is round.
static func _crown(parts: Array[Vector4], kind: Dictionary) -> ArrayMesh:
	var heights: Vector2 = kind.crown
	var sizes: Vector2 = kind.card
	var random := RandomNumberGenerator.new()
	random.seed = 9
	var surface := SurfaceTool.new()
	surface.begin(Mesh.PRIMITIVE_TRIANGLES)
	var heart := Vector3(0.0, 0.5 * (heights.x + heights.y), 0.0)
	var cards := 0
	for part in parts:
		for card in CARDS:
			var out := Vector3(random.randfn(), random.randfn(), random.randfn()).normalized()
			var away := absf(random.randfn(0.75, 0.3))
			var middle := Vector3(part.x, part.y, part.z) + out * away * part.w * Vector3(1.0, kind.tall, 1.0)
			var from_heart := (middle - heart) * Vector3(1.0, 0.75, 1.0)
			var outside := smoothstep(0.03, 0.26, from_heart.length())
			var light := lerpf(SHADE, 1.0, outside) * lerpf(SHADE, 1.0, smoothstep(-0.5, 0.6, 0.6 * out.y + 2.0 * from_heart.y))
			var half := random.randf_range(sizes.x, sizes.y)
			_add_card(surface, 4 * cards, middle, (0.5 * out + 3.0 * from_heart + 0.3 * Vector3.UP).normalized(), half, light, random)
			cards += 1
	return surface.commit()


static func _add_card(
	surface: SurfaceTool, first: int, middle: Vector3, normal: Vector3, half: float, light: float, random: RandomNumberGenerator
) -> void:
	var axis := Vector3(random.randfn(), random.randfn(), random.randfn()).normalized()
	var across := axis.cross(normal).normalized()
	var along := across.cross((normal + 0.8 * axis).normalized()).normalized()
	for corner: Vector2 in [Vector2(-1, -1), Vector2(1, -1), Vector2(-1, 1), Vector2(1, 1)]:
		var off := (across * corner.x + along * corner.y) * half
		surface.set_color(Color(1, 1, 1, light))
		surface.set_normal((normal + 1.5 * off).normalized())
		surface.set_uv(0.5 * corner + Vector2(0.5, 0.5))
		surface.add_vertex(middle + off)
	for index: int in [0, 1, 2, 2, 1, 3]:
		surface.add_index(first + index)


## Draws sprigs with leaves that spread from the middle, white and transparent, the upper ones lighter. Between them is nothing: far away
## a card would otherwise become a disc.
static func _twig() -> Image:
	var random := RandomNumberGenerator.new()
	random.seed = 4
	var image := Image.create_empty(PICTURE, PICTURE, false, Image.FORMAT_RGBA8)
	image.fill(Color(0.85, 0.85, 0.85, 0.0))
	for sprig in SPRIGS:
		var way := Vector2.from_angle(TAU * (sprig + 0.6 * random.randf()) / SPRIGS)
		var reach := random.randf_range(0.3, 0.47)
		var bend := random.randf_range(-0.5, 0.5)
		for pair in PAIRS:
			var along := (pair + random.randf()) / PAIRS
			var at := Vector2(0.5, 0.5) + way.rotated(bend * along) * reach * along
			var light := lerpf(0.72, 1.0, along) * random.randf_range(0.88, 1.0)
			for side: float in [-0.8, 0.8]:
				var points := way.rotated(bend * along + side + random.randf_range(-0.3, 0.3))
				var half := random.randf_range(0.026, 0.042)
				_draw_leaf(image, at + points * half, points, half, light * (1.0 if side > 0.0 else 0.92))
	image.generate_mipmaps()
	return image


## Draws a leaf. `at`: its middle; `half`: half its length; in sides of the image.
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

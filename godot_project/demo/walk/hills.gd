# SPDX-License-Identifier: MIT
## The ground: a square of hills with collision, one height a metre, level in its middle; and hills to the horizon, which are only drawn.
## Grass draws the ground below it by itself, so these hills are a little lower there. A terrain may lie in the middle: then they go on from
## its border.
extends StaticBody3D

const Terrain := preload("res://demo/terrain.gd")
const SHADER := "res://demo/walk/hills.gdshader"
const STEP := 4  # metres from one height of the noise to the next; heights between them are interpolated
const FAR_STEP := 16.0  # metres, of the hills to the horizon
const FAR := 1600.0  # metres, from the middle to their end
const RELIEF := 26.0  # metres
const EARTH := Color(0.4, 0.48, 0.2)  # at the horizon: about the colour of far grass
const FIRST_FIELD := 350.0  # metres from the middle, at least, from where on there are fields, hedges and woods
const SUNK := 0.4  # metres that the hills to the horizon are lower where the grass ends
const BELOW_GRASS := 3.0  # metres that they are lower farther in, where their long edges would bridge hollows and show through the grass
const BELOW_TERRAIN := 8.0  # metres that they are lower at a terrain, whose every bump they do not follow
const BLEND := 70.0  # metres from a terrain's border to where the hills are as without it
const SEAM := 8  # metres from a terrain's border to where heights of the noise are interpolated: right beside it that would leave a ditch

var side := 0  ## metres
var level := 0.0  ## metres from the middle up to which the ground is level at height 0; 0: a gently waved middle
var terrain: Terrain  ## in the middle; null: none
var water := -INF  ## height of lakes, in which no trees grow
var shape := HeightMapShape3D.new()

var _material := ShaderMaterial.new()
var _noise := FastNoiseLite.new()


func make(p_side: int) -> void:
	side = p_side
	_noise.noise_type = FastNoiseLite.TYPE_SIMPLEX
	_noise.seed = 11
	_noise.frequency = 0.0045
	_noise.fractal_octaves = 3
	_noise.fractal_gain = 0.35
	var count := int(float(side) / STEP) + 1
	var heights := PackedFloat32Array()
	for z in count:
		for x in count:
			heights.append(_rise(Vector2(x * STEP - 0.5 * side, z * STEP - 0.5 * side)))
	var image := Image.create_from_data(count, count, false, Image.FORMAT_RF, heights.to_byte_array())
	image.resize(side + 1, side + 1, Image.INTERPOLATE_CUBIC)
	shape.map_width = side + 1
	shape.map_depth = side + 1
	shape.map_data = image.get_data().to_float32_array()
	if terrain:
		_lay(terrain)
	var collider := CollisionShape3D.new()
	collider.shape = shape
	add_child(collider)
	_material.shader = load(SHADER)
	_material.set_shader_parameter("earth", EARTH)
	_material.set_shader_parameter("begin", maxf(0.5 * side, FIRST_FIELD))
	var look := MeshInstance3D.new()
	look.mesh = _mesh()
	look.material_override = _material
	look.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	look.gi_mode = GeometryInstance3D.GI_MODE_DISABLED
	add_child(look)


## Covers the hills to the horizon with snow, and wets them; each 0 to 1.
func cover(snow: float, wetness: float) -> void:
	_material.set_shader_parameter("snow", snow)
	_material.set_shader_parameter("wetness", wetness)


## Height above the node at a place, metres: that of the shape's squares.
func height_at(place: Vector3) -> float:
	var at := (Vector2(place.x, place.z) + Vector2.ONE * 0.5 * side).clampf(0.0, side - 1e-3)
	var cell := Vector2i(at)
	var part := at - Vector2(cell)
	var width := side + 1
	var first := cell.y * width + cell.x
	var heights := shape.map_data
	var near := lerpf(heights[first], heights[first + 1], part.x)
	return lerpf(near, lerpf(heights[first + width], heights[first + width + 1], part.x), part.y)


## Returns the least height at the corners and in the middle of a rectangle, metres.
func lowest_in(area: Rect2) -> float:
	var least := INF
	for share: Vector2 in [Vector2.ZERO, Vector2.RIGHT, Vector2.DOWN, Vector2.ONE, 0.5 * Vector2.ONE]:
		var at := area.position + share * area.size
		least = minf(least, height_at(Vector3(at.x, 0.0, at.y)))
	return least


## Height above the node at a place on the hills as far as they are drawn, metres.
func ground_at(place: Vector2) -> float:
	return _rise(place)


## Returns the point `above` metres over the ground at a place.
func on_ground(place: Vector3, above := 0.0) -> Vector3:
	return Vector3(place.x, height_at(place) + above, place.z)


## Returns the normal of the ground at a place.
func normal_at(place: Vector3) -> Vector3:
	var x := height_at(place + Vector3.RIGHT) - height_at(place + Vector3.LEFT)
	var z := height_at(place + Vector3.BACK) - height_at(place + Vector3.FORWARD)
	return Vector3(-0.5 * x, 1.0, -0.5 * z).normalized()


## Higher with the distance from the middle: a meadow among hills, and mountains at the horizon.
func _rise(place: Vector2) -> float:
	var far := place.length()
	var steepness := lerpf(0.12, 1.0, smoothstep(15.0, 220.0, far)) + 1.6 * smoothstep(500.0, 1500.0, far)
	var rise := RELIEF * steepness * _noise.get_noise_2d(place.x, place.y) + 12.0 * smoothstep(60.0, 500.0, far)
	if terrain:
		var beside := place.clampf(-0.5 * terrain.size, 0.5 * terrain.size)
		return lerpf(terrain.height_at(beside.x, beside.y), rise, _beyond_terrain(place))
	return rise if level == 0.0 else rise * smoothstep(level, 2.0 * level + 80.0, far)


## 0 on a terrain, 1 where the hills are as without it.
func _beyond_terrain(place: Vector2) -> float:
	if terrain == null:
		return 1.0
	return smoothstep(0.0, BLEND, place.distance_to(place.clampf(-0.5 * terrain.size, 0.5 * terrain.size)))


## Takes over the heights of a terrain, which stands on the same metres, and those beside it.
func _lay(p_terrain: Terrain) -> void:
	var heights := shape.map_data
	var half := p_terrain.size >> 1
	for z in range(-half - SEAM, half + SEAM + 1):
		for x in range(-half - SEAM, half + SEAM + 1):
			var index := (z + (side >> 1)) * (side + 1) + x + (side >> 1)
			var beyond := maxf(absf(x), absf(z)) - half
			var height := p_terrain.height_at(x, z) if beyond <= 0.0 else _rise(Vector2(x, z))
			heights[index] = lerpf(height, heights[index], smoothstep(0.0, SEAM, beyond))
	shape.map_data = heights


## Metres that the hills to the horizon are lower at a place.
func _sunk(place: Vector2) -> float:
	var inside := 0.5 * side - maxf(absf(place.x), absf(place.y))
	return lerpf(BELOW_TERRAIN, BELOW_GRASS if inside > 2.0 * FAR_STEP else SUNK, _beyond_terrain(place))


func _mesh() -> ArrayMesh:
	var reach := maxf(FAR, 1.5 * side)
	var count := int(2.0 * reach / FAR_STEP) + 1
	var points := PackedVector3Array()
	var normals := PackedVector3Array()
	for z in count:
		for x in count:
			var at := Vector2(x, z) * FAR_STEP - Vector2.ONE * reach
			points.append(Vector3(at.x, _rise(at) - _sunk(at), at.y))
	for z in count:
		for x in count:
			var across := points[z * count + mini(x + 1, count - 1)] - points[z * count + maxi(x - 1, 0)]
			var along := points[mini(z + 1, count - 1) * count + x] - points[maxi(z - 1, 0) * count + x]
			normals.append(along.cross(across).normalized())
	var indices := PackedInt32Array()
	for z in count - 1:
		for x in count - 1:
			var first := z * count + x
			indices.append_array([first, first + 1, first + count, first + 1, first + count + 1, first + count])
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = points
	arrays[Mesh.ARRAY_NORMAL] = normals
	arrays[Mesh.ARRAY_INDEX] = indices
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh

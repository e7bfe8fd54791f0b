# SPDX-License-Identifier: MIT
## Makes the meshes of the presets fern, ox-eye daisy and small shrub, and writes them into the add-on:
## `godot --headless --path godot_project --script res://demo/plant_meshes.gd`. Each is one stem, one unit high; its blade determines its
## size. Blades lean towards +z, so upper sides of leaves face -z. A stem has at most 150 vertices, since each is posed for every plant near
## a camera: fine outlines are in a texture's alpha.
extends SceneTree

const MOST_VERTICES := 150
const PICTURE := Vector2i(64, 128)  # texels; beside it a texture has a strip that is white, for stalks
const STRIP := 16
const OPAQUE := Vector2((PICTURE.x + 0.6 * STRIP) / (PICTURE.x + STRIP), 0.5)
const HEAD := 0.7  # size of a daisy's head; with 1 it would be as wide as a hand
const FOLDER := "res://addons/grass_field/presets/plants/"

var _places: PackedVector3Array
var _normals: PackedVector3Array
var _colors: PackedColorArray
var _uvs: PackedVector2Array
var _indices: PackedInt32Array
var _texture: Image  # null: none
var _dice := RandomNumberGenerator.new()


func _init() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	for plant: String in ["fern", "ox_eye_daisy", "small_shrub"]:
		_begin()
		call("_grow_" + plant)
		_save(plant)
	quit()


func _begin() -> void:
	_places.clear()
	_normals.clear()
	_colors.clear()
	_uvs.clear()
	_indices.clear()
	_texture = null
	_dice.seed = 7


func _save(plant: String) -> void:
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = _places
	arrays[Mesh.ARRAY_NORMAL] = _normals
	arrays[Mesh.ARRAY_COLOR] = _colors
	arrays[Mesh.ARRAY_TEX_UV] = _uvs
	arrays[Mesh.ARRAY_INDEX] = _indices
	var material := StandardMaterial3D.new()
	material.vertex_color_use_as_albedo = true
	material.vertex_color_is_srgb = true
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	if _texture:
		_texture.generate_mipmaps()
		material.albedo_texture = ImageTexture.create_from_image(_texture)
		material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA_SCISSOR
		material.alpha_scissor_threshold = 0.5
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	mesh.surface_set_material(0, material)
	assert(_places.size() <= MOST_VERTICES)
	var error := ResourceSaver.save(mesh, FOLDER + plant + ".res", ResourceSaver.FLAG_COMPRESS)
	print("%s: %d vertices, %d triangles, %s" % [plant, _places.size(), _indices.size() / 3, error_string(error)])


func _point(place: Vector3, normal: Vector3, color: Color, uv := OPAQUE) -> int:
	_uvs.append(uv)
	_places.append(place)
	_normals.append(normal.normalized())
	_colors.append(color)
	return _places.size() - 1


## A stalk of three sides through `places`; it gets thinner from `thick` to `thin`.
func _stalk(places: PackedVector3Array, thick: float, thin: float, low: Color, high: Color) -> void:
	var rings := places.size()
	var along := (places[rings - 1] - places[0]).normalized()
	var side := along.cross(Vector3.RIGHT if absf(along.x) < 0.7 else Vector3.BACK).normalized()
	var first := _places.size()
	for ring in rings:
		var t := ring / (rings - 1.0)
		for i in 3:
			var out := side.rotated(along, TAU * i / 3.0)
			_point(places[ring] + out * lerpf(thick, thin, t), out, low.lerp(high, t))
	for ring in rings - 1:
		for i in 3:
			var a := first + 3 * ring + i
			var b := first + 3 * ring + (i + 1) % 3
			_indices.append_array([a, b, a + 3, a + 3, b, b + 3])


## A leaf from `from` along `along`, folded a little along its middle; `up` is its upper side. Eight vertices.
func _leaf(from: Vector3, along: Vector3, up: Vector3, width: float, low: Color, high: Color, widest := 0.4) -> void:
	var across := along.cross(up).normalized()
	var normal := across.cross(along).normalized()
	var last: PackedInt32Array = [_point(from, normal, low)]
	for row: Vector2 in [Vector2(widest, 1.0), Vector2(0.5 + 0.5 * widest, 0.72), Vector2(1.0, 0.0)]:
		var middle := from + along * row.x - normal * (0.12 * along.length() * row.x * row.x)
		var color := low.lerp(high, row.x)
		var wide := width * row.y
		var now: PackedInt32Array = [_point(middle, normal, color.darkened(0.12))]
		if wide > 0.0:
			now.append(_point(middle - across * wide + normal * wide * 0.3, normal - 0.5 * across, color))
			now.append(_point(middle + across * wide + normal * wide * 0.3, normal + 0.5 * across, color))
		for side in [1, 2]:
			if now.size() > 1 and last.size() > 1:
				_indices.append_array([last[0], last[side], now[0], now[0], last[side], now[side]])
			elif now.size() > 1:
				_indices.append_array([last[0], now[side], now[0]])
			else:
				_indices.append_array([last[0], last[side], now[0]])
		last = now


## A rectangle that shows the texture's picture from `from` along `along`, `folded` along its middle. Six vertices.
func _sheet(from: Vector3, along: Vector3, up: Vector3, width: float, low: Color, high: Color, folded := 0.45) -> void:
	var across := along.cross(up).normalized()
	var normal := across.cross(along).normalized()
	var first := _places.size()
	for row in 2:
		var middle := from + along * row - normal * (0.1 * along.length() * row)
		for side in 3:
			var out := (side - 1.0) * across
			var lift := normal * (folded / 1.8 * width * absf(side - 1.0))
			_point(
				middle + out * width + lift,
				normal + folded * out,
				low if row == 0 else high,
				Vector2(0.5 * side * PICTURE.x / (PICTURE.x + STRIP), 1.0 - row)
			)
	for side in 2:
		var a := first + side
		_indices.append_array([a, a + 1, a + 3, a + 3, a + 1, a + 4])


## A picture, white and transparent, whose texels `shade` chooses: of a place across (-1 to 1) and along (0 to 1) it returns lightness and
## whether it is opaque.
func _draw(shade: Callable) -> Image:
	const FINER := 4
	var image := Image.create_empty(PICTURE.x + STRIP, PICTURE.y, false, Image.FORMAT_RGBA8)
	image.fill(Color.WHITE)
	for y in PICTURE.y:
		for x in PICTURE.x:
			var light := 0.0
			var opaque := 0
			for n in FINER * FINER:
				var across := (x + (n % FINER + 0.5) / FINER) / PICTURE.x * 2.0 - 1.0
				var along := 1.0 - (y + (n / FINER + 0.5) / FINER) / PICTURE.y
				var texel: Vector2 = shade.call(across, along)
				light += texel.x * texel.y
				opaque += int(texel.y)
			light = light / opaque if opaque > 0 else 0.9
			image.set_pixel(x, y, Color(light, light, light, float(opaque) / (FINER * FINER)))
	return image


## Returns a pinna of a fern: lobes along a midrib.
func _pinna(across: float, along: float) -> Vector2:
	var wide := minf(along / 0.1, 1.0) * pow(maxf(1.0 - along, 0.0), 0.62) * 0.97
	var row := 9.0 * pow(along, 0.85) - 0.8 * absf(across) + (0.45 if across > 0.0 else 0.0)
	var lobe := absf(sin(PI * row))
	var is_leaf := absf(across) < wide * lerpf(0.42, 1.0, pow(lobe, 0.5)) or absf(across) < 0.1 * (1.0 - along)
	var light := 0.9 + 0.1 * sin(12.9 * floorf(row) + (2.0 if across > 0.0 else 0.0))
	return Vector2(0.86 if absf(across) < 0.05 else light * lerpf(0.93, 1.0, lobe), float(is_leaf))


## One frond: pinnae in pairs along a stalk, longest in its lower half.
func _grow_fern() -> void:
	var stalk := Color(0.34, 0.3, 0.13)
	var low := Color(0.3, 0.43, 0.16)
	var high := Color(0.54, 0.67, 0.27)
	_texture = _draw(_pinna)
	_stalk([Vector3.ZERO, Vector3(0, 0.5, 0), Vector3(0, 0.97, 0)], 0.013, 0.003, stalk, stalk.lerp(low, 0.9))
	const PAIRS := 11
	for i in PAIRS:
		var t := 0.16 + 0.79 * pow(float(i) / (PAIRS - 1), 0.92)
		var size := 0.28 * pow(sin(PI * pow((t - 0.08) / 0.95, 0.62)), 0.85) + 0.014
		for side: float in [-1.0, 1.0]:
			var rise := 0.28 + 0.5 * t + _dice.randf_range(-0.06, 0.06)
			var along := Vector3(side, rise, _dice.randf_range(-0.1, 0.3)).normalized() * size * _dice.randf_range(0.8, 1.08)
			var fresh := low.lerp(high, clampf(0.3 + 0.45 * t + _dice.randf_range(-0.22, 0.22), 0.0, 1.0))
			var up := Vector3(_dice.randf_range(-0.35, 0.35), 0.15 + _dice.randf_range(-0.3, 0.3), -1)
			var from := Vector3(0, t + side * 0.006 + _dice.randf_range(-0.008, 0.008), 0)
			_sheet(from, along, up, 0.21 * size + 0.01, fresh.darkened(0.2), fresh, 0.2)
	_sheet(Vector3(0, 0.93, 0), Vector3(0, 0.07, 0.0), Vector3(0, 0, -1), 0.02, high, high)


## One stalk with leaves that get smaller upwards, and a head of white rays around a yellow disc.
func _grow_ox_eye_daisy() -> void:
	var stalk := Color(0.38, 0.49, 0.22)
	var leaf := Color(0.28, 0.41, 0.17)
	_stalk([Vector3.ZERO, Vector3(0, 0.5, 0), Vector3(0, 0.97, 0)], 0.0075, 0.0065, stalk.darkened(0.2), stalk)
	const LEAVES := 7
	for i in LEAVES:
		var t := 0.03 + 0.6 * pow(i / (LEAVES - 1.0), 1.3)
		var turn := 2.4 * i + _dice.randf_range(-0.3, 0.3)
		var out := Vector3(cos(turn), 0.0, sin(turn))
		var size := lerpf(0.21, 0.08, i / (LEAVES - 1.0))
		var along := (out + Vector3.UP * lerpf(0.35, 1.1, i / (LEAVES - 1.0))).normalized() * size
		_leaf(Vector3(0, t, 0), along, Vector3.UP - 0.3 * out, 0.14 * size + 0.004, leaf.darkened(0.15), leaf.lightened(0.06), 0.6)
	var facing := Vector3(0.12, 1.0, 0.38).normalized()
	var centre := Vector3(0, 0.965, 0)
	var right := facing.cross(Vector3.BACK).normalized()
	var front := right.cross(facing).normalized()
	_cup(centre - HEAD * facing * 0.012, facing, right, front, Color(0.24, 0.4, 0.14))
	const RAYS := 16
	for i in RAYS:
		var turn := TAU * i / RAYS + _dice.randf_range(-0.06, 0.06)
		var out := right * cos(turn) + front * sin(turn)
		_ray(centre, out, facing, HEAD * 0.098 * _dice.randf_range(0.93, 1.04), _dice.randf_range(-0.16, 0.1), i % 2 * HEAD * 0.0015)
	_disc(centre, facing, right, front)


func _ray(centre: Vector3, out: Vector3, facing: Vector3, size: float, droop: float, lift: float) -> void:
	var across := out.cross(facing).normalized()
	var high := Color(0.97, 0.97, 0.95)
	var tip := centre + out * size + facing * (size * droop + lift)
	var normal := facing + 0.25 * out
	var first := _point(centre + HEAD * out * 0.02 + facing * lift, normal, Color(0.86, 0.87, 0.8))
	for side: float in [-1.0, 1.0]:
		_point(tip + HEAD * (across * side * 0.0155 - out * 0.012), normal + 0.35 * side * across, high)
	_point(tip + HEAD * out * 0.004, normal, high)
	_indices.append_array([first, first + 1, first + 2, first + 1, first + 3, first + 2])


func _disc(centre: Vector3, facing: Vector3, right: Vector3, front: Vector3) -> void:
	var top := _point(centre + HEAD * facing * 0.017, facing, Color(0.9, 0.66, 0.07))
	const SIDES := 8
	for i in SIDES:
		var out := right * cos(TAU * i / SIDES) + front * sin(TAU * i / SIDES)
		_point(centre + HEAD * (out * 0.031 + facing * 0.003), facing + out, Color(0.82, 0.54, 0.04))
	for i in SIDES:
		_indices.append_array([top, top + 1 + i, top + 1 + (i + 1) % SIDES])


func _cup(centre: Vector3, facing: Vector3, right: Vector3, front: Vector3, color: Color) -> void:
	var low := _point(centre - HEAD * facing * 0.012, -facing, color.darkened(0.2))
	const SIDES := 6
	for i in SIDES:
		var out := right * cos(TAU * i / SIDES) + front * sin(TAU * i / SIDES)
		_point(centre + HEAD * (out * 0.034 + facing * 0.01), out - facing, color)
	for i in SIDES:
		_indices.append_array([low, low + 1 + i, low + 1 + (i + 1) % SIDES])


## Returns a twig with leaves on both sides.
func _twig(across: float, along: float) -> Vector2:
	const LEAVES := 15
	if absf(across) < 0.05 * (1.1 - along) and along < 0.93:
		return Vector2(0.62, 1.0)
	for j in LEAVES:
		var from := 0.06 + 0.78 * j / (LEAVES - 1.0)
		var side := 1.0 if j % 2 == 0 else -1.0
		var way := Vector2(0.86 * side, 0.5) if j < LEAVES - 1 else Vector2(0.0, 1.0)
		var size := lerpf(0.78, 0.42, j / (LEAVES - 1.0))
		# A texel is twice as long along the twig as across it.
		var at := Vector2(across, 2.0 * (along - from))
		var t := at.dot(way.normalized()) / size
		var off := absf(at.cross(way.normalized())) / size
		if t > 0.0 and t < 1.0 and off < 0.2 * pow(sin(PI * pow(t, 0.8)), 0.8):
			var is_rib := off < 0.025
			return Vector2((0.78 if is_rib else 1.0) * (0.82 + 0.18 * fposmod(0.37 * j, 1.0)), 1.0)
	return Vector2(1.0, 0.0)


## One stem of a low bush: leafy twigs all around it.
func _grow_small_shrub() -> void:
	var bark := Color(0.3, 0.22, 0.14)
	var top := Vector3(0.04, 0.8, 0.02)
	var knee := Vector3(0.03, 0.35, -0.01)
	_texture = _draw(_twig)
	_stalk([Vector3.ZERO, knee, top], 0.02, 0.007, bark, Color(0.33, 0.32, 0.14))
	const TWIGS := 23
	for i in TWIGS:
		var t := 0.18 + 0.82 * i / (TWIGS - 1.0)
		var turn := 2.39996 * i + 0.6
		var out := Vector3(cos(turn), 0.0, sin(turn))
		var from := knee.lerp(top, (t - 0.44) / 0.56) if t > 0.44 else knee * t / 0.44
		var size := lerpf(0.4, 0.2, t) * _dice.randf_range(0.7, 1.15)
		var along := (out * lerpf(1.0, 0.3, t) + Vector3.UP * lerpf(0.5, 1.2, t)).normalized() * size
		var fresh := clampf(0.2 + 0.6 * t + _dice.randf_range(-0.2, 0.2), 0.0, 1.0)
		var color := Color(0.28, 0.36, 0.2).lerp(Color(0.54, 0.62, 0.32), fresh)
		var up := (Vector3.UP + 0.4 * out).rotated(along.normalized(), _dice.randf_range(-0.9, 0.9))
		_sheet(from, along, up, 0.4 * size, color.darkened(0.2), color)

# SPDX-License-Identifier: MIT
## Makes the meshes of the presets fern, ox-eye daisy and small shrub, and writes them into the add-on:
## `godot --headless --path godot_project --script res://demo/plant_meshes.gd`. Each is one stem, one unit high; its blade determines its
## size. Blades lean towards +z, so upper sides of leaves face -z.
extends SceneTree

const FOLDER := "res://addons/grass_field/presets/plants/"

var _places: PackedVector3Array
var _normals: PackedVector3Array
var _colors: PackedColorArray
var _indices: PackedInt32Array
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
	_indices.clear()
	_dice.seed = 7


func _save(plant: String) -> void:
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = _places
	arrays[Mesh.ARRAY_NORMAL] = _normals
	arrays[Mesh.ARRAY_COLOR] = _colors
	arrays[Mesh.ARRAY_INDEX] = _indices
	var material := StandardMaterial3D.new()
	material.vertex_color_use_as_albedo = true
	material.vertex_color_is_srgb = true
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	mesh.surface_set_material(0, material)
	var error := ResourceSaver.save(mesh, FOLDER + plant + ".res", ResourceSaver.FLAG_COMPRESS)
	print("%s: %d vertices, %d triangles, %s" % [plant, _places.size(), _indices.size() / 3, error_string(error)])


func _point(place: Vector3, normal: Vector3, color: Color) -> int:
	_places.append(place)
	_normals.append(normal.normalized())
	_colors.append(color)
	return _places.size() - 1


## A stalk of three sides from `from` to `to`.
func _stalk(from: Vector3, to: Vector3, thick: float, thin: float, low: Color, high: Color) -> void:
	var along := (to - from).normalized()
	var side := along.cross(Vector3.RIGHT if absf(along.x) < 0.7 else Vector3.BACK).normalized()
	var first := _places.size()
	for i in 3:
		var out := side.rotated(along, TAU * i / 3.0)
		_point(from + out * thick, out, low)
		_point(to + out * thin, out, high)
	for i in 3:
		var a := first + 2 * i
		var b := first + 2 * ((i + 1) % 3)
		_indices.append_array([a, b, a + 1, a + 1, b, b + 1])


## A leaf from `from` along `along`, folded a little along its middle; `up` is its upper side. Its edge has `teeth` on each side.
func _leaf(from: Vector3, along: Vector3, up: Vector3, width: float, teeth: int, low: Color, high: Color, widest := 0.4) -> void:
	var across := along.cross(up).normalized()
	var normal := across.cross(along).normalized()
	var rows := maxi(2 * teeth, 3)
	var last: PackedInt32Array = []
	for row in rows + 1:
		var t := float(row) / rows
		# Rises to its widest place, then falls to the tip.
		var wide := width * pow(minf(t / widest, 1.0), 0.6) * sqrt(maxf(1.0 - pow(maxf(t - widest, 0.0) / (1.0 - widest), 2.0), 0.0))
		wide *= 0.72 if teeth > 1 and row % 2 == 0 else 1.0
		var middle := from + along * t - normal * (0.12 * along.length() * t * t)
		var color := low.lerp(high, t)
		var now: PackedInt32Array = [_point(middle, normal, color.darkened(0.12))]
		if row > 0 and row < rows:
			now.append(_point(middle - across * wide + normal * wide * 0.3, normal - 0.5 * across, color))
			now.append(_point(middle + across * wide + normal * wide * 0.3, normal + 0.5 * across, color))
		if row > 0:
			for side in [1, 2]:
				if now.size() > 1 and last.size() > 1:
					_indices.append_array([last[0], last[side], now[0], now[0], last[side], now[side]])
				elif now.size() > 1:
					_indices.append_array([last[0], now[side], now[0]])
				elif last.size() > 1:
					_indices.append_array([last[0], last[side], now[0]])
		last = now


## One frond: pinnae in pairs along a stalk, longest in its lower half, toothed.
func _grow_fern() -> void:
	var stalk := Color(0.34, 0.3, 0.13)
	var low := Color(0.24, 0.36, 0.13)
	var high := Color(0.47, 0.59, 0.24)
	for part in 4:
		var t := part / 4.0
		_stalk(
			Vector3(0, t, 0), Vector3(0, t + 0.25, 0), 0.012 * (1.05 - t), 0.012 * (0.8 - t), stalk.lerp(low, t), stalk.lerp(low, t + 0.25)
		)
	const PAIRS := 16
	for i in PAIRS:
		var t := 0.16 + 0.81 * pow(float(i) / (PAIRS - 1), 0.9)
		var size := 0.27 * pow(sin(PI * pow((t - 0.08) / 0.95, 0.62)), 0.85) + 0.012
		for side: float in [-1.0, 1.0]:
			var rise := 0.28 + 0.5 * t + _dice.randf_range(-0.06, 0.06)
			var along := Vector3(side, rise, _dice.randf_range(0.0, 0.22)).normalized() * size * _dice.randf_range(0.92, 1.05)
			var fresh := low.lerp(high, clampf(0.25 + 0.6 * t + _dice.randf_range(-0.12, 0.12), 0.0, 1.0))
			var from := Vector3(0, t + side * 0.006, 0)
			_leaf(from, along, Vector3(0, 0.15, -1), 0.1 * size + 0.005, 5 if size > 0.1 else 2, fresh.darkened(0.1), fresh, 0.25)
	_leaf(Vector3(0, 0.95, 0), Vector3(0, 0.05, 0.0), Vector3(0, 0, -1), 0.012, 1, high, high)


## One stalk with toothed leaves that get smaller upwards, and a head of white rays around a yellow disc.
func _grow_ox_eye_daisy() -> void:
	var stalk := Color(0.38, 0.49, 0.22)
	var leaf := Color(0.28, 0.41, 0.17)
	for part in 3:
		_stalk(Vector3(0, part / 3.0 * 0.97, 0), Vector3(0, (part + 1) / 3.0 * 0.97, 0), 0.0075, 0.0065, stalk.darkened(0.2), stalk)
	for i in 9:
		var t := 0.03 + 0.6 * pow(i / 8.0, 1.3)
		var turn := 2.4 * i + _dice.randf_range(-0.3, 0.3)
		var out := Vector3(cos(turn), 0.0, sin(turn))
		var size := lerpf(0.2, 0.08, i / 8.0)
		var along := (out + Vector3.UP * lerpf(0.35, 1.1, i / 8.0)).normalized() * size
		_leaf(Vector3(0, t, 0), along, Vector3.UP - 0.3 * out, 0.13 * size + 0.004, 4, leaf.darkened(0.15), leaf.lightened(0.06), 0.7)
	var facing := Vector3(0.12, 1.0, 0.38).normalized()
	var centre := Vector3(0, 0.965, 0)
	var right := facing.cross(Vector3.BACK).normalized()
	var front := right.cross(facing).normalized()
	_cup(centre - facing * 0.012, facing, right, front, Color(0.24, 0.4, 0.14))
	const RAYS := 21
	for i in RAYS:
		var turn := TAU * i / RAYS + _dice.randf_range(-0.05, 0.05)
		var out := right * cos(turn) + front * sin(turn)
		_ray(centre, out, facing, 0.098 * _dice.randf_range(0.93, 1.04), _dice.randf_range(-0.16, 0.1), i % 2 * 0.0015)
	_disc(centre, facing, right, front)


func _ray(centre: Vector3, out: Vector3, facing: Vector3, size: float, droop: float, lift: float) -> void:
	var across := out.cross(facing).normalized()
	var low := Color(0.86, 0.87, 0.8)
	var high := Color(0.97, 0.97, 0.95)
	var tip := centre + out * size + facing * (size * droop + lift)
	var middle := centre + out * size * 0.6 + facing * (size * droop * 0.25 + 0.004 + lift)
	var root := centre + out * 0.02 + facing * lift
	var normal := facing + 0.25 * out
	var first := _point(root - across * 0.004, normal, low)
	_point(root + across * 0.004, normal, low)
	_point(middle - across * 0.0135, normal - 0.4 * across, high)
	_point(middle + across * 0.0135, normal + 0.4 * across, high)
	_point(tip - across * 0.008, normal - 0.3 * across, high)
	_point(tip + across * 0.008, normal + 0.3 * across, high)
	_indices.append_array([first, first + 2, first + 1, first + 1, first + 2, first + 3])
	_indices.append_array([first + 2, first + 4, first + 3, first + 3, first + 4, first + 5])


func _disc(centre: Vector3, facing: Vector3, right: Vector3, front: Vector3) -> void:
	var top := _point(centre + facing * 0.016, facing, Color(0.82, 0.58, 0.05))
	const SIDES := 12
	for ring in 2:
		for i in SIDES:
			var out := right * cos(TAU * i / SIDES) + front * sin(TAU * i / SIDES)
			var color := Color(0.94, 0.72, 0.08) if ring == 0 else Color(0.8, 0.5, 0.04)
			_point(centre + out * [0.019, 0.031][ring] + facing * [0.015, 0.002][ring], facing + out * [0.4, 1.4][ring], color)
	for i in SIDES:
		var a := top + 1 + i
		var b := top + 1 + (i + 1) % SIDES
		_indices.append_array([top, a, b, a, a + SIDES, b, b, a + SIDES, b + SIDES])


func _cup(centre: Vector3, facing: Vector3, right: Vector3, front: Vector3, color: Color) -> void:
	var low := _point(centre - facing * 0.012, -facing, color.darkened(0.2))
	for i in 8:
		var out := right * cos(TAU * i / 8.0) + front * sin(TAU * i / 8.0)
		_point(centre + out * 0.034 + facing * 0.01, out - facing, color)
	for i in 8:
		_indices.append_array([low, low + 1 + i, low + 1 + (i + 1) % 8])


## One stem of a low bush: twigs all around it, leaves along each of them.
func _grow_small_shrub() -> void:
	var bark := Color(0.3, 0.22, 0.14)
	var twig := Color(0.33, 0.32, 0.14)
	var top := Vector3(0.04, 0.8, 0.02)
	_stalk(Vector3.ZERO, Vector3(0.03, 0.35, -0.01), 0.02, 0.014, bark, bark)
	_stalk(Vector3(0.03, 0.35, -0.01), top, 0.014, 0.007, bark, twig)
	const TWIGS := 13
	for i in TWIGS:
		var t := 0.2 + 0.8 * i / (TWIGS - 1)
		var turn := 2.39996 * i + 0.6
		var out := Vector3(cos(turn), 0.0, sin(turn))
		var from := Vector3(0.03, 0.35, -0.01).lerp(top, (t - 0.44) / 0.56) if t > 0.44 else Vector3(0.03, 0.35, -0.01) * t / 0.44
		var size := lerpf(0.42, 0.2, t) * _dice.randf_range(0.85, 1.1)
		var along := (out * lerpf(1.0, 0.35, t) + Vector3.UP * lerpf(0.55, 1.1, t)).normalized() * size
		_stalk(from, from + along, 0.007, 0.003, twig, twig.lightened(0.1))
		_leaf_twig(from, along, out, t)


func _leaf_twig(from: Vector3, along: Vector3, out: Vector3, height: float) -> void:
	const LEAVES := 11
	for j in LEAVES:
		var t := 0.2 + 0.8 * j / (LEAVES - 1)
		var turn := 2.2 * j + _dice.randf_range(-0.4, 0.4)
		var side := along.normalized().cross(out.cross(Vector3.UP)).normalized().rotated(along.normalized(), turn)
		var way := (side + along.normalized() * (0.6 if j < LEAVES - 1 else 3.0) + Vector3.UP * 0.25).normalized()
		var fresh := clampf(0.3 * t + 0.55 * height + _dice.randf_range(-0.15, 0.15), 0.0, 1.0)
		var color := Color(0.23, 0.32, 0.15).lerp(Color(0.5, 0.58, 0.26), fresh)
		if _dice.randf() < 0.04:
			color = Color(0.52, 0.44, 0.2)
		var size := _dice.randf_range(0.07, 0.1)
		var up := (Vector3.UP + 0.4 * out + 0.3 * along.normalized()).normalized()
		_leaf(from + along * t, way * size, up if absf(way.dot(up)) < 0.95 else out, 0.3 * size, 1, color.darkened(0.08), color, 0.5)

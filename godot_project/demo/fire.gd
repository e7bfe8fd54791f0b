# SPDX-License-Identifier: MIT
## Fire in a GrassField: a grid of cells that heat each other, down the wind most. A cell that burns out leaves stubble, wear and a black
## tint in the field's map. `texture` holds how much burns and how much is charred, for the surface hook demo/fire.gdshaderinc.
extends RefCounted

const SIDE := 0.5  # metres of a cell, as of a texel of the map
const STEP := 0.1  # seconds
const BURNS := 2.5  # seconds that a cell burns
const HEATS := 0.55  # share of the heat that lights a cell, per second, from a burning neighbour in still air
const CARRIES := 0.35  # s/m: how much more a neighbour heats down the wind, per m/s
const LOSES := 0.25  # share of its heat that a cell loses in a second
const STUBBLE := 0.04  # metres
const WEAR := 0.12  # of a cell; neighbours add theirs
const LIT := 1.0  # heat at which the driest cell burns
const DAMP := 0.6  # how much more heat the dampest cell takes

var wind := Vector2.ZERO  # m/s along x, z of the field
var image: Image  # a pixel a cell; r: how much burns, g: how much is charred
var texture: ImageTexture  # of it
var burnt := 0  # cells that have burnt out

var _field: GrassField
var _count: Vector2i
var _heat: PackedFloat32Array
var _needs: PackedFloat32Array  # heat
var _left: PackedFloat32Array  # seconds that a cell goes on burning; -1: not lit yet; 0: burnt out
var _burning: Array[int] = []
var _time := 0.0
var _black := GrassBrush.new()
var _scythe := GrassBrush.new()


func _init(field: GrassField, random_seed := 1) -> void:
	_field = field
	_count = Vector2i((field.size / SIDE).ceil())
	var cells := _count.x * _count.y
	_heat.resize(cells)
	_needs.resize(cells)
	_left.resize(cells)
	_left.fill(-1.0)
	var random := RandomNumberGenerator.new()
	random.seed = random_seed
	for cell in cells:
		_needs[cell] = LIT + DAMP * random.randf()
	image = Image.create_empty(_count.x, _count.y, false, Image.FORMAT_RG8)
	texture = ImageTexture.create_from_image(image)
	for brush: GrassBrush in [_black, _scythe]:
		brush.radius = 0.75 * SIDE
		brush.strength = 1.0
		brush.hardness = 1.0
	_black.tool = GrassBrush.TOOL_TINT
	_black.color = Color(0.06, 0.055, 0.05)
	_black.target = 0.9
	_scythe.tool = GrassBrush.TOOL_CUT
	_scythe.cut_height = STUBBLE
	field.surface_hook = load("res://demo/fire.gdshaderinc")
	field.set_hook_parameter("fire_cells", texture)


## Lights the grass around a global place.
func light(place: Vector3, radius := SIDE) -> void:
	var local := _field.to_local(place)
	var at := Vector2(local.x, local.z)
	for z in _count.y:
		for x in _count.x:
			if _middle(Vector2i(x, z)).distance_to(at) <= radius:
				_burn(z * _count.x + x)


func is_out() -> bool:
	return _burning.is_empty()


func get_burning() -> int:
	return _burning.size()


## Returns whether the cell at a place of the field (x, z) burns or has burnt.
func has_reached(place: Vector2) -> bool:
	var cell := Vector2i(((place + 0.5 * _field.size) / SIDE).floor())
	return Rect2i(Vector2i.ZERO, _count).has_point(cell) and _left[cell.y * _count.x + cell.x] >= 0.0


func advance(delta: float) -> void:
	_time += delta
	while _time >= STEP:
		_time -= STEP
		_step()
	texture.update(image)


func _step() -> void:
	for cell in _burning.duplicate():
		_spread(cell)
		_left[cell] -= STEP
		if _left[cell] <= 0.0:
			_burn_out(cell)
		else:
			_show(cell, minf(1.0, minf(BURNS - _left[cell], _left[cell]) / 0.6), 1.0 - _left[cell] / BURNS)


## Heats the eight neighbours of a burning cell.
func _spread(cell: int) -> void:
	var at := Vector2i(cell % _count.x, cell / _count.x)
	for z in range(maxi(at.y - 1, 0), mini(at.y + 2, _count.y)):
		for x in range(maxi(at.x - 1, 0), mini(at.x + 2, _count.x)):
			var other := z * _count.x + x
			if _left[other] >= 0.0:
				continue
			var way := Vector2(x - at.x, z - at.y)
			var carried := exp(CARRIES * wind.dot(way.normalized()))
			_heat[other] = maxf(_heat[other] + STEP * (HEATS * carried / way.length() - LOSES * _heat[other]), 0.0)
			if _heat[other] >= _needs[other]:
				_burn(other)


func _burn(cell: int) -> void:
	if _left[cell] < 0.0:
		_left[cell] = BURNS
		_burning.append(cell)


func _burn_out(cell: int) -> void:
	_left[cell] = 0.0
	_burning.erase(cell)
	burnt += 1
	_show(cell, 0.0, 1.0)
	var at := _middle(Vector2i(cell % _count.x, cell / _count.x))
	var place := _field.to_global(Vector3(at.x, 0, at.y))
	_field.paint(_scythe, place, place)
	_field.paint(_black, place, place)
	_field.trample(place, 0.75 * SIDE, WEAR)


func _show(cell: int, burns: float, charred: float) -> void:
	image.set_pixel(cell % _count.x, cell / _count.x, Color(burns, charred, 0.0))


## Returns the place of a cell in the field (x, z).
func _middle(cell: Vector2i) -> Vector2:
	return (Vector2(cell) + Vector2(0.5, 0.5)) * SIDE - 0.5 * _field.size

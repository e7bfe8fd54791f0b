# SPDX-License-Identifier: MIT
## A path that feet have worn into grass: bare in its middle, but for some tufts; sparse and low beside that. Nowhere is it as wide as
## elsewhere. What is worn at a place depends on the place alone, so that fields side by side show one path.
extends RefCounted

const STEP := 0.6  # metres from one point to the next
const BENDS := 0.05  # radians in which a path that goes on turns at a step, at most
const BEND_LENGTH := 25.0  # metres
const LEAST := 0.1  # metres, of a brush's radius
const SPOTS := 0.35  # share of the steps beside which a foot has torn out some grass; tufts are as frequent

var points := PackedVector2Array()  ## STEP apart, metres
var width := 1.9  ## metres
var fade := 0.0  ## metres before its end in which it gets lost; 0: it does not
var species := 0  ## what grows beside it, as a brush counts it; 0: the mix

var _noise := FastNoiseLite.new()
var _brush := GrassBrush.new()
var _map: GrassMap
var _middle := Vector2.ZERO  # of the map


func _init() -> void:
	_noise.frequency = 1.0


## Returns the two paths that go on for `length` metres from the ends of a curve, and get lost in their second half.
static func beyond(curve: Curve3D, length: float) -> Array:
	var inside := points_of(curve)
	var paths := []
	for side in 2:
		var path := new()
		path.fade = 0.5 * length
		path._go_on(inside[-1], (inside[-1] - inside[-4]).normalized(), length)
		paths.append(path)
		inside.reverse()
	return paths


## Returns the points of a curve, seen from above.
static func points_of(curve: Curve3D) -> PackedVector2Array:
	var found := PackedVector2Array()
	var length := curve.get_baked_length()
	for i in int(length / STEP) + 1:
		var point := curve.sample_baked(minf(i * STEP, length))
		found.append(Vector2(point.x, point.z))
	return found


## Wears as much of it into a map as lies in `area`, whose middle is that of the map.
func wear(map: GrassMap, area: Rect2) -> void:
	_map = map
	_middle = area.get_center()
	var near := area.grow(2.0 * width)
	var left := STEP * points.size()
	for i in range(1, points.size()):
		left -= STEP
		if near.has_point(points[i]):
			_wear(points[i - 1], points[i], minf(left / fade, 1.0) if fade > 0.0 else 1.0)


func _go_on(from: Vector2, along: Vector2, length: float) -> void:
	points.append(from)
	for i in int(length / STEP):
		along = along.rotated(BENDS * _noise.get_noise_2dv(points[-1] / BEND_LENGTH))
		points.append(points[-1] + STEP * along)


## One step of it; worn: how much of it is there, 0 to 1.
func _wear(from: Vector2, to: Vector2, worn: float) -> void:
	var wide := width * (0.4 + 0.6 * worn) * (1.0 + 0.45 * _noise.get_noise_2dv(0.2 * to))
	var across := (to - from).orthogonal().normalized() * wide
	var fine := _noise.get_noise_2dv(0.9 * to)
	var aside := across * 0.4 * _noise.get_noise_2dv(0.5 * to + Vector2(0.0, 70.0))
	if species > 0:
		_stroke(GrassBrush.TOOL_SPECIES, from, to, (1.9 + 0.6 * fine) * wide, {species = species, strength = 1.0})
	_stroke(GrassBrush.TOOL_HEIGHT, from, to, (1.7 + 0.5 * fine) * wide, {target = lerpf(0.8, 0.4, worn), strength = 0.25, hardness = 0.0})
	_stroke(GrassBrush.TOOL_DENSITY, from + aside, to + aside, (0.85 + 0.35 * fine) * wide, {target = 0.3, strength = 0.3 * worn})
	_stroke(GrassBrush.TOOL_ERASE, from + aside, to + aside, (0.5 + 0.25 * fine) * wide, {strength = 0.55 * worn})
	var random := RandomNumberGenerator.new()
	random.seed = hash(Vector2i(20.0 * to))
	var beside := to + across * random.randf_range(0.5, 1.0) * (1.0 if random.randf() < 0.5 else -1.0)
	var within := to + aside + across * random.randf_range(-0.5, 0.5)
	if random.randf() < SPOTS * worn:
		_stroke(GrassBrush.TOOL_ERASE, beside, beside, random.randf_range(0.15, 0.4) * wide, {strength = 0.8})
	if random.randf() < SPOTS:
		_stroke(GrassBrush.TOOL_PAINT, within, within, random.randf_range(0.12, 0.25) * wide, {strength = 0.5})


func _stroke(tool: GrassBrush.Tool, from: Vector2, to: Vector2, radius: float, properties: Dictionary) -> void:
	_brush.tool = tool
	_brush.radius = maxf(radius, LEAST)
	_brush.hardness = 0.3
	for property: String in properties:
		_brush.set(property, properties[property])
	_map.stroke(_brush, from - _middle, to - _middle)
